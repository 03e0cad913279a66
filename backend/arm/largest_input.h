// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::arm {

/// Larger inputs are refused, so that no product of a few of them overflows.
inline constexpr double kLargestInput = 1e100;

} // namespace teleta::arm
