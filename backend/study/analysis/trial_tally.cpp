// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trial_tally.h"

#include <QString>

#include <algorithm>

namespace teleta::study {

bool TrialTally::add(const TalliedTrial& trial) {
    const std::size_t stimulus = indexOf(trial.stimulus);
    const std::size_t response = trial.response.empty() ? kNone : indexOf(trial.response);
    if (m_names.size() > kMostNames)
        return false;
    const auto isLast = [&](const Key& key) {
        return key.participant == trial.participant && key.task == trial.task &&
               key.condition == trial.condition && key.phase == trial.phase;
    };
    if (m_last == nullptr || !isLast(m_last->first)) {
        Key key{std::string(trial.participant), std::string(trial.task), std::string(trial.condition),
                trial.phase};
        m_last = &*m_cells.try_emplace(std::move(key)).first;
    }
    Cell& cell = m_last->second;
    const std::pair answer(stimulus, response);
    const auto found = std::ranges::find(cell.counts, answer, &decltype(cell.counts)::value_type::first);
    if (found != cell.counts.end())
        ++found->second;
    else
        cell.counts.emplace_back(answer, 1);
    if (trial.phase == Phase::test && stimulus == response && trial.responseTime_s)
        cell.correctTimes_s.push_back(*trial.responseTime_s);
    return true;
}

void TrialTally::add(const TrialTally& other) {
    std::vector<std::size_t> own;
    for (const std::string& name : other.m_names)
        own.push_back(indexOf(name));
    for (const auto& [key, from] : other.m_cells) {
        Cell& cell = m_cells[key];
        for (const auto& [answer, count] : from.counts) {
            const std::pair renamed(own[answer.first], answer.second == kNone ? kNone : own[answer.second]);
            const auto found =
                std::ranges::find(cell.counts, renamed, &decltype(cell.counts)::value_type::first);
            if (found != cell.counts.end())
                found->second += count;
            else
                cell.counts.emplace_back(renamed, count);
        }
        cell.correctTimes_s.insert(cell.correctTimes_s.end(), from.correctTimes_s.begin(),
                                   from.correctTimes_s.end());
    }
    for (const auto& [task, known] : other.m_alternatives) {
        Alternatives& alternatives = expected(task);
        for (const std::size_t name : known.patterns)
            alternatives.patterns.insert(own[name]);
        alternatives.count = std::max(alternatives.count, known.count);
    }
}

void TrialTally::addFrames(std::optional<double> longestWrite_ms, std::optional<std::size_t> missed) {
    if (!longestWrite_ms && !missed)
        return;
    ++m_frames.trials;
    if (longestWrite_ms)
        m_frames.longestWrite_ms = std::max(m_frames.longestWrite_ms.value_or(0.0), *longestWrite_ms);
    m_frames.missed += missed.value_or(0);
    m_frames.trialsWithMisses += missed.value_or(0) > 0 ? 1 : 0;
}

TrialTally::Alternatives& TrialTally::expected(std::string_view task) {
    const auto found = m_alternatives.find(task);
    return found != m_alternatives.end() ? found->second
                                         : m_alternatives.try_emplace(std::string(task)).first->second;
}

void TrialTally::expectPattern(std::string_view task, std::string_view pattern) {
    expected(task).patterns.insert(indexOf(pattern));
}

void TrialTally::expectCount(std::string_view task, std::size_t patterns) {
    if (patterns == 0)
        return;
    Alternatives& alternatives = expected(task);
    alternatives.count = std::max(alternatives.count, patterns);
}

const TrialTally::Alternatives* TrialTally::alternatives(std::string_view task) const {
    const auto found = m_alternatives.find(task);
    return found == m_alternatives.end() ? nullptr : &found->second;
}

std::set<std::pair<std::string, std::string>> TrialTally::answersInOtherCase() const {
    std::map<std::string, std::set<std::size_t>> presented;
    for (const auto& [task, alternatives] : m_alternatives)
        presented[task] = alternatives.patterns;
    for (const auto& [key, cell] : m_cells) {
        for (const auto& [answer, count] : cell.counts)
            presented[key.task].insert(answer.first);
    }
    const auto lower = [](const std::string& name) { return QString::fromStdString(name).toLower(); };
    std::set<std::pair<std::string, std::string>> found;
    for (const auto& [key, cell] : m_cells) {
        const std::set<std::size_t>& patterns = presented[key.task];
        for (const auto& [answer, count] : cell.counts) {
            if (answer.second == kNone || patterns.contains(answer.second))
                continue;
            for (const std::size_t pattern : patterns) {
                if (lower(m_names[pattern]) == lower(m_names[answer.second]))
                    found.emplace(m_names[answer.second], m_names[pattern]);
            }
        }
    }
    return found;
}

bool TrialTally::hasTestTrials() const {
    return std::ranges::any_of(m_cells, [](const auto& cell) { return cell.first.phase == Phase::test; });
}

std::size_t TrialTally::indexOf(std::string_view name) {
    const auto found = std::ranges::find(m_names, name);
    const auto index = static_cast<std::size_t>(found - m_names.begin());
    if (found == m_names.end())
        m_names.emplace_back(name);
    return index;
}

} // namespace teleta::study
