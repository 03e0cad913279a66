// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/planning/study_truth.h"

#include "backend/core/failure.h"
#include "backend/core/keys/toml_keys.h"
#include "backend/core/quantile.h"
#include "backend/study/model/accuracy_model.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

struct TruthText {
    Q_DECLARE_TR_FUNCTIONS(StudyTruth)
};

constexpr double kMostSpread = 5.0;

const core::NumberRange kShares = core::NumberRange::between(0.0, 1.0);

void describeCondition(core::Keys& keys, ConditionTruth& condition) {
    keys.text("id", condition.id, "The condition's name in the protocol");
    keys.number("correct", condition.correct, kShares, "Share of right answers of the middle participant");
    keys.tables("pattern", condition.patterns, 0, "Patterns that have another share",
                [](core::Keys& entry, std::vector<PatternTruth>& patterns, std::size_t i) {
                    entry.text("letter", patterns[i].letter, "The pattern's letter in the protocol");
                    entry.number("correct", patterns[i].correct, kShares, "Share of right answers");
                });
}

void describeThreshold(core::Keys& keys, ThresholdTruth& truth) {
    keys.number("t", truth.threshold, core::NumberRange::notNegative(),
                "Threshold of the middle participant, in the unit of the level");
    keys.number("slope", truth.slope, core::NumberRange::positive(),
                "Slope b of weibull, or spread of gauss, in the unit of the level");
    keys.number("lapse", truth.lapse, core::NumberRange::between(0.0, 0.4),
                "Share of mistakes however strong the stimulus is", core::Need::optional);
    keys.number("guess", truth.guess, core::NumberRange::between(0.0, 0.9),
                "Share of yes or different without a stimulus, where the design does not say it",
                core::Need::optional);
    keys.number("sd", truth.sd, core::NumberRange::between(0.0, kMostSpread),
                "Standard deviation of the participants' thresholds, on the scale of the levels",
                core::Need::optional);
}

double varianceOf(const TaskResults& task) {
    const auto model = accuracyModel(task);
    return model ? model->fit.s * model->fit.s : 0.0;
}

/// What a pilot says of its tasks with levels; those without a threshold are left out.
void addThresholds(StudyTruth& truth, const ThresholdResults& thresholds) {
    for (std::size_t i = 0; i < thresholds.groups.size();) {
        const std::string& id = thresholds.groups[i].task;
        const LevelScale scale = thresholds.groups[i].scale;
        std::vector<double> means;
        std::vector<double> spreads;
        for (; i < thresholds.groups.size() && thresholds.groups[i].task == id; ++i) {
            const ThresholdGroup& group = thresholds.groups[i];
            if (!group.threshold)
                continue;
            means.push_back(onScale(scale, *group.threshold));
            if (group.hierarchical)
                spreads.push_back(group.hierarchical->participantSd);
            else if (group.standardDeviation)
                spreads.push_back(*group.standardDeviation);
        }
        std::vector<double> slopes;
        for (const ThresholdLine& line : thresholds.lines) {
            if (line.task == id && line.fit.spread)
                slopes.push_back(*line.fit.spread);
        }
        const std::optional<GroupMean> mean = groupMean(means);
        const std::optional<GroupMean> spread = groupMean(spreads);
        if (!mean || !spread || slopes.empty())
            continue;
        std::ranges::sort(slopes);
        TaskTruth& own = truth.tasks.emplace_back();
        own.id = id;
        own.threshold = ThresholdTruth{fromScale(scale, mean->mean), core::quantileOf(slopes, 0.5)};
        own.threshold->sd = spread->mean;
    }
}

bool hasLevels(const ThresholdResults& thresholds, const std::string& task) {
    return std::ranges::find(thresholds.groups, task, &ThresholdGroup::task) != thresholds.groups.end();
}

/// The same task with one condition alone.
TaskResults conditionAlone(const TaskResults& task, const std::string& condition) {
    TaskResults alone = task;
    std::erase_if(alone.groups, [&](const GroupSummary& group) { return group.condition != condition; });
    std::erase_if(alone.participants,
                  [&](const ParticipantSummary& person) { return person.condition != condition; });
    return alone;
}

} // namespace

double ConditionTruth::correctOf(const std::string& letter) const {
    const auto own = std::ranges::find(patterns, letter, &PatternTruth::letter);
    return own == patterns.end() ? correct : own->correct;
}

