// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

namespace teleta::servo {

/// What an operator changes while a servo runs.
struct ServoTuning {
    static constexpr double kLeastForce_N = 0.5;
    static constexpr double kHighestForce_N = 15.0;
    static constexpr double kHighestSlide_mPerS = 0.020;
    static constexpr double kLeastGain = 0.1;
    static constexpr double kHighestGain = 3.0;

    double force_N = 5.0;
    double slide_mPerS = 0.005; ///< along an edge; 0: stands still there
    double gain = 1.0;          ///< factor on all gains of the plan
    bool moment = true;         ///< DZMP turns the sensor about y; false: as the baseline

    bool operator==(const ServoTuning&) const = default;
};

/// How far an operator may go with a plan: the usual bounds, and what the plan itself wants beyond them.
struct TuningBounds {
    double leastForce_N = ServoTuning::kLeastForce_N;
    double highestForce_N = ServoTuning::kHighestForce_N;
    double highestSlide_mPerS = ServoTuning::kHighestSlide_mPerS;

    bool operator==(const TuningBounds&) const = default;
};
[[nodiscard]] TuningBounds boundsOf(const ServoPlan& plan);

/// Within the bounds; what is not finite becomes the default.
[[nodiscard]] ServoTuning clamped(const ServoTuning& tuning, const TuningBounds& bounds = {});

/// What a plan is tuned to as it comes.
[[nodiscard]] ServoTuning tuningOf(const ServoPlan& plan);

/// A plan with other forces, sliding speed and gains, within its bounds; it stays good for check() when it
/// was. The gain of a slide is that of its speed and not multiplied. Gains stop at highestGain(). Tasks
/// without contact keep everything.
[[nodiscard]] ServoPlan tuned(const ServoPlan& plan, const ServoTuning& tuning);

} // namespace teleta::servo
