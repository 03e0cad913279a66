// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/track.h"
#include "backend/study/protocol/level_task.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// A completed test trial with a level.
struct LevelTrial {
    KeptTrial kept;                    ///< `counts` is false for catch and same trials
    std::optional<std::size_t> right;  ///< index of the right answer; empty: unknown
    std::optional<std::size_t> answer; ///< empty: none in time, or unknown
    std::size_t run = 1;               ///< of an adaptive track that is repeated
    bool scored = true;                ///< false: of an equal pair no answer is right
    bool isExcluded = false;           ///< by a rule: it was shown, but says nothing
};

/// What a trial of a design says. right, answer: indices of answersOf(); empty answer: none in time. Empty
/// for a comparison without an answer, which says nothing. Thread: any (pure).
[[nodiscard]] std::optional<LevelTrial> levelTrialOf(Design design, double level, double reference,
                                                     std::size_t right, std::optional<std::size_t> answer);

/// The same of a trial of which only "right or wrong" is known: of yes_no and same_different those at the
/// reference are the ones with nothing or the same; of compare "right" is judged by the reference. design
/// empty: correct answers count as they are. Thread: any (pure).
[[nodiscard]] LevelTrial levelTrialOf(std::optional<Design> design, double level, double reference,
                                      bool correct);

/// What is known of a task with levels.
struct LevelTaskFacts {
    std::optional<Design> design;      ///< empty: a table that does not say
    std::size_t intervals = 0;         ///< answers to choose from, of interval; 0: unknown
    std::string unit;                  ///< of the level; empty: unknown
    std::string procedure;             ///< constant, staircase, bayes; empty: unknown
    std::optional<LevelScale> scale;   ///< of a protocol; empty: usualScale()
    std::optional<LevelRange> range;   ///< with settings
    std::optional<Procedure> settings; ///< of a protocol
};

/// Test trials with levels, by participant, task, condition and track. Thread: one.
class LevelTrials {
public:
    struct Key {
        std::string task;
        std::string condition;
        std::string track;
        std::string participant;
        auto operator<=>(const Key&) const = default;
    };
    struct Track {
        double reference = 0.0;
        std::vector<LevelTrial> trials; ///< in their order, excluded ones too

        /// Those that count.
        [[nodiscard]] std::vector<LevelTrial> left() const;
    };

    [[nodiscard]] LevelTaskFacts& factsOf(std::string_view task);
    [[nodiscard]] const LevelTaskFacts& factsOf(const std::string& task) const { return m_facts.at(task); }
    [[nodiscard]] Track& trackOf(const Key& key) { return m_tracks[key]; }
    [[nodiscard]] const std::map<Key, Track>& tracks() const { return m_tracks; }
    [[nodiscard]] bool empty() const { return m_tracks.empty(); }
    /// The same trials, of which all count; empty: no rule left one out.
    [[nodiscard]] std::optional<LevelTrials> withoutRules() const;

private:
    std::map<std::string, LevelTaskFacts, std::less<>> m_facts;
    std::map<Key, Track> m_tracks;
};

/// The scale of levels where only a table is known: log10 for a drive or an unknown unit with all levels
/// above 0, except in comparisons; otherwise linear. Thread: any (pure).
[[nodiscard]] LevelScale usualScale(const LevelTaskFacts& facts, double lowestLevel);

} // namespace teleta::study
