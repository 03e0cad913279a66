// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace teleta::core {

/// Vibration motors of the bracelet, numbered around the forearm: at 0, 60, ... 300 degrees.
inline constexpr std::size_t kTactors = 6;

/// What each tactor shall do: 0 off, 1 as strong as it can. One scalar a motor, since the speed of an
/// eccentric mass motor and its strength rise together.
using Intensities = std::array<double, kTactors>;

} // namespace teleta::core