void StudyTruth::describeKeys(core::Keys& keys) {
    keys.tables("task", tasks, 1, "What is assumed of a task",
                [](core::Keys& table, std::vector<TaskTruth>& all, std::size_t i) {
                    TaskTruth& task = all[i];
                    const core::NumberRange spread = core::NumberRange::between(0.0, kMostSpread);
                    table.text("id", task.id, "The task's name in the protocol");
                    table.number("participant_sd", task.participantSd, spread,
                                 "Standard deviation of the participants, in logits", core::Need::optional);
                    table.number("participant_condition_sd", task.participantConditionSd, spread,
                                 "Standard deviation of participants under one condition, in logits",
                                 core::Need::optional);
                    table.table("threshold", task.threshold, "What is assumed where levels are measured",
                                describeThreshold);
                    table.tables("condition", task.conditions, 0, "What is assumed under each condition",
                                 [](core::Keys& entry, std::vector<ConditionTruth>& conditions,
                                    std::size_t c) { describeCondition(entry, conditions[c]); });
                });
}

const TaskTruth* StudyTruth::find(const std::string& task) const {
    const auto found = std::ranges::find(tasks, task, &TaskTruth::id);
    return found == tasks.end() ? nullptr : &*found;
}

core::Expected<StudyTruth> parseTruth(std::string_view text, const std::string& file) {
    TELETA_TRY(StudyTruth truth, core::TomlDocument::parse(text, file).and_then(core::readKeys<StudyTruth>));
    for (const TaskTruth& task : truth.tasks) {
        if (task.conditions.empty() && !task.threshold)
            return core::failed(
                core::ErrorKind::badInput,
                TruthText::tr("nothing is assumed of the task %1").arg(QString::fromStdString(task.id)),
                TruthText::tr("condition or threshold"), {file});
    }
    return truth;
}

core::Expected<StudyTruth> readTruth(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(file.exists() ? core::ErrorKind::ioFailed : core::ErrorKind::notFound,
                            TruthText::tr("cannot open the truth: %1").arg(file.errorString()), {}, {path});
    return parseTruth(file.readAll().toStdString(), path);
}

core::Expected<StudyTruth> truthOf(const std::vector<TaskResults>& pilot, const std::string& source) {
    return truthOf(pilot, {}, source);
}

core::Expected<StudyTruth> truthOf(const std::vector<TaskResults>& pilot, const ThresholdResults& thresholds,
                                   const std::string& source) {
    if (pilot.empty() && thresholds.empty())
        return core::failed(core::ErrorKind::refused, TruthText::tr("this study has no test trials yet"),
                            TruthText::tr("a pilot with at least 5 participants, or a file with the truth"),
                            {source});
    StudyTruth truth;
    addThresholds(truth, thresholds);
    for (const TaskResults& task : pilot) {
        if (hasLevels(thresholds, task.task))
            continue; // what is right there depends on the level
        const auto model = accuracyModel(task);
        if (!model)
            return core::failed(
                core::ErrorKind::refused,
                TruthText::tr("the task %1 shows no spread of its participants: %2")
                    .arg(QString::fromStdString(task.task), QLatin1String(toString(model.error()))),
                TruthText::tr("a pilot with at least 5 participants, or a file with the truth"), {source});
        TaskTruth& own = truth.tasks.emplace_back();
        own.id = task.task;
        own.participantSd = model->fit.s;
        double within = 0.0;
        for (const GroupSummary& group : task.groups) {
            within +=
                varianceOf(conditionAlone(task, group.condition)) / static_cast<double>(task.groups.size());
            ConditionTruth& condition = own.conditions.emplace_back();
            condition.id = group.condition;
            const auto share = [](std::int64_t correct, std::int64_t trials) {
                return (static_cast<double>(correct) + 0.5) / (static_cast<double>(trials) + 1.0);
            };
            condition.correct = share(group.matrix.correct(), group.matrix.total());
            for (std::size_t i = 0; i < task.patterns.size(); ++i) {
                if (group.matrix.rowTotal(i) > 0)
                    condition.patterns.push_back(
                        {task.patterns[i], share(group.matrix.count(i, i), group.matrix.rowTotal(i))});
            }
        }
        if (task.groups.size() > 1)
            own.participantConditionSd = std::sqrt(std::max(0.0, within - model->fit.s * model->fit.s));
    }
    if (truth.tasks.empty())
        return core::failed(core::ErrorKind::refused,
                            TruthText::tr("no task has a threshold and a slope of several participants"),
                            TruthText::tr("a pilot with at least 2 participants, or a file with the truth"),
                            {source});
    return truth;
}

} // namespace teleta::study
