// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace teleta::stiffness {

/// One sample of a touch: torque and angle relative to some origin.
struct TorqueAngle {
    double torque_Nm = 0.0;
    double angle_rad = 0.0;

    bool operator==(const TorqueAngle&) const = default;
};

/// Standard deviations of the noise of both readings. The fitted line depends on their ratio only.
struct ReadingNoise {
    double torque_Nm = 0.0;
    double angle_rad = 0.0;
};

/// Straight line angle = offset + slope torque through points with errors in both readings.
struct ComplianceLine {
    double slope_radPerNm = 0.0;
    double offset_rad = 0.0;
    std::optional<double> slopeSe_radPerNm; ///< from the scatter about the line; empty for two points
    double torqueSpread_Nm = 0.0;           ///< sqrt(sum (torque - mean)^2), without the share of the noise
    double pull_NmPerRad =
        0.0; ///< change in torque, per distance from the line in angle, that moves a point onto the line
    std::size_t points = 0;
    bool correlated = false; ///< the correlation of torque and angle is significant at 95 %

    /// Torque of a point after moving it onto the line along its most likely error.
    [[nodiscard]] double fittedTorque_Nm(const TorqueAngle& point) const {
        return point.torque_Nm +
               pull_NmPerRad * (point.angle_rad - offset_rad - slope_radPerNm * point.torque_Nm);
    }
};

/// Fits the line by maximum likelihood with a known noise ratio (Deming regression). With noise.angle_rad = 0
/// all noise is in the torque, with noise.torque_Nm = 0 all in the angle; if both are 0 the angle counts as
/// exact.
///   se = |slope| sqrt((1 - r^2) / (r^2 (n - 2))),  r the correlation
/// When r is not significant at 95 %, least squares of angle on torque is used instead; it gives a slope near
/// zero whose interval includes zero. Empty for fewer than two points or when all torques are equal. points:
/// finite; summed in the given order. Thread: any (pure). Source: Fuller, Measurement Error Models, section
/// 1.3.
[[nodiscard]] std::optional<ComplianceLine> fitComplianceLine(std::span<const TorqueAngle> points,
                                                              const ReadingNoise& noise);

/// Half width of a 95 % interval in standard errors (Student's t). degreesOfFreedom: those of the estimated
/// standard error; >= 1. Thread: any (pure).
[[nodiscard]] double studentQuantile95(double degreesOfFreedom);

} // namespace teleta::stiffness
