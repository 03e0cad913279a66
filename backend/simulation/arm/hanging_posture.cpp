// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/hanging_posture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

arm::JointVector hangingPosture(const arm::ArmDimensions& dimensions, const Eigen::Vector2d& p_Base_Elbow_m) {
    using Eigen::Vector3d;
    const double distance_m = p_Base_Elbow_m.norm();
    const Eigen::Vector2d outwards =
        distance_m > 0.0 ? Eigen::Vector2d(p_Base_Elbow_m / distance_m) : Eigen::Vector2d(1.0, 0.0);
    const double sine = std::clamp(distance_m / dimensions.upperArmLength_m, 0.02, 0.98);
    const double cosine = std::sqrt(1.0 - sine * sine);

    // The upper arm leans outwards from straight down by the angle by which the elbow bends it back.
    const Vector3d x(sine * outwards.x(), sine * outwards.y(), -cosine);
    const Vector3d z(cosine * outwards.x(), cosine * outwards.y(), sine);
    const Vector3d y = z.cross(x);
    return {std::atan2(-z.y(), z.z()), std::asin(std::clamp(z.x(), -1.0, 1.0)), std::atan2(-y.x(), x.x()),
            std::asin(sine)};
}

Eigen::Vector2d elbowAt_m(const arm::Arm4Kinematics& kinematics, const arm::JointVector& q_rad) {
    return kinematics
        .p_Base_Point(arm::Link::upperArm, q_rad, {kinematics.dimensions().upperArmLength_m, 0.0, 0.0})
        .head<2>();
}

} // namespace teleta::simulation
