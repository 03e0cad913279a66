// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/jog_rates.h"

#include "backend/arm/arm4_kinematics.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace teleta::arm {

bool canMoveTip(std::size_t joints) {
    return joints == JointVector::SizeAtCompileTime;
}

core::JointVector tipRates(const core::ArmDescription& arm, const core::JointVector& angle_rad,
                           const Eigen::Vector3d& velocity_mPerS) {
    constexpr double kDamping_m = 0.02;
    const JointVector angles = Eigen::Map<const JointVector>(angle_rad.data());
    if (!canMoveTip(arm.joints()) || !angles.allFinite() || !velocity_mPerS.allFinite() ||
        !(arm.upperArmLength_m > 0.0) || !(arm.forearmLength_m > 0.0))
        return core::JointVector::zeros(arm.joints());
    const Arm4Kinematics kinematics(
        {arm.upperArmLength_m, arm.forearmLength_m, std::max(1e-3, arm.halfThickness_m)});
    const PointJacobian jacobian =
        kinematics.pointJacobian(Link::forearm, angles, {arm.forearmLength_m, 0.0, 0.0});
    const Eigen::Matrix3d damped =
        jacobian * jacobian.transpose() + kDamping_m * kDamping_m * Eigen::Matrix3d::Identity();
    JointVector rates = jacobian.transpose() * damped.ldlt().solve(velocity_mPerS);
    double scale = 1.0;
    for (int i = 0; i < 4; ++i) {
        const double fastest = std::max(0.0, arm.fastest_radPerS[static_cast<std::size_t>(i)]);
        if (std::abs(rates[i]) * scale > fastest)
            scale = fastest / std::abs(rates[i]);
    }
    rates *= scale;
    return {rates[0], rates[1], rates[2], rates[3]};
}

Eigen::Vector3d tipPosition(const core::ArmDescription& arm, const core::JointVector& angle_rad) {
    const Arm4Kinematics kinematics(
        {arm.upperArmLength_m, arm.forearmLength_m, std::max(1e-3, arm.halfThickness_m)});
    return kinematics.p_Base_Point(Link::forearm, Eigen::Map<const JointVector>(angle_rad.data()),
                                   {arm.forearmLength_m, 0.0, 0.0});
}

} // namespace teleta::arm
