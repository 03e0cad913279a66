// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace teleta::stiffness {

/// A point of the touch: torque and angle about some origin.
struct TorqueAngle {
    double torque_Nm = 0.0;
    double angle_rad = 0.0;

    bool operator==(const TorqueAngle&) const = default;
};

/// Standard deviations of the noise of both readings; only their ratio moves the line.
struct ReadingNoise {
    double torque_Nm = 0.0;
    double angle_rad = 0.0;
};

/// Straight line angle = offset + slope torque through points with errors in both readings.
struct ComplianceLine {
    double slope_radPerNm = 0.0;
    double offset_rad = 0.0;
    std::optional<double> slopeSe_radPerNm; ///< from the scatter about the line; empty for two points
    double torqueSpread_Nm = 0.0;           ///< sqrt(sum (torque - mean)^2) without the noise's share
    double pull_NmPerRad = 0.0; ///< how far a point moves in torque, per distance in angle, onto the line
    std::size_t points = 0;
    bool correlated = false; ///< torque and angle change together, significant at 95 %

    /// Torque of a point after it was moved onto the line along its likeliest error.
    [[nodiscard]] double fittedTorque_Nm(const TorqueAngle& point) const {
        return point.torque_Nm +
               pull_NmPerRad * (point.angle_rad - offset_rad - slope_radPerNm * point.torque_Nm);
    }
};

/// Fits the line by maximum likelihood with a known noise ratio (Deming): the torque carries all of it when
/// noise.angle_rad is 0, the angle when noise.torque_Nm is 0; both 0 count as an exact angle.
///   se = |slope| sqrt((1 - r^2) / (r^2 (n - 2))),  r the correlation
/// When torque and angle do not correlate (r not significant at 95 %), least squares of angle on torque is
/// used: a slope about zero with an error that spans it. Empty when there are fewer than two points or no two
/// torques differ. points: finite. The sums run in the order given. Thread: any (pure). Source: Fuller,
/// Measurement Error Models, section 1.3.
[[nodiscard]] std::optional<ComplianceLine> fitComplianceLine(std::span<const TorqueAngle> points,
                                                              const ReadingNoise& noise);

/// Half width of a 95 % interval in standard errors for an error that was estimated with so many degrees of
/// freedom. degreesOfFreedom: >= 1.
[[nodiscard]] double studentQuantile95(double degreesOfFreedom);

} // namespace teleta::stiffness
