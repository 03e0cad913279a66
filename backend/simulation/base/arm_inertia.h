// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"
#include "backend/scene/arm_world.h"

namespace teleta::simulation {

using MassMatrix = Eigen::Matrix4d;

[[nodiscard]] arm::ArmDimensions dimensionsOf(const scene::ArmBody& body);

/// Inertia of the arm's links, uniform round bars, over the joint angles of the links. Thread: any (const).
class ArmInertia {
public:
    explicit ArmInertia(const scene::ArmBody& body);

    /// M(q), symmetric and positive definite. kg m^2.
    [[nodiscard]] MassMatrix massMatrix(const arm::JointVector& q_rad) const;

    /// Coriolis and centrifugal torques: M(q) qdd + c(q, qd) = tau.
    [[nodiscard]] arm::JointVector velocityTorque(const arm::JointVector& q_rad,
                                                  const arm::JointVector& rate_radPerS) const;

    /// Torques that hold the links against their weight, which points to -z of the base.
    [[nodiscard]] arm::JointVector weightTorque(const arm::JointVector& q_rad) const;

private:
    struct Bar {
        double mass_kg;
        double length_m;
        double along_kgm2;  ///< about its axis
        double across_kgm2; ///< about a line through its middle, across the axis
    };
    struct Pose;

    [[nodiscard]] static Bar barOf(double mass_kg, double length_m, double radius_m);
    [[nodiscard]] Pose poseAt(const arm::JointVector& q_rad) const;

    Bar m_upperArm;
    Bar m_forearm;
    double m_jointInertia_kgm2;
};

} // namespace teleta::simulation
