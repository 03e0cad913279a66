// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/trial_origins.h"
#include "backend/study/protocol/trial.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::study {

/// A completed trial for the analysis.
struct TalliedTrial {
    std::string_view participant;
    std::string_view task;
    std::string_view condition;
    Phase phase = Phase::test;
    std::string_view stimulus;
    std::string_view response;            ///< empty: none in time
    std::optional<double> responseTime_s; ///< from the onset
};

/// Counts trials by participant, task, condition and phase. Memory grows with these and by one number per
/// correct test trial. Thread: one.
class TrialTally {
public:
    struct Key {
        std::string participant;
        std::string task;
        std::string condition;
        Phase phase = Phase::test;
        auto operator<=>(const Key&) const = default;
    };
    struct Cell {
        /// Presented and answered pattern (indices in names(); kNone: no answer) and how often.
        std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::int64_t>> counts;
        std::vector<double> correctTimes_s; ///< test phase only
    };
    static constexpr std::size_t kNone = SIZE_MAX;
    static constexpr std::size_t kMostNames = 1000;

    /// False, and nothing is counted, when there would be more than kMostNames pattern names.
    [[nodiscard]] bool add(const TalliedTrial& trial);

    /// What is known of a task besides its trials: few trials do not show all patterns.
    struct Alternatives {
        std::set<std::size_t> patterns; ///< indices in names()
        std::size_t count = 0;          ///< according to the trials; 0: unknown
    };
    /// Adds all trials and what is known of the tasks, but not where the trials came from. The names of both
    /// together are not limited.
    void add(const TrialTally& other);
    /// Adds a pattern of the task, presented or not.
    void expectPattern(std::string_view task, std::string_view pattern);
    /// The task has at least this many patterns.
    void expectCount(std::string_view task, std::size_t patterns);
    /// Null: nothing is known besides the trials.
    [[nodiscard]] const Alternatives* alternatives(std::string_view task) const;

    /// Where the counted trials came from; maintained by whoever adds them.
    [[nodiscard]] TrialOrigins& origins() { return m_origins; }

    /// Frame statistics of the stimuli, where known.
    struct Frames {
        std::size_t trials = 0;                ///< with frame statistics
        std::optional<double> longestWrite_ms; ///< empty: not timed
        std::size_t missed = 0;
        std::size_t trialsWithMisses = 0;
    };
    void addFrames(std::optional<double> longestWrite_ms, std::optional<std::size_t> missed);
    [[nodiscard]] const Frames& frames() const { return m_frames; }

    /// Answers that no pattern of their task has, but one with letters of another case: answer and pattern.
    /// They count as wrong.
    [[nodiscard]] std::set<std::pair<std::string, std::string>> answersInOtherCase() const;
    [[nodiscard]] bool hasTestTrials() const;

    [[nodiscard]] const std::map<Key, Cell>& cells() const { return m_cells; }
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }

private:
    [[nodiscard]] std::size_t indexOf(std::string_view name);

    [[nodiscard]] Alternatives& expected(std::string_view task);

    TrialOrigins m_origins;
    Frames m_frames;
    std::map<std::string, Alternatives, std::less<>> m_alternatives; ///< by task
    std::map<Key, Cell> m_cells;
    std::vector<std::string> m_names;
    std::pair<const Key, Cell>* m_last = nullptr; ///< rows of a file are grouped by session
};

} // namespace teleta::study
