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

/// A completed trial as the analysis sees it.
struct TalliedTrial {
    std::string_view participant;
    std::string_view task;
    std::string_view condition;
    Phase phase = Phase::test;
    std::string_view stimulus;
    std::string_view response;            ///< empty: none in time
    std::optional<double> responseTime_s; ///< from the onset
};

/// Counts trials by participant, task, condition and phase. Memory grows with these and by one number for
/// each correct test trial, not with anything else of the rows. Thread: one.
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

    /// False, and nothing is counted, when more than kMostNames patterns have different names.
    [[nodiscard]] bool add(const TalliedTrial& trial);

    /// What a task has besides what was seen of it: few trials do not show all of it.
    struct Alternatives {
        std::set<std::size_t> patterns; ///< indices in names()
        std::size_t count = 0;          ///< as the trials say; 0: nothing
    };
    /// A pattern that the task has, presented or not.
    void expectPattern(std::string_view task, std::string_view pattern);
    /// The task has at least so many patterns, whatever their names are.
    void expectCount(std::string_view task, std::size_t patterns);
    /// Null: nothing but the trials is known of it.
    [[nodiscard]] const Alternatives* alternatives(std::string_view task) const;

    /// Where what is counted came from; whoever adds trials keeps it.
    [[nodiscard]] TrialOrigins& origins() { return m_origins; }

    /// How the stimuli came to the bracelet, where it is known.
    struct Frames {
        std::size_t trials = 0;                ///< of which it is known
        std::optional<double> longestWrite_ms; ///< empty: no write of a frame was timed
        std::size_t missed = 0;
        std::size_t trialsWithMisses = 0;
    };
    void addFrames(std::optional<double> longestWrite_ms, std::optional<std::size_t> missed);
    [[nodiscard]] const Frames& frames() const { return m_frames; }

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
    std::pair<const Key, Cell>* m_last = nullptr; ///< rows of a file come session by session
};

} // namespace teleta::study
