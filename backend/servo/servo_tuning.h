// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_task.h"

namespace teleta::servo {

/// Settings that an operator can change while a servo runs.
struct ServoTuning {
    static constexpr double kLeastForce_N = 0.5;
    static constexpr double kHighestForce_N = 15.0;
    static constexpr double kHighestSlide_mPerS = 0.020;
    static constexpr double kLeastGain = 0.1;
    static constexpr double kHighestGain = 3.0;

    double force_N = 5.0;
    double slide_mPerS = 0.005; ///< along an edge; 0: the sensor does not slide
    double gain = 1.0;          ///< factor on all gains of the plan
    bool moment = true;         ///< DZMP turns the sensor about y; false: the baseline

    bool operator==(const ServoTuning&) const = default;
};

/// Bounds of the tuning of a plan: the usual ones, widened to the values of the plan itself.
struct TuningBounds {
    double leastForce_N = ServoTuning::kLeastForce_N;
    double highestForce_N = ServoTuning::kHighestForce_N;
    double highestSlide_mPerS = ServoTuning::kHighestSlide_mPerS;

    bool operator==(const TuningBounds&) const = default;
};
[[nodiscard]] TuningBounds boundsOf(const ServoPlan& plan);

/// Clamps a tuning to the bounds; non-finite values become the default.
[[nodiscard]] ServoTuning clamped(const ServoTuning& tuning, const TuningBounds& bounds = {});

/// Whether ServoTuning::moment acts in a task of this kind.
[[nodiscard]] bool turnsByMoment(TaskKind kind);

/// The tuning that leaves a plan as it is.
[[nodiscard]] ServoTuning tuningOf(const ServoPlan& plan);

/// The plan with the force, sliding speed and gains of a tuning, clamped to its bounds; a plan that passes
/// check() still passes. The gain that sets the sliding speed is not multiplied. Gains are limited to
/// highestGain(). Tasks without contact are not changed. Thread: any (pure).
[[nodiscard]] ServoPlan tuned(const ServoPlan& plan, const ServoTuning& tuning);

} // namespace teleta::servo
