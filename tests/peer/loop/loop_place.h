// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace teleta::test {

/// The robot's links, and where its pad is: below the forearm.
inline constexpr double kUpperArm_m = 0.30;
inline constexpr double kHalfThickness_m = 0.03;
inline constexpr double kPad_m = 0.175; ///< from the elbow to the pad's centre
inline constexpr double kPitch_m = 0.0034;

/// Turns of the arm at which something stands. The operator knows neither which of the objects it is, nor its
/// place to the mm.
inline constexpr std::array<double, 3> kBearing_rad{-0.6, 0.0, 0.6};
inline constexpr double kLifted_rad = -0.1; ///< of the elbow, above all that stands there

} // namespace teleta::test
