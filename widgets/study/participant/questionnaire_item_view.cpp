// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/questionnaire_item_view.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/participant/answer_keys.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

constexpr double kTarget_em = 2.4; ///< a finger's, in the large font of a form
constexpr double kMark_em = 1.2;   ///< narrower, since arrows correct a neighbouring mark
constexpr std::size_t kMarksOfADigit = 2;

/// Its whole line can be pressed, not only its text.
class ChoiceButton : public QRadioButton {
public:
    using QRadioButton::QRadioButton;

protected:
    [[nodiscard]] bool hitButton(const QPoint& at) const override { return rect().contains(at); }
};

bool isPlain(const QKeyEvent& event) {
    return !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

QLabel* textLabel(const std::string& text, QWidget* parent) {
    auto* label = new QLabel(QString::fromStdString(text), parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

} // namespace

QuestionnaireItemView::QuestionnaireItemView(QuestionnaireItem item, QWidget* parent)
    : QWidget(parent)
    , m_item(std::move(item))
    , m_question(textLabel(m_item.question, this))
    , m_problem(textLabel({}, this)) {
    setObjectName(QString::fromStdString(m_item.id));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, base::grid(this, 2));
    column->setSpacing(base::grid(this));
    m_question->setFont(base::bold(font()));
    column->addWidget(m_question);
    switch (m_item.kind) {
    case ItemKind::text:
        m_text = new QPlainTextEdit(this);
        m_text->setTabChangesFocus(true);
        m_text->setFixedHeight(base::em(this, 4.5));
        connect(m_text, &QPlainTextEdit::textChanged, this, &QuestionnaireItemView::changed);
        column->addWidget(m_text);
        break;
    case ItemKind::likert:
        buildPoints(column);
        break;
    case ItemKind::choice:
        buildChoices(column);
        break;
    case ItemKind::scale:
        buildScale(column);
        break;
    case ItemKind::pair:
        buildPair(column);
        break;
    }
    column->addWidget(m_problem);
    m_problem->hide();
    base::keepTranslated(this, &QuestionnaireItemView::retranslate);
    base::onChange(this, &QuestionnaireItemView::colour, {QEvent::PaletteChange});
    colour();
}

void QuestionnaireItemView::addButton(QAbstractButton* button, std::string value) {
    button->setMinimumHeight(base::em(this, kTarget_em));
    button->setCheckable(true);
    button->setAutoExclusive(true);
    connect(button, &QAbstractButton::toggled, this, [this](bool checked) {
        colour();
        if (checked)
            emit changed();
    });
    m_buttons.push_back(button);
    m_values.push_back(std::move(value));
}

void QuestionnaireItemView::buildPoints(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(base::grid(this, 0.5));
    for (std::size_t point = 1; point <= m_item.points; ++point) {
        auto* button = new QPushButton(QString::number(point), this);
        button->setMinimumWidth(base::em(this, kTarget_em));
        addButton(button, std::to_string(point));
        row->addWidget(button, 1);
    }
    addNoAnswer(row);
    column->addLayout(row);
    addEnds(column);
}

/// Marks without numbers, as the published scale has them.
void QuestionnaireItemView::buildScale(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    for (std::size_t point = 0; point < kScalePoints; ++point) {
        const std::size_t value = point * kScaleStep;
        auto* button = new QPushButton(this);
        button->setMinimumWidth(base::em(this, kMark_em));
        button->setToolTip(QString::number(value));
        addButton(button, std::to_string(value));
        row->addWidget(button, 1);
    }
    addNoAnswer(row);
    column->addLayout(row);
    addEnds(column);
}

void QuestionnaireItemView::buildPair(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(base::grid(this, 2));
    std::size_t number = 0;
    for (const ItemChoice& choice : m_item.choices) {
        auto* button = new QPushButton(
            QStringLiteral("%1   %2").arg(++number).arg(QString::fromStdString(choice.text)), this);
        button->setAccessibleName(QString::fromStdString(choice.text));
        addButton(button, choice.id);
        row->addWidget(button, 1);
    }
    addNoAnswer(row);
    column->addLayout(row);
}

/// The last button of an optional item.
void QuestionnaireItemView::addNoAnswer(QHBoxLayout* row) {
    if (m_item.required)
        return;
    row->addSpacing(base::grid(this, 2));
    auto* none = new QPushButton(this);
    addButton(none, {});
    row->addWidget(none);
}

/// What the ends of a scale mean.
void QuestionnaireItemView::addEnds(QVBoxLayout* column) {
    if (m_item.low.empty() && m_item.high.empty())
        return;
    auto* ends = new QHBoxLayout;
    QLabel* high = textLabel("\u2192 " + m_item.high, this);
    high->setAlignment(Qt::AlignRight);
    ends->addWidget(textLabel(m_item.low + " \u2190", this), 1);
    ends->addWidget(high, 1);
    column->addLayout(ends);
}

void QuestionnaireItemView::buildChoices(QVBoxLayout* column) {
    std::size_t number = 0;
    for (const ItemChoice& choice : m_item.choices) {
        auto* button = new ChoiceButton(
            QStringLiteral("%1   %2").arg(++number).arg(QString::fromStdString(choice.text)), this);
        button->setAccessibleName(QString::fromStdString(choice.text));
        addButton(button, choice.id);
        column->addWidget(button);
    }
    if (!m_item.required) {
        auto* none = new ChoiceButton(this);
        addButton(none, {});
        column->addWidget(none);
    }
}

std::optional<std::string> QuestionnaireItemView::value() const {
    if (m_text != nullptr) {
        const QString text = m_text->toPlainText().trimmed();
        return text.isEmpty() ? std::nullopt : std::optional(text.toStdString());
    }
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        if (m_buttons[i]->isChecked() && !m_values[i].empty())
            return m_values[i];
    }
    return std::nullopt;
}

