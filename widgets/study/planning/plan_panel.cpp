// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/planning/plan_panel.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/planning/threshold_form.h"
#include "widgets/study/results/curve_view.h"
#include "widgets/study/study_names.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace teleta::study {

namespace {

constexpr int kMostInForm = 200;
constexpr int kTestStudies = 10'000;
constexpr int kThresholdStudies = 1000;
/// The most studies of a threshold that are drawn to decide between two numbers, as in teleta study plan.
constexpr std::size_t kMostThresholdStudies = 4000;
constexpr double kPercentOf = 100.0;
constexpr double kUsualShare = 70.0;
constexpr double kUsualTarget = 90.0;
constexpr double kUsualParticipantSd = 0.5;
constexpr double kUsualConditionSd = 0.2;

} // namespace

PlanPanel::PlanPanel(QWidget* parent)
    : QWidget(parent)
    , m_threshold(base::named<ThresholdForm>("planThresholdForm", this))
    , m_curve(base::named<CurveView>("planCurve", this)) {
    for (QDoubleSpinBox* spread : {m_participantSd, m_conditionSd}) {
        spread->setRange(0.0, 5.0);
        spread->setSingleStep(0.1);
        spread->setDecimals(2);
    }
    m_participantSd->setValue(kUsualParticipantSd);
    m_conditionSd->setValue(kUsualConditionSd);
    for (QSpinBox* number : {m_from, m_to})
        number->setRange(2, kMostInForm);
    m_step->setRange(1, kMostInForm);
    m_from->setValue(6);
    m_to->setValue(30);
    m_step->setValue(2);
    m_target_percent->setRange(1.0, 99.9);
    m_target_percent->setDecimals(1);
    m_target_percent->setValue(kUsualTarget);
    m_target_percent->setSuffix(QStringLiteral(" %"));
    for (const int studies : {kThresholdStudies, kTestStudies, 40'000})
        m_studies->addItem(QString(), studies);
    m_studies->setCurrentIndex(1);

    auto* range = new QHBoxLayout;
    base::addWidgets(range, {m_from, m_to, m_step});
    auto* sources = new QHBoxLayout;
    base::addWidgets(sources, {m_file, m_pilot, m_own});
    sources->addStretch(1);
    // Closer than the two halves of the page, whose distance they would take.
    for (QFormLayout* form : {m_form, m_shares}) {
        form->setHorizontalSpacing(base::grid(this, 2));
        form->setVerticalSpacing(base::grid(this));
    }
    range->setSpacing(base::grid(this));
    sources->setSpacing(base::grid(this));
    m_form->addRow(m_testLabel, m_test);
    m_form->addRow(m_shares);
    m_form->addRow(m_threshold);
    m_form->addRow(m_participantLabel, m_participantSd);
    m_form->addRow(m_conditionLabel, m_conditionSd);
    m_form->addRow(m_sourceLabel);
    m_form->addRow(sources);
    m_form->addRow(m_rangeLabel, range);
    m_form->addRow(m_targetLabel, m_target_percent);
    m_form->addRow(m_studiesLabel, m_studies);
    for (QLabel* label : {m_sourceLabel, m_answer}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_answer->setFont(base::bold(base::sized(m_answer->font(), base::kTitleText)));
    m_start->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(base::grid(this));
    base::addWidgets(buttons, {m_start, m_cancel});
    buttons->addWidget(m_progress, 1);
    auto* left = new QVBoxLayout;
    left->setSpacing(base::grid(this, 2));
    left->addLayout(m_form);
    left->addLayout(buttons);
    left->addWidget(m_answer);
    left->addStretch(1);
    auto* layout = new QHBoxLayout(this);
    const int margin = base::grid(this, 2);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(this, 3));
    layout->addLayout(left, 2);
    layout->addWidget(m_curve, 3);

    m_testLabel->setBuddy(m_test);
    m_participantLabel->setBuddy(m_participantSd);
    m_conditionLabel->setBuddy(m_conditionSd);
    m_rangeLabel->setBuddy(m_from);
    m_targetLabel->setBuddy(m_target_percent);
    m_studiesLabel->setBuddy(m_studies);
    m_progress->setRange(0, 1000);
    connect(m_start, &QPushButton::clicked, this, &PlanPanel::planRequested);
    connect(m_cancel, &QPushButton::clicked, this, &PlanPanel::cancelRequested);
    connect(m_file, &QPushButton::clicked, this, &PlanPanel::truthFileRequested);
    connect(m_pilot, &QPushButton::clicked, this, &PlanPanel::pilotRequested);
    connect(m_own, &QPushButton::clicked, this, [this] { setTruth({}, {}); });
    connect(m_test, &QComboBox::currentIndexChanged, this, &PlanPanel::showConditions);
    connect(m_curve, &CurveView::exportFailed, this, &PlanPanel::figureFailed);
    base::keepTranslated(this, &PlanPanel::retranslate);
}

const StudyTask* PlanPanel::task() const {
    const std::vector<PlanTest> tests = PlanContent::tests(m_protocol);
    const int index = m_test->currentIndex();
    return index >= 0 && static_cast<std::size_t>(index) < tests.size()
               ? &m_protocol.tasks[tests[static_cast<std::size_t>(index)].task]
               : nullptr;
}

bool PlanPanel::isOfThreshold() const {
    const StudyTask* chosen = task();
    return chosen != nullptr && chosen->design != Design::identification;
}

void PlanPanel::setProtocol(const Protocol& protocol) {
    if (protocolText(protocol) == protocolText(m_protocol))
        return;
    m_protocol = protocol;
    setTruth({}, {});
    m_answer->clear();
    m_isPlanned = false;
    retranslate();
}

void PlanPanel::setTruth(const StudyTruth& truth, const QString& source) {
    m_truth = source.isEmpty() ? std::nullopt : std::optional(truth);
    m_source = source;
    showSource();
}

std::optional<PlanRequest> PlanPanel::request() const {
    const StudyTask* chosen = task();
    if (chosen == nullptr)
        return std::nullopt;
    PlanRequest request;
    request.test = m_test->currentData().toString();
    for (int n = m_from->value(); n <= m_to->value(); n += m_step->value())
        request.settings.participants.push_back(static_cast<std::size_t>(n));
    if (request.settings.participants.empty())
        return std::nullopt;
    request.settings.studies = static_cast<std::size_t>(m_studies->currentData().toInt());
    request.settings.target = m_target_percent->value() / kPercentOf;
    if (isOfThreshold()) {
        request.wish = m_threshold->wish();
        request.settings.mostStudies = std::max(kMostThresholdStudies, request.settings.studies);
        if (!m_truth)
            request.truth.tasks.push_back(m_threshold->truth());
    }
    if (m_truth)
        request.truth = *m_truth;
    if (m_truth || isOfThreshold())
        return request;
    TaskTruth assumed;
    assumed.id = chosen->id;
    assumed.participantSd = m_participantSd->value();
    assumed.participantConditionSd = m_conditionSd->value();
    for (std::size_t i = 0; i < chosen->conditions.size(); ++i)
        assumed.conditions.push_back({chosen->conditions[i], m_share_percent[i]->value() / kPercentOf, {}});
    request.truth.tasks.push_back(std::move(assumed));
    return request;
}

/// A share for each condition of the chosen task. Shares that were filled in stay with their conditions.
void PlanPanel::showConditions() {
    const StudyTask* chosen = task();
    const std::size_t wanted = chosen == nullptr || isOfThreshold() ? 0 : chosen->conditions.size();
    while (m_share_percent.size() > wanted) {
        m_shares->removeRow(static_cast<int>(m_share_percent.size()) - 1);
        m_share_percent.pop_back();
    }
    while (m_share_percent.size() < wanted) {
        auto* share = new QDoubleSpinBox(this);
        share->setObjectName(QStringLiteral("planShare%1").arg(m_share_percent.size()));
        share->setRange(0.0, kPercentOf);
        share->setDecimals(1);
        share->setSuffix(QStringLiteral(" %"));
        // Something to start from, in which the conditions differ.
        share->setValue(kUsualShare + 10.0 * static_cast<double>(m_share_percent.size()));
        auto* label = new QLabel(this);
        label->setBuddy(share);
        m_shares->addRow(label, share);
        m_share_percent.push_back(share);
    }
    for (std::size_t i = 0; i < wanted; ++i) {
        const QString name = displayCondition(*chosen, chosen->conditions[i]);
        auto* label = qobject_cast<QLabel*>(m_shares->labelForField(m_share_percent[i]));
        label->setText(tr("Right answers, %1", "condition").arg(name));
        m_share_percent[i]->setAccessibleName(label->text());
    }
    if (isOfThreshold())
        m_threshold->setTask(*chosen);
    // The whole rows: a form keeps no room for a widget that was hidden when it was laid out.
    m_form->setRowVisible(m_shares, !isOfThreshold());
    for (QWidget* field : {m_participantSd, m_conditionSd})
        m_form->setRowVisible(field, !isOfThreshold());
    m_form->setRowVisible(m_threshold, isOfThreshold());
    // A threshold takes a fit of every participant, and so longer. What was chosen stays while the kind does.
    if (const bool wasOfThreshold = std::exchange(m_wasOfThreshold, isOfThreshold());
        wasOfThreshold != isOfThreshold())
        m_studies->setCurrentIndex(m_studies->findData(isOfThreshold() ? kThresholdStudies : kTestStudies));
    m_targetLabel->setText(isOfThreshold() ? tr("Targ&et") : tr("Target po&wer"));
    showSource();
    alignFields();
    if (!m_isPlanned)
        showNoPlan();
}

/// The fields of the forms in a row below each other, whatever their labels are.
void PlanPanel::alignFields() {
    QList<QLabel*> labels;
    for (const QFormLayout* form : findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            if (auto* label = item != nullptr ? qobject_cast<QLabel*>(item->widget()) : nullptr)
                labels << label;
        }
    int widest = 0;
    for (const QLabel* label : labels)
        if (!label->isHidden())
            widest = std::max(widest, label->sizeHint().width());
    for (QLabel* label : labels)
        label->setMinimumWidth(widest);
}

void PlanPanel::showSource() {
    const bool isOwn = !m_truth;
    m_sourceLabel->setVisible(task() != nullptr);
    m_sourceLabel->setText(!isOwn ? tr("Assumed: what %1 says.").arg(m_source)
                           : isOfThreshold()
                               ? tr("The middle participant has this threshold.")
                               : tr("The middle participant has these shares; the spreads are in logits."));
    m_threshold->setEnabled(!m_running);
    m_threshold->setTruthEnabled(isOwn);
    for (QDoubleSpinBox* share : m_share_percent)
        share->setEnabled(isOwn && !m_running);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_participantSd, m_conditionSd})
        widget->setEnabled(isOwn && !m_running && task() != nullptr);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_test, m_file, m_pilot, m_from, m_to, m_step,
                                                           m_target_percent, m_studies})
        widget->setEnabled(!m_running && task() != nullptr);
    m_own->setVisible(!isOwn);
    m_own->setEnabled(!m_running);
    m_start->setEnabled(!m_running && task() != nullptr);
    m_cancel->setEnabled(m_running);
    m_progress->setVisible(m_running);
    if (task() == nullptr)
        m_answer->setText(tr("The protocol has no task to plan for."));
}

