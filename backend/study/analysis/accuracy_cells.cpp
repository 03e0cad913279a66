// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/accuracy_cells.h"

#include <algorithm>
#include <limits>
#include <set>

namespace teleta::study {

ParticipantCells AccuracyCells::ofPattern(std::size_t pattern) const {
    ParticipantCells columns;
    columns.reserve(cells.size());
    for (const std::vector<double>& row : cells) {
        std::vector<double>& own = columns.emplace_back();
        for (std::size_t i = 0; i < conditions.size(); ++i)
            own.push_back(row[i * patterns.size() + pattern]);
    }
    return columns;
}

AccuracyCells accuracyCells(const TaskResults& task) {
    AccuracyCells table;
    std::set<std::string> people;
    for (const ParticipantSummary& participant : task.participants)
        people.insert(participant.participant);
    table.people.assign(people.begin(), people.end());
    for (const GroupSummary& group : task.groups)
        table.conditions.push_back(group.condition);
    for (std::size_t i = 0; i < task.patterns.size(); ++i) {
        if (std::ranges::any_of(task.groups,
                                [&](const GroupSummary& group) { return group.matrix.rowTotal(i) > 0; }))
            table.patterns.push_back(i);
    }
    const std::size_t columns = table.conditions.size() * table.patterns.size();
    table.cells.assign(table.people.size(),
                       std::vector<double>(columns, std::numeric_limits<double>::quiet_NaN()));
    for (const ParticipantSummary& participant : task.participants) {
        const auto row = std::ranges::lower_bound(table.people, participant.participant);
        const auto found = std::ranges::find(table.conditions, participant.condition);
        const auto condition = static_cast<std::size_t>(found - table.conditions.begin());
        std::vector<double>& cells = table.cells[static_cast<std::size_t>(row - table.people.begin())];
        for (std::size_t j = 0; j < table.patterns.size(); ++j) {
            const std::size_t pattern = table.patterns[j];
            if (const std::optional<double> percent = participant.matrix.rowPercent(pattern, pattern))
                cells[condition * table.patterns.size() + j] = *percent / 100.0;
        }
    }
    return table;
}

} // namespace teleta::study
