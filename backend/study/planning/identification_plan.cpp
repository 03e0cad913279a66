// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/planning/identification_plan.h"

#include "backend/core/failure.h"
#include "backend/study/analysis/repeated_anova.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>

namespace teleta::study {

namespace {

struct PlanText {
    Q_DECLARE_TR_FUNCTIONS(StudyPlan)
};

/// Infinite for 0 and 1, which stay what they are.
double logit(double share) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (share <= 0.0 || share >= 1.0)
        return share <= 0.0 ? -kInfinity : kInfinity;
    return std::log(share / (1.0 - share));
}

core::Unexpected wrongTest(const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected);
}

std::optional<double> correctedP(const AnovaRow& row) {
    return row ? std::optional(row->pGg) : std::nullopt;
}

} // namespace

std::string PlannedTest::name() const {
    return task + ':' + effect + (stimulus.empty() ? std::string() : '@' + stimulus);
}

core::Expected<IdentificationPlan> IdentificationPlan::make(const Protocol& protocol, const StudyTruth& truth,
                                                            const std::string& test) {
    IdentificationPlan plan;
    const std::size_t colon = test.find(':');
    plan.m_test.task = test.substr(0, colon);
    const std::string effect = colon == std::string::npos ? std::string() : test.substr(colon + 1);
    const std::size_t at = effect.find('@');
    plan.m_test.effect = effect.substr(0, at);
    if (at != std::string::npos)
        plan.m_test.stimulus = effect.substr(at + 1);
    const auto quoted = [](const std::string& text) { return QString::fromStdString(text); };
    const auto task = std::ranges::find(protocol.tasks, plan.m_test.task, &StudyTask::id);
    if (task == protocol.tasks.end()) {
        QStringList ids;
        for (const StudyTask& one : protocol.tasks)
            ids << quoted(one.id);
        return wrongTest(PlanText::tr("the protocol has no task \"%1\"").arg(quoted(plan.m_test.task)),
                         PlanText::tr("TASK:EFFECT with one of %1").arg(ids.join(QStringLiteral(", "))));
    }
    if (task->design != Design::identification)
        return wrongTest(PlanText::tr("the task %1 measures levels").arg(quoted(task->id)),
                         PlanText::tr("a task in which patterns are told apart"));
    const bool hasConditions = task->conditions.size() > 1;
    const std::string& name = plan.m_test.effect;
    const bool isKnown =
        name == "pattern" || (hasConditions && (name == "condition" || name == "condition:pattern"));
    if (!isKnown || (!plan.m_test.stimulus.empty() && name != "condition"))
        return wrongTest(
            PlanText::tr("\"%1\" is no line of the analysis of %2").arg(quoted(effect), quoted(task->id)),
            hasConditions ? PlanText::tr("condition, pattern, condition:pattern, or condition@PATTERN")
                          : PlanText::tr("pattern"));
    plan.m_conditions = task->conditions.size();
    plan.m_patterns = task->patterns.size();
    plan.m_repetitions = protocol.test.repetitions;
    if (plan.m_repetitions == 0)
        return wrongTest(PlanText::tr("the protocol has no test trials"),
                         PlanText::tr("test.repetitions above 0"));
    if (!plan.m_test.stimulus.empty()) {
        const auto pattern = std::ranges::find(task->patterns, plan.m_test.stimulus, &StudyPattern::letter);
        if (pattern == task->patterns.end())
            return wrongTest(PlanText::tr("the task %1 has no pattern \"%2\"")
                                 .arg(quoted(task->id), quoted(plan.m_test.stimulus)),
                             PlanText::tr("one of its letters"));
        plan.m_pattern = static_cast<std::size_t>(pattern - task->patterns.begin());
    }
    const TaskTruth* own = truth.find(task->id);
    if (own == nullptr || own->conditions.empty())
        return wrongTest(PlanText::tr("the truth says nothing of the task %1").arg(quoted(task->id)),
                         PlanText::tr("a [[task]] with that id"));
    plan.m_participantSd = own->participantSd;
    plan.m_participantConditionSd = own->participantConditionSd;
    for (const std::string& id : task->conditions) {
        const auto condition = std::ranges::find(own->conditions, id, &ConditionTruth::id);
        if (condition == own->conditions.end())
            return wrongTest(
                PlanText::tr("the truth says nothing of %1 under %2").arg(quoted(task->id), quoted(id)),
                PlanText::tr("a condition with that id"));
        for (const StudyPattern& pattern : task->patterns)
            plan.m_logits.push_back(logit(condition->correctOf(pattern.letter)));
    }
    return plan;
}

std::vector<double> IdentificationPlan::participant(core::RandomStream& random) const {
    std::vector<double> cells(m_logits.size());
    const double person = m_participantSd > 0.0 ? m_participantSd * random.normal() : 0.0;
    for (std::size_t i = 0; i < m_conditions; ++i) {
        const double moved =
            person + (m_participantConditionSd > 0.0 ? m_participantConditionSd * random.normal() : 0.0);
        for (std::size_t j = 0; j < m_patterns; ++j) {
            const std::size_t cell = i * m_patterns + j;
            const double share = 1.0 / (1.0 + std::exp(-(m_logits[cell] + moved)));
            std::size_t correct = 0;
            for (std::size_t trial = 0; trial < m_repetitions; ++trial)
                correct += random.uniform() < share ? 1 : 0;
            cells[cell] = static_cast<double>(correct) / static_cast<double>(m_repetitions);
        }
    }
    return cells;
}

std::optional<double> IdentificationPlan::p(std::span<const std::vector<double>> participants) const {
    if (!m_test.stimulus.empty()) {
        ParticipantCells columns;
        for (const std::vector<double>& row : participants) {
            std::vector<double>& own = columns.emplace_back();
            for (std::size_t i = 0; i < m_conditions; ++i)
                own.push_back(row[i * m_patterns + m_pattern]);
        }
        const auto table = oneWayAnova(columns);
        return table ? correctedP(table->effect) : std::nullopt;
    }
    const ParticipantCells cells(participants.begin(), participants.end());
    if (m_conditions == 1) {
        const auto table = oneWayAnova(cells);
        return table ? correctedP(table->effect) : std::nullopt;
    }
    const auto table = twoWayAnova(cells, m_conditions, m_patterns);
    if (!table)
        return std::nullopt;
    return correctedP(m_test.effect == "condition" ? table->first
                      : m_test.effect == "pattern" ? table->second
                                                   : table->interaction);
}

} // namespace teleta::study
