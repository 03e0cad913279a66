// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/motors/motor_model.h"

#include <algorithm>
#include <cmath>

namespace teleta::pattern {

/// Ticks a second of written files, and of files that do not say.
inline constexpr int kHjifTimescale = 1000;

/// Masks of ISO/IEC 23090-31.
inline constexpr int kHjifRightForearm = 0x1000;
inline constexpr int kHjifLeftForearm = 0x2000;
inline constexpr int kHjifLeftWrist = 0x8000;

/// The frequency that is written with an intensity: that of the motor in steady state.
[[nodiscard]] inline long hjifFrequency_Hz(const MotorProfile& motor, double intensity) {
    return std::lround(steadySpeed_Hz(motor, driveOf(motor, std::max(intensity, 1e-9))));
}

} // namespace teleta::pattern
