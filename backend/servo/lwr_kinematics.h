// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/rigid_motion.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace teleta::servo {

inline constexpr int kLwrJoints = 7;

/// One number a joint, A1 to A7.
using LwrVector = Eigen::Matrix<double, kLwrJoints, 1>;

/// Velocity of a frame over joint rates: rows [v; w] in base axes, v the velocity of the frame's origin;
/// columns A1 to A7. m and 1. The joint torques of a force and moment [f; m] at that origin are J^T [f; m].
using LwrJacobian = Eigen::Matrix<double, 6, kLwrJoints>;

/// What the joints may do. Positions, speeds and torques as the public robot description of the University of
/// Pisa for the KUKA LWR 4+ has them (github.com/CentroEPiaggio/kuka-lwr), in rad, rad/s and Nm.
struct LwrLimits {
    LwrVector lowest_rad = -highest();
    LwrVector highest_rad = highest();
    LwrVector fastest_radPerS = fastest();
    LwrVector highestTorque_Nm = torque();

    [[nodiscard]] static LwrVector highest(); ///< 170, 120, 170, 120, 170, 120, 170 degrees
    [[nodiscard]] static LwrVector fastest(); ///< 110, 110, 128, 128, 204, 184, 184 degrees/s
    [[nodiscard]] static LwrVector torque();  ///< 176, 176, 100, 100, 100, 38, 38
};

/// Forward kinematics of one posture.
struct LwrPosture {
    Eigen::Isometry3d X_Base_Tool = Eigen::Isometry3d::Identity();
    LwrJacobian jacobian = LwrJacobian::Zero(); ///< of the tool's origin
    /// Axis and a point on it of each joint, in the base; the points are base, shoulder, ..., for drawing.
    std::array<Eigen::Vector3d, kLwrJoints> axis;
    std::array<Eigen::Vector3d, kLwrJoints> p_Base_Joint;
};

/// Kinematics of the KUKA LWR 4+, seven turning joints without offsets. Denavit-Hartenberg (standard):
///   i        1     2     3     4     5     6     7
///   alpha   90   -90   -90    90    90   -90     0  degrees
///   d    0.310     0 0.400     0 0.390     0 0.078  m        a = 0
/// All angles zero: the arm points up along z, the flange at z = 1.178 m, its axes those of the base.
/// Base {g}; flange {e}; tool: a frame fixed to the flange, the flange itself by default.
/// Thread: any (const); nothing allocates.
class LwrKinematics {
public:
    static constexpr double kBaseToShoulder_m = 0.310;
    static constexpr double kShoulderToElbow_m = 0.400;
    static constexpr double kElbowToWrist_m = 0.390;
    static constexpr double kWristToFlange_m = 0.078;

    explicit LwrKinematics(const Eigen::Isometry3d& X_Flange_Tool = Eigen::Isometry3d::Identity())
        : m_X_Flange_Tool(X_Flange_Tool) {}

    [[nodiscard]] const Eigen::Isometry3d& X_Flange_Tool() const { return m_X_Flange_Tool; }

    /// Pose, Jacobian and joint axes. q_rad: finite.
    [[nodiscard]] LwrPosture forward(const LwrVector& q_rad) const;

    /// Pose of the tool only.
    [[nodiscard]] Eigen::Isometry3d X_Base_Tool(const LwrVector& q_rad) const;

private:
    Eigen::Isometry3d m_X_Flange_Tool;
};

} // namespace teleta::servo
