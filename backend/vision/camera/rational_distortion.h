// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace teleta::vision {

/// Rational lens distortion with eight parameters, on the plane at unit distance in front of the camera:
///   s = x^2 + y^2,  q = (1 + k1 s + k2 s^2 + k3 s^3) / (1 + k4 s + k5 s^2 + k6 s^3)
///   x'' = q x + 2 p1 x y + p2 (s + 2 x^2),  y'' = q y + p1 (s + 2 y^2) + 2 p2 x y
/// All zero: no distortion. Source: VTacArm, eq. (5). Same as OpenCV's rational model, whose order is k1, k2,
/// p1, p2, k3, k4, k5, k6.
struct RationalDistortion {
    double k1 = 0.0;
    double k2 = 0.0;
    double k3 = 0.0;
    double k4 = 0.0;
    double k5 = 0.0;
    double k6 = 0.0;
    double p1 = 0.0;
    double p2 = 0.0;

    [[nodiscard]] double numerator(double s) const { return 1.0 + s * (k1 + s * (k2 + s * k3)); }
    [[nodiscard]] double denominator(double s) const { return 1.0 + s * (k4 + s * (k5 + s * k6)); }
    /// Distance from the axis after radial distortion. r: tangent of the angle to the axis, >= 0.
    [[nodiscard]] double radial(double r) const { return r * numerator(r * r) / denominator(r * r); }
    /// Derivative of radial().
    [[nodiscard]] double radialSlope(double r) const;

    [[nodiscard]] Eigen::Vector2d apply(const Eigen::Vector2d& point) const;
    /// Derivative of apply() by the point; a symmetric matrix.
    [[nodiscard]] Eigen::Matrix2d slope(const Eigen::Vector2d& point) const;
    /// Derivative of apply() by k1, k2, k3, k4, k5, k6, p1, p2.
    [[nodiscard]] Eigen::Matrix<double, 2, 8> byParameters(const Eigen::Vector2d& point) const;

    [[nodiscard]] bool isFinite() const;
};

/// Largest r <= upTo for which the distortion provably does not fold within the circle of radius r: its
/// derivative is positive definite there, with eigenvalues of at least kLeastSlope, so that no two points of
/// the circle have the same image. Without decentring (p1, p2) this is exactly where the radial map
/// increases; with decentring the bound is slightly conservative. upTo: > 0. 0 when a parameter is not
/// finite. Thread: any (pure).
[[nodiscard]] double monotoneRadius(const RationalDistortion& distortion, double upTo);

/// Least slope of a lens that does not fold. The radial map of a lens of 160 degrees is steeper than 0.01
/// everywhere.
inline constexpr double kLeastSlope = 1e-4;

} // namespace teleta::vision
