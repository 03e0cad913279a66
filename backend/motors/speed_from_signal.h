// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/motor_recording.h"

#include <span>

namespace teleta::motors {

/// Range of speeds of a vibration motor; slower ones count as rest.
inline constexpr double kSlowestVibration_Hz = 25.0;
inline constexpr double kFastestVibration_Hz = 500.0;

/// Computes the speed of a motor from the signal of an accelerometer or a microphone, in which one turn of
/// the eccentric mass is one period:
///   speed = 1 / (time between two crossings of the zero line upwards)
/// This is the speed in the middle between the two crossings; in between it is interpolated linearly. It is 0
/// while the signal stays within four times its noise, and unknown just before the first and just after the
/// last visible turn. Noise and zero line are measured during the first 0.1 s, in which the drive must be 0.
/// A crossing is interpolated linearly between two samples and counts only when the signal was clearly below
/// and is then clearly above the noise. Returns a speed for every sample. Error: refused: the recording does
/// not begin at rest, has fewer than eight samples per turn, is clipped or shows no vibration. Thread: any
/// (pure).
[[nodiscard]] core::Expected<MotorRecording> speedFromSignal(std::span<const double> time_s,
                                                             std::span<const double> drive,
                                                             std::span<const double> signal);

} // namespace teleta::motors
