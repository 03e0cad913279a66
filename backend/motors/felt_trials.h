// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace teleta::motors {

/// One presentation and its answer.
struct FeltTrial {
    double drive = 0.0;
    bool yes = false;     ///< "I felt it", or "the second one was stronger"
    bool isCatch = false; ///< nothing was presented, so that yes is a false alarm

    bool operator==(const FeltTrial&) const = default;
};

struct StaircaseRules {
    double lowest = 0.01;
    double highest = 1.0;
    double first = 0.6;
    double firstStep = 0.16;
    double smallestStep = 0.01;
    int reversals = 12;  ///< number of reversals after which it is done
    int mostTrials = 60; ///< without the catch trials
    int catchEvery = 7;  ///< every catchEvery-th presentation is a catch trial; 0: none
};

/// Staircase that decides which drive is presented next: down after a yes, up after a no, with the step
/// halved at each reversal. Answers can be undone. Thread: one. Source: Levitt, Transformed up-down methods
/// (1971), simple up-down method.
class FeltTrials {
public:
    explicit FeltTrials(const StaircaseRules& rules = {});

    /// Drive to present next; 0 for a catch trial.
    [[nodiscard]] double drive() const;
    [[nodiscard]] bool isCatch() const;
    [[nodiscard]] bool done() const;
    /// Ignored when done.
    void answer(bool yes);
    /// Undoes the last answer. Returns false when there is none.
    bool undo();

    [[nodiscard]] const std::vector<FeltTrial>& trials() const { return m_trials; }
    [[nodiscard]] int reversals() const { return m_reversals; }
    /// Estimated progress, 0 .. 1.
    [[nodiscard]] double progress() const;

private:
    void replay();

    StaircaseRules m_rules;
    std::vector<FeltTrial> m_trials;
    double m_drive = 0.0;
    double m_step = 0.0;
    int m_reversals = 0;
    int m_presented = 0; ///< not counting catch trials
};

} // namespace teleta::motors
