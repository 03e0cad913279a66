// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/planning/threshold_plan.h"

#include "backend/core/failure.h"
#include "backend/study/methods/fit/psychometric_fit.h"
#include "backend/study/methods/results/level_trial_store.h"
#include "backend/study/methods/results/threshold_results.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

namespace teleta::study {

namespace {

struct ThresholdPlanText {
    Q_DECLARE_TR_FUNCTIONS(ThresholdPlan)
};

constexpr std::string_view kThresholdTest = ":threshold";

core::Unexpected wrongPlan(const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected);
}

void setTrials(Procedure& procedure, std::size_t trials) {
    if (auto* constant = std::get_if<ConstantSettings>(&procedure))
        constant->repetitions = trials;
    else if (auto* staircase = std::get_if<StaircaseSettings>(&procedure))
        staircase->mostTrials = trials;
    else
        std::get<BayesSettings>(procedure).mostTrials = trials;
}

} // namespace

bool ThresholdPlan::isTest(const std::string& test) {
    return test.ends_with(kThresholdTest);
}

core::Expected<ThresholdPlan> ThresholdPlan::make(const Protocol& protocol, const StudyTruth& truth,
                                                  const std::string& test, const ThresholdWish& wish) {
    const std::string name = isTest(test) ? test.substr(0, test.size() - kThresholdTest.size()) : test;
    const QString shown = QString::fromStdString(name);
    const auto task = std::ranges::find(protocol.tasks, name, &StudyTask::id);
    if (task == protocol.tasks.end())
        return wrongPlan(ThresholdPlanText::tr("the protocol has no task \"%1\"").arg(shown),
                         ThresholdPlanText::tr("TASK:threshold with the id of a task with levels"));
    if (task->design == Design::identification)
        return wrongPlan(ThresholdPlanText::tr("the task %1 has no levels").arg(shown),
                         ThresholdPlanText::tr("a task that measures a threshold"));
    const TaskTruth* own = truth.find(name);
    if (own == nullptr || !own->threshold)
        return wrongPlan(ThresholdPlanText::tr("the truth says nothing of the threshold of %1").arg(shown),
                         ThresholdPlanText::tr("a [[task]] with that id and a threshold"));
    ThresholdPlan plan;
    plan.m_design = task->design;
    plan.m_reference = task->referenceOf(task->conditions.front());
    plan.m_catchShare = task->levels.catchShare;
    plan.m_facts = levelTaskFacts(protocol, *task);
    plan.m_halfWidth = wish.halfWidth;
    if (wish.trials)
        setTrials(*plan.m_facts.settings, *wish.trials);
    const LevelRange& range = *plan.m_facts.range;
    const ThresholdTruth& assumed = *own->threshold;
    if (range.scale == LevelScale::log10 && !(assumed.threshold > 0.0))
        return wrongPlan(ThresholdPlanText::tr("the threshold of %1 cannot be 0").arg(shown),
                         ThresholdPlanText::tr("a level above 0, since the scale is log10"));
    const std::optional<FitModel> model = fitModelOf(plan.m_facts, {plan.m_reference, {}}, {});
    plan.m_middle.shape = model ? model->shape : RiseShape::gauss;
    plan.m_middle.threshold = assumed.threshold;
    plan.m_middle.spread = assumed.slope;
    plan.m_middle.lapse = assumed.lapse;
    plan.m_middle.guess = plan.m_design == Design::interval
                              ? 1.0 / static_cast<double>(task->levels.intervals)
                          : plan.m_design == Design::compare ? assumed.lapse
                                                             : assumed.guess;
    plan.m_sd = assumed.sd;
    if (const auto* bayes = std::get_if<BayesSettings>(&*plan.m_facts.settings))
        plan.m_grid = std::make_shared<const BayesGrid>(*bayes, range);
    return plan;
}

std::vector<LevelTrial> ThresholdPlan::trialsOf(const PsychometricFunction& function,
                                                core::RandomStream& random) const {
    // Half of the trials of same and different show the same.
    const double nothing = m_design == Design::sameDifferent ? 0.5 : m_catchShare;
    std::vector<LevelTrial> trials;
    const auto show = [&](double level) {
        while (nothing > 0.0 && random.uniform() < nothing)
            trials.push_back({{m_reference, 0, random.uniform() < function.guess, false}, {}, {}});
        const KeptTrial shown{level, 0, random.uniform() < function.shareAt(level), true};
        trials.push_back({shown, {}, {}});
        return shown;
    };
    // The order of constant stimuli changes no fit.
    if (const auto* constant = std::get_if<ConstantSettings>(&*m_facts.settings)) {
        for (const double level : constant->levels) {
            for (std::size_t i = 0; i < constant->repetitions; ++i)
                (void)show(level);
        }
        return trials;
    }
    std::optional<BayesTrack> bayes;
    if (m_grid)
        bayes.emplace(*m_grid);
    std::vector<KeptTrial> kept;
    for (;;) {
        const TrackStep step = bayes ? bayes->next() : nextStep(*m_facts.settings, *m_facts.range, 0, kept);
        const auto* next = std::get_if<NextLevel>(&step);
        if (next == nullptr)
            return trials;
        kept.push_back(show(next->level));
        if (bayes)
            bayes->add(kept.back().level, kept.back().correct);
    }
}

std::vector<double> ThresholdPlan::participant(core::RandomStream& random) const {
    const LevelScale scale = m_facts.range->scale;
    PsychometricFunction function = m_middle;
    if (m_sd > 0.0)
        function.threshold = fromScale(scale, onScale(scale, function.threshold) + m_sd * random.normal());
    const LevelTrials::Track track{m_reference, trialsOf(function, random)};
    std::vector<KeptTrial> kept;
    for (const LevelTrial& trial : track.trials)
        kept.push_back(trial.kept);
    const std::optional<FitModel> model = fitModelOf(m_facts, track, {});
    std::optional<double> threshold;
    if (model)
        threshold = fitPsychometric(levelCounts(kept), {*model, FitInterval::none}).threshold;
    return {threshold ? onScale(scale, *threshold) : std::numeric_limits<double>::quiet_NaN()};
}

std::optional<double> ThresholdPlan::p(std::span<const std::vector<double>> participants) const {
    std::vector<double> values;
    for (const std::vector<double>& one : participants)
        values.push_back(one.front());
    return narrowEnough(values, m_halfWidth);
}

std::optional<double> narrowEnough(std::span<const double> values, double halfWidth) {
    std::vector<double> known;
    std::ranges::remove_copy_if(values, std::back_inserter(known),
                                [](double value) { return std::isnan(value); });
    const std::optional<GroupMean> mean = groupMean(known);
    if (!mean || !mean->interval)
        return std::nullopt;
    return (mean->interval->high - mean->interval->low) / 2.0 <= halfWidth ? 0.0 : 1.0;
}

} // namespace teleta::study
