// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace teleta::servo {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Motion of a rigid body in the order [v; w]: v in m/s (m for an increment), w in rad/s (rad). v is the
/// velocity of the point of the body that is at the origin of the frame in which the twist is written.
using Twist = Vector6;

/// Force and moment in the order [f; m], N and Nm, about the origin of the frame in which it is written. Its
/// power with a twist of the same frame is their dot product.
using Wrench = Vector6;

/// Cross product as a matrix: skew(a) b = a x b.
[[nodiscard]] Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// Displacement by a constant twist that lasts one unit of time.
///   R = I + A W + B W^2,  p = (I + B W + C W^2) v,  W = skew(w), t = |w|
///   A = sin t/t,  B = (sin(t/2)/(t/2))^2/2,  C = (t - sin t)/t^3
/// C by its series below 0.25 rad. xi: [v; w] in m and rad, finite. Thread: any (pure).
/// Source: Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation (1994), ch. 2.
[[nodiscard]] Eigen::Isometry3d expSE3(const Twist& xi);

/// Inverse of expSE3, with the rotation within [0, pi].
/// Exact to rounding near 0 and near pi (half angle from the quaternion by atan2). At pi both signs of the
/// axis are right; the one whose first component that is not zero is positive is chosen. X: a rigid
/// displacement. Thread: any (pure).
[[nodiscard]] Twist logSE3(const Eigen::Isometry3d& X);

/// Rotation vector of a rotation, |w| within [0, pi]; sign at pi as logSE3.
[[nodiscard]] Eigen::Vector3d logSO3(const Eigen::Matrix3d& R);

/// Twist written in B -> the same motion written in A:  Ad = [R, skew(p) R; 0, R].
/// Source: tactile servoing paper, eq. (13).
[[nodiscard]] Matrix6 adjoint(const Eigen::Isometry3d& X_A_B);

/// adjoint(X_A_B) * twist_B without the matrix.
[[nodiscard]] Twist twistTo(const Eigen::Isometry3d& X_A_B, const Twist& twist_B);

/// Wrench written in B -> the same wrench written in A:  [R f; p x R f + R m]. Keeps the power with twistTo.
[[nodiscard]] Wrench wrenchTo(const Eigen::Isometry3d& X_A_B, const Wrench& wrench_B);

/// The increment, written in the frame itself, that takes one pose to another: log(X_A_From^-1 X_A_To).
[[nodiscard]] Twist poseDifference(const Eigen::Isometry3d& X_A_From, const Eigen::Isometry3d& X_A_To);

/// Moves a pose by an increment that is written in the base: exp(xi_Base) X. The same as X exp(xi_Sensor)
/// when xi_Base = adjoint(X) xi_Sensor. The rotation is made orthonormal again, so that any number of
/// increments adds no scale or shear. Source: eq. (12)-(13), integrated on SE(3).
[[nodiscard]] Eigen::Isometry3d moved(const Eigen::Isometry3d& X_Base_Sensor, const Twist& increment_Base);

/// The rotation matrix nearest to one that has drifted by rounding. R: nearly orthonormal.
[[nodiscard]] Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& R);

} // namespace teleta::servo