void QuestionnaireItemView::setValue(const std::optional<std::string>& value) {
    if (m_text != nullptr)
        m_text->setPlainText(QString::fromStdString(value.value_or(std::string())));
    const auto at = std::find(m_values.begin(), m_values.end(), value.value_or(std::string()));
    if (at != m_values.end())
        m_buttons[static_cast<std::size_t>(at - m_values.begin())]->setChecked(true);
}

void QuestionnaireItemView::setProblem(const QString& problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void QuestionnaireItemView::focusAnswer() {
    if (m_text != nullptr) {
        m_text->setFocus(Qt::TabFocusReason);
        return;
    }
    const auto chosen = std::find_if(m_buttons.begin(), m_buttons.end(),
                                     [](const QAbstractButton* button) { return button->isChecked(); });
    (chosen == m_buttons.end() ? m_buttons.front() : *chosen)->setFocus(Qt::TabFocusReason);
}

bool QuestionnaireItemView::takeFirstKey(QKeyEvent& key) {
    if (m_text == nullptr)
        return choose(key);
    if (key.text().trimmed().isEmpty() || !isPlain(key))
        return false;
    focusAnswer();
    QCoreApplication::sendEvent(m_text, &key);
    return true;
}

bool QuestionnaireItemView::choose(const QKeyEvent& event) {
    if (!isPlain(event))
        return false;
    const bool isScale = m_item.kind == ItemKind::scale;
    const std::optional<PhysicalKey> key = physicalKey(event);
    std::size_t place = 0;
    if (key && key->number >= 1)
        place = isScale ? key->number * kMarksOfADigit : key->number - 1;
    else if (!isScale || event.key() != Qt::Key_0)
        return false;
    if (place >= m_buttons.size() || m_values[place].empty())
        return false;
    m_buttons[place]->setChecked(true);
    m_buttons[place]->setFocus(Qt::TabFocusReason);
    return true;
}

void QuestionnaireItemView::keyPressEvent(QKeyEvent* event) {
    // A digit still held down may be the answer to the last trial.
    if (event->isAutoRepeat() || !choose(*event))
        QWidget::keyPressEvent(event);
}

/// The chosen number has to be visible from afar.
void QuestionnaireItemView::colour() {
    for (QAbstractButton* button : m_buttons) {
        if (m_item.kind == ItemKind::choice)
            continue;
        QPalette colours = palette();
        if (button->isChecked()) {
            colours.setColor(QPalette::Button, palette().color(QPalette::Highlight));
            colours.setColor(QPalette::ButtonText, palette().color(QPalette::HighlightedText));
        }
        button->setPalette(colours);
    }
    base::setTextColour(m_problem, base::statusColours(palette()).lost);
}

void QuestionnaireItemView::retranslate() {
    const QString question = QString::fromStdString(m_item.question);
    m_question->setText(m_item.required ? question : tr("%1 (optional)", "a question").arg(question));
    if (m_text != nullptr)
        m_text->setAccessibleName(question);
    if (!m_item.required && !m_buttons.empty())
        m_buttons.back()->setText(tr("No answer"));
    if (m_item.kind == ItemKind::scale) {
        for (std::size_t i = 0; i < kScalePoints; ++i)
            m_buttons[i]->setAccessibleName(
                tr("%1: %2 of %3", "question, point, points").arg(question).arg(i * kScaleStep).arg(100));
    }
    if (m_item.kind != ItemKind::likert)
        return;
    for (std::size_t i = 0; i < m_item.points; ++i)
        m_buttons[i]->setAccessibleName(
            tr("%1: %2 of %3", "question, point, points").arg(question).arg(i + 1).arg(m_item.points));
}

} // namespace teleta::study