/// What will be where the curve is.
void PlanPanel::showNoPlan() {
    CurveContent content;
    if (isOfThreshold())
        content.nothing = tr("The share of studies with an interval narrow enough will be shown here.\nEnter "
                             "what you assume on the left, and choose Plan.");
    else if (task() != nullptr)
        content.nothing = tr("The power over the number of participants will be shown here.\nEnter what you "
                             "assume on the left, and choose Plan.");
    else
        content.nothing = tr("There is nothing to plan.");
    m_curve->setContent(std::move(content));
    m_curve->setAccessibleName(tr("Power over the number of participants"));
    m_isPlanned = false;
}

void PlanPanel::setRunning(double done) {
    if (!m_running) {
        m_running = true;
        m_answer->clear();
        showSource();
    }
    m_progress->setValue(static_cast<int>(1000.0 * done));
}

void PlanPanel::setPlan(const PowerPlan& plan, const PlanRequest& request) {
    m_running = false;
    showSource();
    m_curve->setContent(PlanContent::curve(plan, request, m_test->currentText()));
    m_isPlanned = true;
    m_answer->setText(PlanContent::answer(plan, request.settings));
}

void PlanPanel::setProblem(const QString& text) {
    m_running = false;
    showSource();
    m_answer->setText(text);
}

