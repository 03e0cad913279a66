// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/questionnaire_editor.h"

#include "app/console/study/forms/form_text.h"
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
    , m_rows(new QVBoxLayout) {
    setObjectName(QStringLiteral("questionnaireEditor"));
    m_id->setPlaceholderText(tr("for example effort"));
    m_when->addItems({tr("before the first session"), tr("before each session"), tr("after each session"),
                      tr("after the last session")});
    m_when->setCurrentIndex(static_cast<int>(questionnaire.when));

    auto* form = new QFormLayout;
    form->addRow(tr("Identifier"), m_id);
    form->addRow(tr("Title"), m_title);
    form->addRow(tr("Filled in"), m_when);
    auto* add = base::named<QPushButton>("addQuestion", tr("Add a question"), this);
    auto* remove = base::named<QPushButton>("removeQuestionnaire", tr("Remove this questionnaire"), this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addLayout(m_rows);
    layout->addLayout(buttons);

    connect(add, &QPushButton::clicked, this, [this] {
        addItem({});
        m_items.back().id->setFocus();
        emit changed();
    });
    connect(remove, &QPushButton::clicked, this, &QuestionnaireEditor::removeRequested);
    for (QLineEdit* edit : {m_id, m_title})
        connect(edit, &QLineEdit::textChanged, this, &QuestionnaireEditor::changed);
    connect(m_when, &QComboBox::currentIndexChanged, this, &QuestionnaireEditor::changed);
    for (const study::QuestionnaireItem& item : questionnaire.items)
        addItem(item);
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
    row.kind->addItems({tr("free text"), tr("scale"), tr("one of several answers")});
    row.kind->setCurrentIndex(static_cast<int>(item.kind));
    row.required->setChecked(item.required);
    row.question->setObjectName(QStringLiteral("questionText"));
    row.points->setRange(kFewestPoints, kMostPoints);
    row.points->setValue(static_cast<int>(item.points));
    row.points->setSuffix(tr(" points", "after a number"));
    row.low->setPlaceholderText(tr("what 1 means"));
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
        form->setRowVisible(row.scale, kind == study::ItemKind::likert);
        form->setRowVisible(row.choices, kind == study::ItemKind::choice);
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
    for (const ItemRow& row : m_items) {
        study::QuestionnaireItem item;
        item.id = entered(*row.id);
        item.kind = static_cast<study::ItemKind>(row.kind->currentIndex());
        item.question = entered(*row.question);
        item.required = row.required->isChecked();
        item.points = static_cast<std::size_t>(row.points->value());
        item.low = entered(*row.low);
        item.high = entered(*row.high);
        if (item.kind == study::ItemKind::choice) {
            for (const auto& [id, shown] : firstWords(row.choices->toPlainText()))
                item.choices.push_back({id.toStdString(), shown.toStdString()});
        }
        made.items.push_back(std::move(item));
    }
    return made;
}

} // namespace teleta::console
