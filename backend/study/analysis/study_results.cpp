// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"

#include "backend/study/analysis/accuracy_cells.h"

#include <algorithm>
#include <map>
#include <set>

namespace teleta::study {

namespace {

using Cells = std::map<TrialTally::Key, TrialTally::Cell>;

/// The trials of one task.
class TaskAnalysis {
public:
    TaskAnalysis(const TrialTally& tally, std::string task)
        : m_tally(tally) {
        m_results.task = std::move(task);
    }

    [[nodiscard]] TaskResults run();

private:
    void collectNames();
    void collectMatrices();
    void summariseGroups();
    void analyseVariance();

    [[nodiscard]] ConfusionMatrix matrixOf(const TrialTally::Cell& cell) const;
    /// cells: those of the row. Participants who lack one are named, even if too few are left for a row.
    void addLine(std::string effect, std::string stimulus, const AnovaRow& row,
                 const ParticipantCells& cells);

    const TrialTally& m_tally;
    TaskResults m_results;
    std::vector<std::string> m_people;           ///< with test trials
    std::map<std::size_t, std::size_t> m_column; ///< of a name in the tally
};

TaskResults TaskAnalysis::run() {
    collectNames();
    collectMatrices();
    summariseGroups();
    analyseVariance();
    return std::move(m_results);
}

void TaskAnalysis::collectNames() {
    std::map<std::string, std::size_t> patterns;
    std::set<std::string> conditions;
    std::set<std::string> people;
    for (const auto& [key, cell] : m_tally.cells()) {
        if (key.task != m_results.task)
            continue;
        conditions.insert(key.condition);
        if (key.phase == Phase::test)
            people.insert(key.participant);
        for (const auto& [answer, count] : cell.counts) {
            for (const std::size_t name : {answer.first, answer.second}) {
                if (name != TrialTally::kNone)
                    patterns.emplace(m_tally.names()[name], name);
            }
        }
    }
    if (const TrialTally::Alternatives* alternatives = m_tally.alternatives(m_results.task)) {
        for (const std::size_t name : alternatives->patterns)
            patterns.emplace(m_tally.names()[name], name);
        m_results.toldAlternatives = alternatives->count;
    }
    for (const auto& [name, index] : patterns) {
        m_column[index] = m_results.patterns.size();
        m_results.patterns.push_back(name);
    }
    m_results.conditions.assign(conditions.begin(), conditions.end());
    m_people.assign(people.begin(), people.end());
}

ConfusionMatrix TaskAnalysis::matrixOf(const TrialTally::Cell& cell) const {
    ConfusionMatrix matrix(m_results.patterns.size());
    for (const auto& [answer, count] : cell.counts)
        matrix.add(m_column.at(answer.first),
                   answer.second == TrialTally::kNone ? std::nullopt
                                                      : std::optional(m_column.at(answer.second)),
                   count);
    return matrix;
}

void TaskAnalysis::collectMatrices() {
    std::map<std::pair<std::string, Phase>, ConfusionMatrix> pooled;
    for (const auto& [key, cell] : m_tally.cells()) {
        if (key.task != m_results.task)
            continue;
        const ConfusionMatrix matrix = matrixOf(cell);
        pooled.try_emplace({key.condition, key.phase}, m_results.patterns.size()).first->second.add(matrix);
        m_results.matrices.push_back({key.participant, key.condition, key.phase, matrix});
        if (key.phase != Phase::test)
            continue;
        ParticipantSummary summary{key.participant, key.condition, matrix, median(cell.correctTimes_s),
                                   cell.correctTimes_s};
        std::ranges::sort(summary.times_s);
        m_results.participants.push_back(std::move(summary));
    }
    for (const auto& [key, matrix] : pooled)
        m_results.matrices.push_back({{}, key.first, key.second, matrix});
}

void TaskAnalysis::summariseGroups() {
    for (const std::string& condition : m_results.conditions) {
        GroupSummary group{condition, ConfusionMatrix(m_results.patterns.size())};
        std::vector<double> accuracies;
        std::vector<ConfusionMatrix> matrices;
        for (const ParticipantSummary& participant : m_results.participants) {
            if (participant.condition != condition)
                continue;
            group.matrix.add(participant.matrix);
            matrices.push_back(participant.matrix);
            accuracies.push_back(participant.matrix.accuracy().value_or(0.0));
        }
        if (matrices.empty())
            continue;
        group.participants = matrices.size();
        group.accuracy = groupShare(accuracies);
        group.transfer = studyTransfer(matrices, m_results.alternatives());
        m_results.groups.push_back(std::move(group));
    }
}

void TaskAnalysis::addLine(std::string effect, std::string stimulus, const AnovaRow& row,
                           const ParticipantCells& cells) {
    const std::vector<std::size_t> dropped = incompleteParticipants(cells);
    AnovaLine line{std::move(effect), std::move(stimulus), {}, {}, cells.size() - dropped.size(), {}};
    if (row)
        line.row = *row;
    else
        line.note = toString(row.error());
    for (const std::size_t person : dropped)
        line.dropped.push_back(m_people[person]);
    m_results.anova.push_back(std::move(line));
}

void TaskAnalysis::analyseVariance() {
    const AccuracyCells table = accuracyCells(m_results);
    if (table.patterns.empty())
        return;
    const auto addOneWay = [&](const char* effect, const std::string& stimulus,
                               const ParticipantCells& cells) {
        const auto anova = oneWayAnova(cells);
        addLine(effect, stimulus, anova ? anova->effect : AnovaRow(tl::unexpected(anova.error())), cells);
    };
    if (table.conditions.size() < 2) {
        addOneWay("pattern", "", table.cells);
        return;
    }
    const auto anova = twoWayAnova(table.cells, table.conditions.size(), table.patterns.size());
    const auto addTwoWay = [&](const char* effect, AnovaRow TwoWayAnova::*row) {
        addLine(effect, "", anova ? (*anova).*row : AnovaRow(tl::unexpected(anova.error())), table.cells);
    };
    addTwoWay("condition", &TwoWayAnova::first);
    addTwoWay("pattern", &TwoWayAnova::second);
    addTwoWay("condition:pattern", &TwoWayAnova::interaction);
    for (std::size_t j = 0; j < table.patterns.size(); ++j)
        addOneWay("condition", m_results.patterns[table.patterns[j]], table.ofPattern(j));
}

} // namespace

std::vector<TaskResults> studyResults(const TrialTally& tally) {
    std::set<std::string> tasks;
    for (const auto& [key, cell] : tally.cells())
        tasks.insert(key.task);
    std::vector<TaskResults> results;
    for (const std::string& task : tasks)
        results.push_back(TaskAnalysis(tally, task).run());
    return results;
}

} // namespace teleta::study