void PlanPanel::retranslate() {
    const QString before = m_test->currentData().toString();
    {
        const QSignalBlocker quiet(m_test);
        m_test->clear();
        for (const PlanTest& test : PlanContent::tests(m_protocol))
            m_test->addItem(test.name, test.id);
        m_test->setCurrentIndex(std::max(m_test->count() > 0 ? 0 : -1, m_test->findData(before)));
    }
    m_testLabel->setText(tr("&Test"));
    m_participantLabel->setText(tr("Spread of &participants"));
    m_conditionLabel->setText(tr("Spread under one &condition"));
    m_file->setText(tr("Fro&m a file\u2026"));
    m_file->setToolTip(tr("A TOML file with shares of right answers or thresholds, and spreads"));
    m_pilot->setText(tr("From this st&udy"));
    m_pilot->setToolTip(tr("Assumes what the results of this study show; at least 5 participants"));
    m_own->setText(tr("From this f&orm"));
    m_rangeLabel->setText(tr("Part&icipants"));
    m_from->setPrefix(tr("from ", "number of participants"));
    m_to->setPrefix(tr("to ", "number of participants"));
    m_step->setPrefix(tr("step ", "of the number of participants"));
    m_studiesLabel->setText(tr("&Studies drawn"));
    for (int i = 0; i < m_studies->count(); ++i)
        m_studies->setItemText(i, QLocale().toString(m_studies->itemData(i).toInt()));
    m_start->setText(tr("P&lan"));
    m_cancel->setText(tr("Cancel"));
    m_curve->setAccessibleName(tr("Power over the number of participants"));
    showConditions();
}

} // namespace teleta::study
