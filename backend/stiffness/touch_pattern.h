// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/free_motion.h"
#include "backend/stiffness/loading_ramp.h"

#include <cstddef>
#include <optional>
#include <span>

namespace teleta::stiffness {

/// What a touch shows that a spring would not.
struct TouchPattern {
    bool rateDependent = false;
    bool stickSlip = false;
    double softening = 0.0; ///< by how much the rise is less steep at its end, over its mean slope
    /// Samples after the loading in which the joint stood still; equal: there are none.
    std::size_t holdBegin = 0;
    std::size_t holdEnd = 0;
};

/// What pattern a touch has.
///   rate dependence   the torque over angle of the whole rise flattens by more than a tenth; or the torque
///                     decays while the joint stands still; or unloading has another slope than loading
///   stick-slip        the torque jumps twice or more; or falls back by a quarter of the window in the rise;
///                     or differs between forward and backward motion
/// Each only where it is over 3.5 to 4 standard errors of the noise; jumps and falls over 7 and 8 standard
/// deviations. touch: with a rise of 20 samples or
/// more, else nothing is seen; contact: index of the first sample of the contact, at most touch.first;
/// noise_Nm: standard deviation of the torque about a line, inflation: varianceInflation() of it;
/// stiffness_NmPerRad: slope of torque over angle in the window, > 0. Thread: any (pure).
[[nodiscard]] TouchPattern examineTouch(const OrderedTouch& touch, std::size_t contact, double noise_Nm,
                                        double inflation, double stiffness_NmPerRad,
                                        const TorqueWindow& window);

} // namespace teleta::stiffness
