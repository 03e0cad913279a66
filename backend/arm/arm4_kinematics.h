// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace teleta::arm {

/// Joint angles or torques in the order shoulder roll, shoulder pitch, shoulder yaw, elbow pitch.
using JointVector = Eigen::Vector4d;

/// Velocity of a point over joint rates, in the base frame: 3 rows x, y, z; 4 columns as JointVector. m.
using PointJacobian = Eigen::Matrix<double, 3, 4>;

enum class Link {
    upperArm, ///< shoulder to elbow
    forearm,  ///< from the elbow; the paper's second link, which touches
};

/// Lengths of the arm; > 0. The paper gives none of them. The links are as long as those of a human arm, the
/// model of the robot; the thickness follows from the paper's r = 0.1776 m and P_C = 0.175 m:
///   h = sqrt(r^2 - P_C^2)
struct ArmDimensions {
    double upperArmLength_m = 0.30;
    double forearmLength_m = 0.27;
    double halfThickness_m = 0.030;
};

/// Geometry of the remote arm with four joints.
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

    /// A point of a link, in the base.
    [[nodiscard]] Eigen::Vector3d p_Base_Point(Link link, const JointVector& q_rad,
                                               const Eigen::Vector3d& p_Link_Point_m) const;

    /// Jacobian J_c of a point of a link: its velocity is J_c times the joint rates, the torques of a force
    /// at it are J_c^T F. The elbow does not move points of the upper arm.
    [[nodiscard]] PointJacobian pointJacobian(Link link, const JointVector& q_rad,
                                              const Eigen::Vector3d& p_Link_Point_m) const;

    /// The contact point on the skin at a distance P_C along a link, on the side of the angle around x (0:
    /// +z, towards -y when it grows).
    [[nodiscard]] Eigen::Vector3d p_Link_Skin(double contactDistance_m, double side_rad) const;

private:
    ArmDimensions m_dimensions;
};

} // namespace teleta::arm
