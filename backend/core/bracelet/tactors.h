// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace teleta::core {

/// Vibration motors of the bracelet, numbered around the forearm: at 0, 60, ... 300 degrees.
inline constexpr std::size_t kTactors = 6;

/// Intensity of each tactor: 0 off, 1 full strength. One scalar per motor, since the speed and the strength
/// of an eccentric mass motor rise together.
using Intensities = std::array<double, kTactors>;

} // namespace teleta::core
