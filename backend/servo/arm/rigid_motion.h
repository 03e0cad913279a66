// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace teleta::servo {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Motion of a rigid body in the order [v; w]: v in m/s (m for an increment), w in rad/s (rad). v is the
/// velocity of the point of the body at the origin of the frame in which the twist is written.
using Twist = Vector6;

/// Force and moment in the order [f; m], N and Nm, about the origin of the frame in which it is written. The
/// dot product with a twist of the same frame is the power.
using Wrench = Vector6;

/// Cross product as a matrix: skew(a) b = a x b.
[[nodiscard]] Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// Displacement by a constant twist acting for one unit of time:
///   R = I + A W + B W^2,  p = (I + B W + C W^2) v,  W = skew(w), t = |w|
///   A = sin t/t,  B = (sin(t/2)/(t/2))^2/2,  C = (t - sin t)/t^3
/// Below 0.25 rad C is computed by its series. xi: [v; w] in m and rad, finite. Thread: any (pure). Source:
/// Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation (1994), ch. 2.
[[nodiscard]] Eigen::Isometry3d expSE3(const Twist& xi);

/// Inverse of expSE3(), with the rotation within [0, pi]. Accurate to rounding near 0 and near pi (half angle
/// from the quaternion by atan2). At pi both signs of the axis are valid; the one whose first nonzero
/// component is positive is returned. X: a rigid displacement. Thread: any (pure).
[[nodiscard]] Twist logSE3(const Eigen::Isometry3d& X);

/// Rotation vector of a rotation, |w| within [0, pi]; sign at pi as for logSE3().
[[nodiscard]] Eigen::Vector3d logSO3(const Eigen::Matrix3d& R);

/// Writes a twist of frame B in frame A:  twist_A = Ad twist_B,  Ad = [R, skew(p) R; 0, R]  with R and p
/// those of X_A_B. Source: tactile servoing paper, eq. (13).
[[nodiscard]] Twist twistTo(const Eigen::Isometry3d& X_A_B, const Twist& twist_B);

/// The increment, written in the frame itself, that moves one pose to the other: log(X_A_From^-1 X_A_To).
[[nodiscard]] Twist poseDifference(const Eigen::Isometry3d& X_A_From, const Eigen::Isometry3d& X_A_To);

/// Moves a pose by an increment written in the base: exp(xi_Base) X, which equals X exp(xi_Sensor) when
/// xi_Base = twistTo(X, xi_Sensor). The rotation is orthonormalised, so that scale and shear do not
/// accumulate over many increments. Source: eq. (12)-(13), integrated on SE(3).
[[nodiscard]] Eigen::Isometry3d moved(const Eigen::Isometry3d& X_Base_Sensor, const Twist& increment_Base);

/// Removes rounding drift from a rotation matrix. R: nearly orthonormal.
[[nodiscard]] Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& R);

} // namespace teleta::servo
