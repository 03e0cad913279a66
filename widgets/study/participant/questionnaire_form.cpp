// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/participant/questionnaire_form.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/participant/questionnaire_item_view.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::study {

namespace {

constexpr double kWidest_em = 52.0; ///< longer lines are hard to read

} // namespace

QuestionnaireForm::QuestionnaireForm(QWidget* parent)
    : QWidget(parent) {
    m_area->setWidgetResizable(true);
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setFocusPolicy(Qt::NoFocus);
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);
    m_problem->hide();
    m_done->setMinimumHeight(base::em(this, 3.6));
    m_done->setMinimumWidth(base::em(this, 14));
    m_done->setFont(base::sized(font(), base::kLargeText));
    m_done->setAutoDefault(true);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_count, 1);
    foot->addWidget(m_done);
    m_column = new QWidget(this);
    auto* column = new QVBoxLayout(m_column);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_area, 1);
    column->addWidget(m_problem);
    column->addLayout(foot);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addStretch(1);
    layout->addWidget(m_column, 1000);
    layout->addStretch(1);
    connect(m_done, &QPushButton::clicked, this, &QuestionnaireForm::submit);
    base::keepTranslated(this, &QuestionnaireForm::retranslate);
}

void QuestionnaireForm::setQuestionnaire(Questionnaire questionnaire,
                                         const std::vector<ItemAnswer>& answers) {
    m_questionnaire = std::move(questionnaire);
    m_items.clear();
    auto* page = new QWidget;
    page->setFont(base::sized(font(), base::kLargeText));
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, base::grid(this, 2), 0);
    for (const QuestionnaireItem& item : m_questionnaire.items) {
        auto* view = new QuestionnaireItemView(item, page);
        const auto given = std::find_if(answers.begin(), answers.end(),
                                        [&](const auto& answer) { return answer.item == item.id; });
        if (given != answers.end())
            view->setValue(given->value);
        connect(view, &QuestionnaireItemView::changed, this, [this, view] {
            view->setProblem({});
            showCount();
        });
        column->addWidget(view);
        m_items.push_back(view);
    }
    column->addStretch(1);
    m_column->setMaximumWidth(base::em(page, kWidest_em));
    m_area->setWidget(page);
    // The ground of a stopped session shows behind the questions as well.
    page->setAutoFillBackground(false);
    m_area->viewport()->setAutoFillBackground(false);
    setProblem({});
    showCount();
}

void QuestionnaireForm::setLocked(bool locked) {
    for (QuestionnaireItemView* item : m_items)
        item->setEnabled(!locked);
    m_done->setEnabled(!locked);
}

void QuestionnaireForm::setProblem(const QString& problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    base::setTextColour(m_problem, base::statusColours(palette()).lost);
}

void QuestionnaireForm::takeKeyboard() {
    setFocus(Qt::OtherFocusReason);
}

std::vector<ItemAnswer> QuestionnaireForm::answers() const {
    std::vector<ItemAnswer> answers;
    for (const QuestionnaireItemView* item : m_items)
        answers.push_back({item->item().id, item->value()});
    return answers;
}

void QuestionnaireForm::submit() {
    const std::vector<ItemAnswer> given = answers();
    const core::Expected<void> fits = checkAnswers(m_questionnaire, given);
    if (fits) {
        emit submitted(given);
        return;
    }
    for (QuestionnaireItemView* item : m_items) {
        if (item->item().id != fits.error().where.file)
            continue;
        item->setProblem(item->value() ? tr("This answer is not valid: %1.", "what is expected")
                                             .arg(QString::fromStdString(fits.error().expected))
                                       : tr("Please answer this question."));
        m_area->ensureWidgetVisible(item);
        item->focusAnswer();
    }
}

void QuestionnaireForm::showCount() {
    const auto answered =
        std::count_if(m_items.begin(), m_items.end(), [](const auto* item) { return item->value(); });
    m_count->setText(tr("%1 of %2 answered").arg(answered).arg(m_items.size()));
}

void QuestionnaireForm::keyPressEvent(QKeyEvent* event) {
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const bool isLocked = !m_done->isEnabled();
    if (isReturn && event->modifiers().testFlag(Qt::ControlModifier) && !event->isAutoRepeat() && !isLocked) {
        submit();
        return;
    }
    const bool isFirst =
        hasFocus() && !isLocked && !event->isAutoRepeat() && !m_items.empty() && !m_items.front()->value();
    if (!isFirst || !m_items.front()->takeFirstKey(*event))
        QWidget::keyPressEvent(event);
}

bool QuestionnaireForm::focusNextPrevChild(bool next) {
    if (!hasFocus() || !next || m_items.empty() || !m_items.front()->isEnabled())
        return QWidget::focusNextPrevChild(next);
    m_items.front()->focusAnswer();
    return true;
}

void QuestionnaireForm::retranslate() {
    m_done->setText(tr("&Done"));
    m_done->setToolTip(tr("Submits the answers (Ctrl+Return)"));
    showCount();
}

} // namespace teleta::study
