// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/planning/study_truth.h"

#include "backend/core/failure.h"
#include "backend/core/keys/toml_keys.h"
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

double varianceOf(const TaskResults& task) {
    const auto model = accuracyModel(task);
    return model ? model->fit.s * model->fit.s : 0.0;
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
                    table.tables("condition", task.conditions, 1, "What is assumed under each condition",
                                 [](core::Keys& entry, std::vector<ConditionTruth>& conditions,
                                    std::size_t c) { describeCondition(entry, conditions[c]); });
                });
}

const TaskTruth* StudyTruth::find(const std::string& task) const {
    const auto found = std::ranges::find(tasks, task, &TaskTruth::id);
    return found == tasks.end() ? nullptr : &*found;
}

core::Expected<StudyTruth> parseTruth(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(core::readKeys<StudyTruth>);
}

core::Expected<StudyTruth> readTruth(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(file.exists() ? core::ErrorKind::ioFailed : core::ErrorKind::notFound,
                            TruthText::tr("cannot open the truth: %1").arg(file.errorString()), {}, {path});
    return parseTruth(file.readAll().toStdString(), path);
}

core::Expected<StudyTruth> truthOf(const std::vector<TaskResults>& pilot, const std::string& source) {
    if (pilot.empty())
        return core::failed(core::ErrorKind::refused,
                            TruthText::tr("the task %1 shows no spread of its participants: %2")
                                .arg(QStringLiteral("-"), QLatin1String("no data")),
                            TruthText::tr("a pilot with at least 5 participants, or a file with the truth"),
                            {source});
    StudyTruth truth;
    for (const TaskResults& task : pilot) {
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
    return truth;
}

} // namespace teleta::study
