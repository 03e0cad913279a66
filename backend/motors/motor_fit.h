// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/motors/lag_fit.h"
#include "backend/motors/motor_recording.h"
#include "backend/pattern/motors/motor_model.h"

#include <vector>

namespace teleta::motors {

/// A motor as a recording shows it.
struct MotorFit {
    pattern::MotorProfile profile; ///< measured; its name is empty, its full drive 1
    double startLow = 0.0;         ///< highest drive at which it stood
    double startHigh = 0.0;        ///< lowest drive at which it started
    double startError = 0.0;       ///< standard error, of a start that is anywhere between the two
    double riseError_s = 0.0;
    double fallError_s = 0.0;
    std::vector<SpeedLevel> levels;   ///< steady speeds as they were measured
    double residual_Hz = 0.0;         ///< root mean square while it turns
    double explained = 0.0;           ///< share of the variance, 0.9 .. 1
    std::vector<double> predicted_Hz; ///< by the model, one a sample of the recording
};

/// Start, rise, fall and speed curve of a motor from a staircase of drives that begins at rest, goes up to
/// the full drive, and falls at least once (Excitation). Plateaus of equal drive, 0.08 s and longer, are the
/// levels of the curve:
///   start = middle between the highest drive at which the motor stood and the lowest at which it started
///   from
///           rest, standard error (high - low) / sqrt(12)
///   rise = tau_up ln 10, fall = tau_down ln 10, curve: fitLag, pooled where noise makes it fall
/// A motor stands when it is slower than 5 % of its highest speed. Drives below the start at which it only
/// goes on turning are left out. Error: badInput or refused, with what is missing: samples that are no
/// numbers or out of order, too few, no rest, no step, no full drive, one level only, no fall, a motor that
/// does not turn, a speed that is clipped or saturated, a start that contradicts itself, a lag that the
/// samples do not tell to a quarter of itself, a motor that does not follow the model. Thread: any (pure).
[[nodiscard]] core::Expected<MotorFit> fitMotor(const MotorRecording& recording);

} // namespace teleta::motors
