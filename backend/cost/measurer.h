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
    /// A rung's times are refused when the machine ran more unevenly than this (RungCost::spread).
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

/// Untimed trials before the timed ones of each rung.
inline constexpr std::size_t kWarmUps = 3;

/// Measures ladders one after the other, their rungs one after the other: warm-up, then Ladder::trials timed
/// ones. Times are of the steady clock in the calling thread, OpenCV's threads are set to one meanwhile (for
/// the whole program). Errors are those of all timed trials. The quantiles are linear between order
/// statistics (type 7 of Hyndman and Fan).
/// Before each trial a loop that always does the same is timed. The spread of a rung is the larger one of
///   quartile distance of these times over their median,  median share of a trial that others computed
/// Error: that of a ladder that cannot be made. Thread: any, one at a time; keeps one core busy.
[[nodiscard]] core::Expected<Measurement> measureLadders(std::span<const Ladder> ladders,
                                                         const MeasureSettings& settings = {});

} // namespace teleta::cost
