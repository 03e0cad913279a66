// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/questionnaire_editor.h"

#include "app/console/study/forms/form_text.h"
#include "backend/study/protocol/standard_questionnaire.h"
#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <utility>

namespace teleta::console {

namespace {

constexpr int kFewestPoints = 2;
constexpr int kMostPoints = 11;
constexpr double kChoiceLines_em = 5.0;

QString entryOf(const std::string& value) {
    return QString::fromStdString(value);
}

std::string entered(const QLineEdit& edit) {
    return edit.text().trimmed().toStdString();
}

} // namespace

QuestionnaireEditor::QuestionnaireEditor(const study::Questionnaire& questionnaire, QWidget* parent)
    : QGroupBox(tr("Questionnaire"), parent)
    , m_id(base::named<QLineEdit>("questionnaireId", entryOf(questionnaire.id), this))
    , m_title(base::named<QLineEdit>("questionnaireTitle", entryOf(questionnaire.title), this))
    , m_when(base::named<QComboBox>("questionnaireWhen", this))
    , m_use(base::named<QComboBox>("questionnaireUse", this))
    , m_required(
          base::named<QCheckBox>("questionnaireRequired", tr("all questions have to be answered"), this))
    , m_add(base::named<QPushButton>("addQuestion", tr("Add a question"), this))
    , m_form(new QFormLayout)
    , m_rows(new QVBoxLayout) {
    setObjectName(QStringLiteral("questionnaireEditor"));
    m_id->setPlaceholderText(tr("for example effort"));
    m_when->addItems({tr("before the first session"), tr("before each session"), tr("after each session"),
                      tr("after the last session")});
    m_when->setCurrentIndex(static_cast<int>(questionnaire.when));

    m_use->addItems({tr("of my own"), tr("NASA-TLX: six ratings"), tr("NASA-TLX: ratings and comparisons"),
                     tr("System Usability Scale")});
    m_use->setCurrentIndex(static_cast<int>(questionnaire.use));
    m_required->setChecked(questionnaire.items.empty() || questionnaire.items.front().required);

    m_form->addRow(tr("Identifier"), m_id);
    m_form->addRow(tr("Questions"), m_use);
    m_form->addRow(QString(), m_required);
    m_form->addRow(tr("Title"), m_title);
    m_form->addRow(tr("Filled in"), m_when);
    auto* remove = base::named<QPushButton>("removeQuestionnaire", tr("Remove this questionnaire"), this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_add);
    buttons->addWidget(remove);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_form);
    layout->addLayout(m_rows);
    layout->addLayout(buttons);

    connect(m_add, &QPushButton::clicked, this, [this] {
        addItem({});
        m_items.back().id->setFocus();
        emit changed();
    });
    connect(remove, &QPushButton::clicked, this, &QuestionnaireEditor::removeRequested);
    for (QLineEdit* edit : {m_id, m_title})
        connect(edit, &QLineEdit::textChanged, this, &QuestionnaireEditor::changed);
    connect(m_when, &QComboBox::currentIndexChanged, this, &QuestionnaireEditor::changed);
    connect(m_required, &QCheckBox::toggled, this, &QuestionnaireEditor::changed);
    connect(m_use, &QComboBox::currentIndexChanged, this, [this] {
        showUse();
        emit changed();
    });
    if (questionnaire.use == study::StandardQuestionnaire::none) {
        for (const study::QuestionnaireItem& item : questionnaire.items)
            addItem(item);
    }
    showUse();
}

/// Questions of one's own are hidden, and kept until the form is closed, while a published one is chosen.
void QuestionnaireEditor::showUse() {
    const bool own = m_use->currentIndex() == 0;
    m_form->setRowVisible(m_title, own);
    m_form->setRowVisible(m_required, !own);
    m_add->setVisible(own);
    for (const ItemRow& row : m_items)
        row.box->setVisible(own);
}

