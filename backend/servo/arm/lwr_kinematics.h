// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/arm/rigid_motion.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace teleta::servo {

inline constexpr int kLwrJoints = 7;

/// One number per joint, A1 to A7.
using LwrVector = Eigen::Matrix<double, kLwrJoints, 1>;

/// Jacobian of a frame: rows [v; w] in base axes, v being the velocity of the frame's origin; columns A1 to
/// A7; m and 1. A force and moment [f; m] at that origin cause the joint torques J^T [f; m].
using LwrJacobian = Eigen::Matrix<double, 6, kLwrJoints>;

/// Limits of the joints: positions and speeds in rad and rad/s. Source: robot description of the
/// KUKA LWR 4+ by the University of Pisa (github.com/CentroEPiaggio/kuka-lwr).
struct LwrLimits {
    LwrVector lowest_rad = -highest();
    LwrVector highest_rad = highest();
    LwrVector fastest_radPerS = fastest();

    [[nodiscard]] static LwrVector highest(); ///< 170, 120, 170, 120, 170, 120, 170 degrees
    [[nodiscard]] static LwrVector fastest(); ///< 110, 110, 128, 128, 204, 184, 184 degrees/s
};

/// Forward kinematics of one posture.
struct LwrPosture {
    Eigen::Isometry3d X_Base_Tool = Eigen::Isometry3d::Identity();
    LwrJacobian jacobian = LwrJacobian::Zero(); ///< of the tool's origin
    /// Axis of each joint and a point on it, in the base; the points (base, shoulder, ...) are for drawing.
    std::array<Eigen::Vector3d, kLwrJoints> axis;
    std::array<Eigen::Vector3d, kLwrJoints> p_Base_Joint;
};

/// Kinematics of the KUKA LWR 4+, seven turning joints without offsets. Denavit-Hartenberg (standard):
///   i        1     2     3     4     5     6     7
///   alpha   90   -90   -90    90    90   -90     0  degrees
///   d    0.310     0 0.400     0 0.390     0 0.078  m        a = 0
/// All angles zero: the arm points up along z, the flange at z = 1.178 m, its axes those of the base. Base
/// {g}; flange {e}; tool: a frame fixed to the flange, the flange itself by default. Thread: any (const);
/// allocates nothing.
class LwrKinematics {
public:
    static constexpr double kWristToFlange_m = 0.078;

    explicit LwrKinematics(const Eigen::Isometry3d& X_Flange_Tool = Eigen::Isometry3d::Identity())
        : m_X_Flange_Tool(X_Flange_Tool) {}

    /// Pose, Jacobian and joint axes. q_rad: finite.
    [[nodiscard]] LwrPosture forward(const LwrVector& q_rad) const;

    /// Pose of the tool only.
    [[nodiscard]] Eigen::Isometry3d X_Base_Tool(const LwrVector& q_rad) const {
        return forward(q_rad).X_Base_Tool;
    }

private:
    Eigen::Isometry3d m_X_Flange_Tool;
};

} // namespace teleta::servo
