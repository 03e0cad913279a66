// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/cost/cost_result.h"
#include "backend/cost/ladder.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace teleta::cost {

struct MeasureProgress {
    std::string ladder;
    std::string rung;
    double share = 0.0; ///< of all ladders, 0..1
};

struct MeasureSettings {
    /// A rung's times are refused when the machine ran more unevenly than this (RungCost::spread). A trial of
    /// which others computed a larger share is timed again.
    double largestSpread = 0.25;
    /// How often a rung is measured anew before its times are refused; >= 1.
    int attempts = 3;
    /// Called before every trial; false ends the measuring.
    std::function<bool(const MeasureProgress&)> goOn;
};

struct Measurement {
    std::vector<LadderCost> ladders; ///< with the rungs that were measured
    double wall_s = 0.0;
    bool interrupted = false;

    /// Rungs whose times were refused.
    [[nodiscard]] std::size_t refused() const;
};

/// How often a trial is timed again before its time counts as it is.
inline constexpr int kMostRepeats = 3;

/// Untimed trials before the timed ones of each rung.
inline constexpr std::size_t kWarmUps = 3;

/// Measures ladders one after the other, their rungs one after the other: warm-up, then Ladder::trials timed
/// ones. Times are of the steady clock in the calling thread, OpenCV's threads are set to one meanwhile (for
/// the whole program). Errors are those of all timed trials. The quantiles are linear between order
/// statistics (type 7 of Hyndman and Fan).
/// Before each trial a loop that always does the same is timed. The spread of a rung is the largest one of
///   quartile distance of these times over their median,  median share of a trial that others computed,
///   median of these times over the least one of all rungs, less 1: the machine ran slower than for others
/// A trial that was disturbed is timed again with the same inputs; its errors are those of the first time.
/// Where one stays disturbed, the 99 % quantile is not known. An interrupted ladder has no frontier. Error:
/// that of a ladder that cannot be made. Thread: any, one at a time; keeps one core busy.
[[nodiscard]] core::Expected<Measurement> measureLadders(std::span<const Ladder> ladders,
                                                         const MeasureSettings& settings = {});

/// Refuses the times of rungs during which the machine ran slower than during the quickest one by more than
/// the share largestSpread, widens their spread to that, and marks the frontiers anew. loops_s: medians of
/// the loop, > 0, of the rungs of all ladders in their order. Thread: any (pure).
void refuseSlowed(std::span<LadderCost> ladders, std::span<const double> loops_s, double largestSpread);

} // namespace teleta::cost
