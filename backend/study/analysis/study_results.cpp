// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"

#include <algorithm>
#include <limits>
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
    /// Shares of correct answers: a row per participant; columns: conditions, and these patterns within each.
    /// NaN where a pattern was not presented.
    [[nodiscard]] ParticipantCells accuracies(const std::vector<std::size_t>& patterns) const;
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
        if (key.phase == Phase::test)
            m_results.participants.push_back({key.participant, key.condition, matrix,
                                              median(cell.correctTimes_s), cell.correctTimes_s.size()});
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
        group.accuracy = groupMean(accuracies);
        group.transfer = studyTransfer(matrices, m_results.alternatives());
        m_results.groups.push_back(std::move(group));
    }
}

ParticipantCells TaskAnalysis::accuracies(const std::vector<std::size_t>& patterns) const {
    const std::size_t columns = m_results.groups.size() * patterns.size();
    ParticipantCells cells(m_people.size(),
                           std::vector<double>(columns, std::numeric_limits<double>::quiet_NaN()));
    for (const ParticipantSummary& participant : m_results.participants) {
        const auto row = std::lower_bound(m_people.begin(), m_people.end(), participant.participant);
        const auto group =
            std::ranges::find(m_results.groups, participant.condition, &GroupSummary::condition);
        const auto condition = static_cast<std::size_t>(group - m_results.groups.begin());
        for (std::size_t j = 0; j < patterns.size(); ++j) {
            if (const std::optional<double> percent = participant.matrix.rowPercent(patterns[j], patterns[j]))
                cells[static_cast<std::size_t>(row - m_people.begin())][condition * patterns.size() + j] =
                    *percent / 100.0;
        }
    }
    return cells;
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
    std::vector<std::size_t> presented;
    for (std::size_t i = 0; i < m_results.patterns.size(); ++i) {
        if (std::ranges::any_of(m_results.groups,
                                [&](const GroupSummary& group) { return group.matrix.rowTotal(i) > 0; }))
            presented.push_back(i);
    }
    if (presented.empty())
        return;
    const auto addOneWay = [&](const char* effect, const std::string& stimulus,
                               const std::vector<std::size_t>& patterns) {
        const ParticipantCells cells = accuracies(patterns);
        const auto table = oneWayAnova(cells);
        addLine(effect, stimulus, table ? table->effect : AnovaRow(tl::unexpected(table.error())), cells);
    };
    if (m_results.groups.size() < 2) {
        addOneWay("pattern", "", presented);
        return;
    }
    const ParticipantCells cells = accuracies(presented);
    const auto table = twoWayAnova(cells, m_results.groups.size(), presented.size());
    const auto addTwoWay = [&](const char* effect, AnovaRow TwoWayAnova::*row) {
        addLine(effect, "", table ? (*table).*row : AnovaRow(tl::unexpected(table.error())), cells);
    };
    addTwoWay("condition", &TwoWayAnova::first);
    addTwoWay("pattern", &TwoWayAnova::second);
    addTwoWay("condition:pattern", &TwoWayAnova::interaction);
    for (const std::size_t pattern : presented)
        addOneWay("condition", m_results.patterns[pattern], {pattern});
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
