// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/lag_fit.h"
#include "backend/motors/motor_recording.h"
#include "backend/pattern/motors/motor_model.h"

#include <vector>

namespace teleta::motors {

/// A motor profile identified from a recording.
struct MotorFit {
    pattern::MotorProfile profile; ///< measured profile, without a name and with full drive 1
    double startLow = 0.0;         ///< highest drive at which the motor stood still
    double startHigh = 0.0;        ///< lowest drive at which the motor started
    double startError = 0.0;       ///< standard error of a start uniformly distributed between the two
    double riseError_s = 0.0;
    double fallError_s = 0.0;
    double gapShare = 0.0;            ///< share of the time in gaps: longer than three typical intervals
    std::vector<SpeedLevel> levels;   ///< measured steady speeds
    double residual_Hz = 0.0;         ///< root mean square while the motor turns
    double explained = 0.0;           ///< explained share of the variance, 0.9 .. 1
    std::vector<double> predicted_Hz; ///< speed by the model, one entry per sample
};

/// Identifies start, rise, fall and speed curve of a motor from a staircase of drives that begins at rest,
/// reaches the full drive and falls at least once (Excitation). Plateaus of equal drive of 0.08 s or more are
/// the levels of the curve:
///   start = middle between the highest drive at which the motor stood and the lowest at which it started
///   from
///           rest, standard error (high - low) / sqrt(12)
///   rise = tau_up ln 10, fall = tau_down ln 10, curve: fitLag, pooled where noise makes it fall
/// A motor stands still when it is slower than 5 % of its highest speed. Plateaus below the start on which it
/// only continues to turn are left out. A change of the drive within a gap between the samples does not count
/// for the lag. Error: badInput or refused with the reason: non-finite or unordered
/// samples; too few samples; no rest, step, full drive or fall; a single level; the motor does not turn; the
/// speed is clipped or saturated; the start is contradictory; the lag is uncertain by more than a quarter;
/// the motor does not follow the model. Thread: any (pure).
[[nodiscard]] core::Expected<MotorFit> fitMotor(const MotorRecording& recording);

} // namespace teleta::motors
