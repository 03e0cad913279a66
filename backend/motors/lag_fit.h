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
    double residual_Hz = 0.0;         ///< root mean square over the samples in which the motor turns
    double explained = 0.0;           ///< share of the variance of the speed that the model explains
    std::vector<double> predicted_Hz; ///< one entry per sample
};

/// Fits the lag of MotorModel and the steady speeds to a recording that begins at rest:
///   speed' = (steady(drive) - speed) / tau,   tau = up where the steady speed is above, down where it is
///   below
/// steady: 0 below `start`, otherwise linear between the levels. All levels and both time constants are
/// fitted together (Levenberg-Marquardt; the model is integrated exactly between samples), so a level need
/// not have settled. When the drive changes, it acts somewhere between the last sample with the old drive and
/// the first with the new one; where on average is fitted too. Standard errors of the time constants are the
/// larger of two: from the residuals, widened by their autocorrelation, and from the scatter between the
/// steps (jackknife to first order: Cameron and Miller, Journal of Human Resources 50 (2015) 317). levels: at
/// least two, rising, with first guesses of the speeds. ignored: samples whose measured speed is taken over;
/// unknown samples are not used. Empty when the equations are singular: nothing depends on a time constant.
/// Thread: any (pure).
[[nodiscard]] std::optional<LagFit> fitLag(const MotorRecording& recording, double start,
                                           const std::vector<SpeedLevel>& levels,
                                           const std::vector<bool>& ignored);

} // namespace teleta::motors
