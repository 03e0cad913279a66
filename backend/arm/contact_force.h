// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"

#include <tl/expected.hpp>

#include <array>

namespace teleta::arm {

/// Joint angles or torques of an arm with up to kMostJoints joints, and the derivative of a point's position
/// by the angles, as PointJacobian; neither uses the heap.
inline constexpr int kMostJoints = 16;
using AnyJointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostJoints, 1>;
using AnyPointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostJoints>;

/// Why there is no force.
enum class ForceRefusal {
    notFinite,  ///< the Jacobian, a torque or a setting is NaN or infinite
    outOfRange, ///< one of them exceeds 1e100
    badSetting, ///< leastLever_m <= 0, torqueNoise_Nm < 0, or not a torque for each joint
};

struct ForceSettings {
    double torqueNoise_Nm = 0.0005; ///< standard deviation of each joint's torque; >= 0
    double leastLever_m = 0.01; ///< a force that acts on the joints with a shorter lever is not observed; > 0
};

/// Force at a contact, in the base frame.
struct ContactForce {
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero(); ///< damped to zero along unobserved directions
    Eigen::Vector3d forceSd_N =
        Eigen::Vector3d::Zero();      ///< standard deviation of the observed part, from the torque noise
    std::array<bool, 3> observable{}; ///< false: the component along this axis has no meaning
    /// Projects a force onto the directions that the torques do not reveal.
    Eigen::Matrix3d hidden = Eigen::Matrix3d::Zero();
    Eigen::Vector3d levers_m = Eigen::Vector3d::Zero();       ///< singular values of J_c in falling order
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< columns: the directions of the levers
    int observedDirections = 0;
    double conditionNumber = 0.0; ///< longest over shortest lever; infinite when that is zero
    /// Norm of the torques that no force at this point explains: a second contact, or friction in the joints.
    double residual_Nm = 0.0;
};

/// Largest hidden share of a unit force along an axis that still counts as observed.
inline constexpr double kHiddenShare = 0.05;

/// Computes the contact force from the joint torques and the contact point:
///   tau = J_c^T F;  J_c = U S V^T,  F = sum u_i (s_i / (s_i^2 + d_i^2)) v_i^T tau
///   d_i^2 = (e/2)^2 (1 - (s_i/e)^2) for s_i < e, else 0;  e = leastLever_m
/// Exact while every lever is longer than e. A direction with a shorter lever is marked as hidden and fades
/// continuously to zero, so that noise is never amplified by more than 1.2/e. With the arm stretched and the
/// contact on its centre line this is the force along the arm; for a contact on the axis of a joint, the
/// force through the other axes. torque_Nm: of the contact alone, without gravity and friction, one a column
/// of the Jacobian; otherwise, and without a joint, ForceRefusal::badSetting. Thread: any (pure). Source:
/// TeleTA, section 1; damping by Nakamura and Hanafusa (1986), per singular value.
[[nodiscard]] tl::expected<ContactForce, ForceRefusal> solveContactForce(const AnyPointJacobian& jacobian,
                                                                         const AnyJointVector& torque_Nm,
                                                                         const ForceSettings& settings = {});

} // namespace teleta::arm
