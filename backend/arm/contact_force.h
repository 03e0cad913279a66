// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"

#include <tl/expected.hpp>

#include <array>

namespace teleta::arm {

/// Why there is no force.
enum class ForceRefusal {
    notFinite,  ///< the Jacobian, a torque or a setting is NaN or infinite
    outOfRange, ///< one of them is beyond 1e100
    badSetting, ///< not leastLever_m > 0, or torqueNoise_Nm < 0
};

struct ForceSettings {
    double torqueNoise_Nm = 0.0005; ///< standard deviation of each joint's torque; >= 0
    double leastLever_m = 0.01; ///< a force that turns the joints with a shorter lever is not observed; > 0
};

/// Force at a contact, in the base frame.
struct ContactForce {
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();   ///< damped to zero along what is not observed
    Eigen::Vector3d forceSd_N = Eigen::Vector3d::Zero(); ///< from the torque noise, of the observed part
    std::array<bool, 3> observable{};                    ///< false: the number of this axis says nothing
    /// Projects a force onto the directions that the torques do not show.
    Eigen::Matrix3d hidden = Eigen::Matrix3d::Zero();
    Eigen::Vector3d levers_m = Eigen::Vector3d::Zero();       ///< singular values of J_c, falling
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity(); ///< the directions of the levers, columns
    int observedDirections = 0;
    double conditionNumber = 0.0; ///< longest over shortest lever; infinite when that is zero
    /// Norm of the torques that no force at this point explains: another contact, or friction in the joints.
    double residual_Nm = 0.0;
};

/// Share of a unit force along an axis that may be hidden while the axis still counts as observed.
inline constexpr double kHiddenShare = 0.05;

/// Force from joint torques and the contact point.
///   tau = J_c^T F;  J_c = U S V^T,  F = sum u_i (s_i / (s_i^2 + d_i^2)) v_i^T tau
///   d_i^2 = (e/2)^2 (1 - (s_i/e)^2) for s_i < e, else 0;  e = leastLever_m
/// Exact while every lever is longer than e; a direction with a shorter one is marked as hidden and fades to
/// zero without a jump, so noise is never amplified by more than 1.2/e. With the arm stretched and the
/// contact on its centre line that is the force along the arm; at a contact on a joint's axis, the force
/// through the other axes.
/// torque_Nm: of the contact alone (gravity and friction taken off). Thread: any
/// (pure). Source: TeleTA, section 1; damping by Nakamura and Hanafusa (1986), per singular value.
[[nodiscard]] tl::expected<ContactForce, ForceRefusal> solveContactForce(const PointJacobian& jacobian,
                                                                         const JointVector& torque_Nm,
                                                                         const ForceSettings& settings = {});

} // namespace teleta::arm
