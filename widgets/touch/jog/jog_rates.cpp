// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/jog_rates.h"

#include "backend/arm/arm4_kinematics.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace teleta::touch {

core::JointArray tipRates(const core::ArmDescription& arm, const core::JointArray& angle_rad,
                          const Eigen::Vector3d& velocity_mPerS) {
    constexpr double kDamping_m = 0.02;
    const arm::JointVector angles = Eigen::Map<const arm::JointVector>(angle_rad.data());
    if (!angles.allFinite() || !velocity_mPerS.allFinite() || !(arm.upperArmLength_m > 0.0) ||
        !(arm.forearmLength_m > 0.0))
        return {};
    const arm::Arm4Kinematics kinematics(
        {arm.upperArmLength_m, arm.forearmLength_m, std::max(1e-3, arm.halfThickness_m)});
    const arm::PointJacobian jacobian =
        kinematics.pointJacobian(arm::Link::forearm, angles, {arm.forearmLength_m, 0.0, 0.0});
    const Eigen::Matrix3d damped =
        jacobian * jacobian.transpose() + kDamping_m * kDamping_m * Eigen::Matrix3d::Identity();
    const arm::JointVector rates = jacobian.transpose() * damped.ldlt().solve(velocity_mPerS);
    double scale = 1.0;
    for (int i = 0; i < 4; ++i) {
        const double fastest = std::max(0.0, arm.fastest_radPerS[static_cast<std::size_t>(i)]);
        if (std::abs(rates[i]) * scale > fastest)
            scale = fastest / std::abs(rates[i]);
    }
    core::JointArray limited{};
    for (int i = 0; i < 4; ++i)
        limited[static_cast<std::size_t>(i)] = scale * rates[i];
    return limited;
}

Eigen::Vector3d tipPosition(const core::ArmDescription& arm, const core::JointArray& angle_rad) {
    const arm::Arm4Kinematics kinematics(
        {arm.upperArmLength_m, arm.forearmLength_m, std::max(1e-3, arm.halfThickness_m)});
    return kinematics.p_Base_Point(arm::Link::forearm, Eigen::Map<const arm::JointVector>(angle_rad.data()),
                                   {arm.forearmLength_m, 0.0, 0.0});
}

} // namespace teleta::touch
