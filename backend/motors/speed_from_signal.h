// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/motor_recording.h"

#include <span>

namespace teleta::motors {

/// Speeds that count as those of a vibration motor; what is slower is rest.
inline constexpr double kSlowestVibration_Hz = 25.0;
inline constexpr double kFastestVibration_Hz = 500.0;

/// The speed of a motor from what an accelerometer or a microphone picked up: one turn of the eccentric mass
/// is one period, so that
///   speed = 1 / (time between two crossings of the zero line upwards)
/// in the middle of the two, straight lines between, and 0 while the signal stays within four times its
/// noise; unknown shortly before the first turn that is seen and after the last one. Noise and zero are those
/// of the beginning, during which the drive must be 0 for 0.1 s. Each crossing is found between two samples
/// by a line, and counts only after the signal was clearly below and is clearly above the noise. Returns a
/// speed for every sample. Error: refused: it does not begin at rest, fewer than eight samples a turn,
/// clipped, no vibration. Thread: any (pure).
[[nodiscard]] core::Expected<MotorRecording> speedFromSignal(std::span<const double> time_s,
                                                             std::span<const double> drive,
                                                             std::span<const double> signal);

} // namespace teleta::motors
