// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"

#include <cmath>

namespace teleta::arm {

namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

} // namespace

Eigen::Isometry3d Arm4Kinematics::X_Base_Link(Link link, const JointVector& q_rad) const {
    Eigen::Isometry3d X_Base_Link = Eigen::Isometry3d::Identity();
    X_Base_Link.rotate(AngleAxisd(q_rad[0], Vector3d::UnitX()))
        .rotate(AngleAxisd(q_rad[1], Vector3d::UnitY()))
        .rotate(AngleAxisd(q_rad[2], Vector3d::UnitZ()));
    if (link == Link::forearm)
        X_Base_Link.translate(Vector3d(m_dimensions.upperArmLength_m, 0.0, 0.0))
            .rotate(AngleAxisd(q_rad[3], Vector3d::UnitY()));
    return X_Base_Link;
}

Eigen::Vector3d Arm4Kinematics::p_Base_Point(Link link, const JointVector& q_rad,
                                             const Eigen::Vector3d& p_Link_Point_m) const {
    return X_Base_Link(link, q_rad) * p_Link_Point_m;
}

PointJacobian Arm4Kinematics::pointJacobian(Link link, const JointVector& q_rad,
                                            const Eigen::Vector3d& p_Link_Point_m) const {
    const AngleAxisd roll(q_rad[0], Vector3d::UnitX());
    const AngleAxisd pitch(q_rad[1], Vector3d::UnitY());
    const Eigen::Isometry3d X_Base_UpperArm = X_Base_Link(Link::upperArm, q_rad);
    const Vector3d p_Base_Point = this->p_Base_Point(link, q_rad, p_Link_Point_m);

    PointJacobian jacobian;
    jacobian.col(0) = Vector3d::UnitX().cross(p_Base_Point);
    jacobian.col(1) = (roll * Vector3d::UnitY()).cross(p_Base_Point);
    jacobian.col(2) = (roll * (pitch * Vector3d::UnitZ())).cross(p_Base_Point);
    if (link == Link::forearm) {
        const Vector3d p_Base_Elbow = X_Base_UpperArm * Vector3d(m_dimensions.upperArmLength_m, 0.0, 0.0);
        jacobian.col(3) = (X_Base_UpperArm.linear() * Vector3d::UnitY()).cross(p_Base_Point - p_Base_Elbow);
    } else {
        jacobian.col(3).setZero();
    }
    return jacobian;
}

Eigen::Vector3d Arm4Kinematics::p_Link_Skin(double contactDistance_m, double side_rad) const {
    return {contactDistance_m, -m_dimensions.halfThickness_m * std::sin(side_rad),
            m_dimensions.halfThickness_m * std::cos(side_rad)};
}

} // namespace teleta::arm
