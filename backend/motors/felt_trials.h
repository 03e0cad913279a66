// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace teleta::motors {

/// One presentation and its answer.
struct FeltTrial {
    double drive = 0.0;
    bool yes = false;     ///< "I felt it", or "the second one was stronger"
    bool isCatch = false; ///< nothing was presented: yes is a false alarm

    bool operator==(const FeltTrial&) const = default;
};

struct StaircaseRules {
    double lowest = 0.01;
    double highest = 1.0;
    double first = 0.6;
    double firstStep = 0.16;
    double smallestStep = 0.01;
    int reversals = 12;  ///< after so many it is done
    int mostTrials = 60; ///< without the catch trials
    int catchEvery = 7;  ///< every so many presentations nothing is presented; 0: never
};

/// Which drive a person is asked about next: down after a yes, up after a no; the step is halved at each
/// reversal. Answers can be undone. Pure. Source: Levitt, Transformed up-down methods (1971), the simple one.
class FeltTrials {
public:
    explicit FeltTrials(const StaircaseRules& rules = {});

    /// What is to be presented; 0 for a catch trial.
    [[nodiscard]] double drive() const;
    [[nodiscard]] bool isCatch() const;
    [[nodiscard]] bool done() const;
    /// Ignored when done.
    void answer(bool yes);
    /// Takes the last answer back. False: there is none.
    bool undo();

    [[nodiscard]] const std::vector<FeltTrial>& trials() const { return m_trials; }
    [[nodiscard]] int reversals() const { return m_reversals; }
    /// 0 .. 1, an estimate.
    [[nodiscard]] double progress() const;

private:
    void replay();

    StaircaseRules m_rules;
    std::vector<FeltTrial> m_trials;
    double m_drive = 0.0;
    double m_step = 0.0;
    int m_reversals = 0;
    int m_presented = 0; ///< without the catch trials
};

} // namespace teleta::motors
