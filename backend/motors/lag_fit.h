// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/motors/motor_recording.h"

#include <optional>
#include <span>
#include <vector>

namespace teleta::motors {

/// A steady speed and its standard error.
struct SpeedLevel {
    double drive = 0.0;
    double speed_Hz = 0.0;
    double error_Hz = 0.0;

    bool operator==(const SpeedLevel&) const = default;
};

/// Time constants and steady speeds with their standard errors.
struct LagFit {
    double up_s = 0.0;
    double upError_s = 0.0;
    double down_s = 0.0;
    double downError_s = 0.0;
    std::vector<SpeedLevel> levels;
    double residual_Hz = 0.0;         ///< root mean square, of the samples in which the motor turns
    double explained = 0.0;           ///< share of the variance of the speed that the model explains
    std::vector<double> predicted_Hz; ///< one a sample
};

/// Fits the lag of pattern::MotorModel and the steady speeds to a recording that begins at rest:
///   speed' = (steady(drive) - speed) / tau,   tau = up where the steady speed is above, down where it is
///   below
/// steady: 0 below `start`, else straight lines through the levels. All levels and both time constants are
/// fitted together (Levenberg-Marquardt; the model is integrated without error between samples), so a level
/// need not have settled. Standard errors come from the residuals, widened by their autocorrelation.
/// levels: at least two, rising, with a first guess of the speeds. ignored: samples whose speed is taken as
/// it was measured; unknown ones count for nothing. Empty: the equations are singular (a time constant that
/// nothing depends on). Thread: any.
[[nodiscard]] std::optional<LagFit> fitLag(const MotorRecording& recording, double start,
                                           const std::vector<SpeedLevel>& levels,
                                           const std::vector<bool>& ignored);

} // namespace teleta::motors