void QuestionnaireEditor::addItem(const study::QuestionnaireItem& item) {
    auto* box = new QWidget(this);
    const ItemRow row{box,
                      new QLineEdit(entryOf(item.id), box),
                      new QComboBox(box),
                      new QCheckBox(tr("required"), box),
                      new QLineEdit(entryOf(item.question), box),
                      new QWidget(box),
                      new QSpinBox(box),
                      new QLineEdit(entryOf(item.low), box),
                      new QLineEdit(entryOf(item.high), box),
                      new QPlainTextEdit(box)};
    row.id->setObjectName(QStringLiteral("questionId"));
    row.id->setPlaceholderText(tr("for example hard"));
    row.kind->setObjectName(QStringLiteral("questionKind"));
    row.kind->addItems({tr("free text"), tr("scale"), tr("one of several answers"), tr("scale from 0 to 100"),
                        tr("one of two answers")});
    row.kind->setCurrentIndex(static_cast<int>(item.kind));
    row.required->setChecked(item.required);
    row.question->setObjectName(QStringLiteral("questionText"));
    row.points->setRange(kFewestPoints, kMostPoints);
    row.points->setValue(static_cast<int>(item.points));
    row.points->setSuffix(tr(" points", "after a number"));
    row.low->setPlaceholderText(tr("what the first point means"));
    row.high->setPlaceholderText(tr("what the last point means"));
    QStringList choices;
    for (const study::ItemChoice& choice : item.choices)
        choices << entryOf(choice.id) + QLatin1Char(' ') + entryOf(choice.text);
    row.choices->setObjectName(QStringLiteral("questionChoices"));
    row.choices->setPlainText(choices.join(QLatin1Char('\n')));
    row.choices->setPlaceholderText(tr("identifier and text, one per line, for example yes I felt it"));
    row.choices->setTabChangesFocus(true);
    row.choices->setFixedHeight(base::em(this, kChoiceLines_em));

    auto* scale = new QHBoxLayout(row.scale);
    scale->setContentsMargins(0, 0, 0, 0);
    scale->addWidget(row.points);
    scale->addWidget(row.low, 1);
    scale->addWidget(row.high, 1);
    auto* remove = new QPushButton(tr("Remove"), box);
    remove->setAccessibleName(tr("Remove this question"));
    auto* head = new QHBoxLayout;
    head->addWidget(row.id, 1);
    head->addWidget(row.kind);
    head->addWidget(row.required);
    head->addWidget(remove);
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Question"), row.question);
    form->addRow(tr("Identifier"), head);
    form->addRow(tr("Scale"), row.scale);
    form->addRow(tr("Answers"), row.choices);

    const auto showKind = [form, row] {
        const auto kind = static_cast<study::ItemKind>(row.kind->currentIndex());
        const bool points = kind == study::ItemKind::likert;
        form->setRowVisible(row.scale, points || kind == study::ItemKind::scale);
        row.points->setVisible(points);
        form->setRowVisible(row.choices, kind == study::ItemKind::choice || kind == study::ItemKind::pair);
    };
    connect(remove, &QPushButton::clicked, this, [this, box] { removeItem(box); });
    connect(row.kind, &QComboBox::currentIndexChanged, this, [this, showKind] {
        showKind();
        emit changed();
    });
    for (QLineEdit* edit : {row.id, row.question, row.low, row.high})
        connect(edit, &QLineEdit::textChanged, this, &QuestionnaireEditor::changed);
    connect(row.choices, &QPlainTextEdit::textChanged, this, &QuestionnaireEditor::changed);
    showKind();
    m_items.push_back(row);
    m_rows->addWidget(box);
}

void QuestionnaireEditor::removeItem(const QWidget* box) {
    for (const ItemRow& row : m_items) {
        if (row.box == box) {
            row.box->hide();
            row.box->deleteLater();
        }
    }
    std::erase_if(m_items, [box](const ItemRow& row) { return row.box == box; });
    emit changed();
}

study::Questionnaire QuestionnaireEditor::questionnaire() const {
    study::Questionnaire made;
    made.id = entered(*m_id);
    made.title = m_title->text().trimmed().isEmpty() ? made.id : entered(*m_title);
    made.when = static_cast<study::QuestionnaireTime>(m_when->currentIndex());
    made.use = static_cast<study::StandardQuestionnaire>(m_use->currentIndex());
    if (made.use != study::StandardQuestionnaire::none) {
        study::Questionnaire standard = study::standardQuestionnaire(made.use, m_required->isChecked());
        standard.id = made.id;
        standard.when = made.when;
        return standard;
    }
    for (const ItemRow& row : m_items) {
        study::QuestionnaireItem item;
        item.id = entered(*row.id);
        item.kind = static_cast<study::ItemKind>(row.kind->currentIndex());
        item.question = entered(*row.question);
        item.required = row.required->isChecked();
        item.points = static_cast<std::size_t>(row.points->value());
        item.low = entered(*row.low);
        item.high = entered(*row.high);
        if (item.kind == study::ItemKind::choice || item.kind == study::ItemKind::pair) {
            for (const auto& [id, shown] : firstWords(row.choices->toPlainText()))
                item.choices.push_back({id.toStdString(), shown.toStdString()});
        }
        made.items.push_back(std::move(item));
    }
    return made;
}

} // namespace teleta::console
