// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace teleta::arm {

/// Joint angles or torques in the order shoulder roll, shoulder pitch, shoulder yaw, elbow pitch.
using JointVector = Eigen::Vector4d;

/// Derivative of a point's position by the joint angles, in the base frame: rows x, y, z; columns as
/// JointVector; m.
using PointJacobian = Eigen::Matrix<double, 3, 4>;

enum class Link {
    upperArm, ///< shoulder to elbow
    forearm,  ///< from the elbow; the paper's second link, which touches
};

/// Lengths of the arm; > 0. The paper does not give them. The links are as long as those of a human arm, on
/// which the robot is modelled; the thickness follows from the paper's r = 0.1776 m and P_C = 0.175 m:
///   h = sqrt(r^2 - P_C^2)
struct ArmDimensions {
    double upperArmLength_m = 0.30;
    double forearmLength_m = 0.27;
    double halfThickness_m = 0.030;
};

/// Kinematics of the remote arm with four joints:
///   R_Base_UpperArm = Rx(roll) Ry(pitch) Rz(yaw),  R_UpperArm_Forearm = Ry(elbow)
/// Base {b} and upper arm {u}: origin where the three shoulder axes meet. Forearm {f}: origin on the elbow's
/// axis. x runs along each link; all angles zero is the arm stretched along x of the base. Elbow > 0 bends
/// the forearm to -z. Thread: any (const). Source: TeleTA, section 1 (order of the joints).
class Arm4Kinematics {
public:
    explicit Arm4Kinematics(const ArmDimensions& dimensions = {})
        : m_dimensions(dimensions) {}

    [[nodiscard]] const ArmDimensions& dimensions() const { return m_dimensions; }

    /// Pose of a link's frame in the base. q_rad: finite.
    [[nodiscard]] Eigen::Isometry3d X_Base_Link(Link link, const JointVector& q_rad) const;

    /// Position of a point of a link in the base.
    [[nodiscard]] Eigen::Vector3d p_Base_Point(Link link, const JointVector& q_rad,
                                               const Eigen::Vector3d& p_Link_Point_m) const;

    /// Jacobian J_c of a point of a link: the velocity of the point is J_c times the joint rates, and a force
    /// F at it causes the joint torques J_c^T F. The elbow does not move points of the upper arm.
    [[nodiscard]] PointJacobian pointJacobian(Link link, const JointVector& q_rad,
                                              const Eigen::Vector3d& p_Link_Point_m) const;

    /// The point of the skin at a distance P_C along a link and at an angle about x (0: +z; it turns towards
    /// -y as it increases).
    [[nodiscard]] Eigen::Vector3d p_Link_Skin(double contactDistance_m, double side_rad) const;

private:
    ArmDimensions m_dimensions;
};

} // namespace teleta::arm
