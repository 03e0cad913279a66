// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/exclusion_results.h"

#include <algorithm>

namespace teleta::study {

namespace {

/// The share of right answers of a condition.
std::optional<double> accuracyOf(const TaskResults& task, const std::string& condition) {
    const auto group = std::ranges::find(task.groups, condition, &GroupSummary::condition);
    return group != task.groups.end() && group->accuracy ? std::optional(group->accuracy->mean)
                                                         : std::nullopt;
}

std::optional<double> pOf(const TaskResults& task, const AnovaLine& like) {
    for (const AnovaLine& line : task.anova) {
        if (line.effect == like.effect && line.stimulus == like.stimulus && line.row)
            return line.row->pGg;
    }
    return std::nullopt;
}

} // namespace

ExclusionReport exclusionReport(const ExclusionBook& book) {
    ExclusionReport report{book.lines(), {}};
    if (book.isUsed())
        report.withoutRules = studyResults(book.withoutRules());
    return report;
}

std::vector<ComparedResult> comparedResults(const std::vector<TaskResults>& results,
                                            const std::vector<TaskResults>& withoutRules) {
    std::vector<ComparedResult> rows;
    // All trials have every task and condition that is left with the rules.
    for (const TaskResults& whole : withoutRules) {
        const auto found = std::ranges::find(results, whole.task, &TaskResults::task);
        const TaskResults none;
        const TaskResults& task = found == results.end() ? none : *found;
        for (const GroupSummary& group : whole.groups)
            rows.push_back({whole.task,
                            group.condition,
                            accuracyOf(task, group.condition),
                            accuracyOf(whole, group.condition),
                            {},
                            {}});
        for (const AnovaLine& line : whole.anova) {
            if (line.stimulus.empty())
                rows.push_back({whole.task, line.effect, {}, {}, pOf(task, line), pOf(whole, line)});
        }
    }
    return rows;
}

} // namespace teleta::study
