// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

namespace teleta::core {

/// Vibration motors of the bracelet, numbered around the forearm: at 0, 60, ... 300 degrees.
inline constexpr std::size_t kTactors = 6;

/// Intensity of each tactor: 0 off, 1 full strength. One scalar per motor, since the speed and the strength
/// of an eccentric mass motor rise together.
using Intensities = std::array<double, kTactors>;

/// Angle between neighbouring tactors around the arm.
inline constexpr double kTactorAngle_rad = 2.0 * std::numbers::pi / static_cast<double>(kTactors);

/// Place of a tactor in the ring, counted on in either direction: -1 is the last one, kTactors the first.
[[nodiscard]] constexpr std::size_t wrappedTactor(long tactor) {
    constexpr long ring = static_cast<long>(kTactors);
    return static_cast<std::size_t>((tactor % ring + ring) % ring);
}

} // namespace teleta::core
