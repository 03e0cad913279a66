// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/servo/impedance_arm.h"

#include <numbers>
#include <utility>
#include <vector>

namespace teleta::simulation::test {

inline const core::ArrayLayout kLayout{6, 14, 0.0034};

/// A posture in which the array looks straight down.
inline servo::LwrVector lookingDown() {
    servo::LwrVector q_rad;
    q_rad << 0.0, 0.5, 0.0, -1.4, 0.0, std::numbers::pi - 1.9, 0.0;
    return q_rad;
}

inline Eigen::Isometry3d mounted() {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation().z() = 0.03;
    return X;
}

/// Pose in {s} of an object whose surface is so far in front of the array.
inline Eigen::Isometry3d inFront(double gap_m, double yaw_rad = 0.0, double pitch_rad = 0.0) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = (Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()))
                     .toRotationMatrix();
    X.translation().z() = gap_m;
    return X;
}

inline scene::BarShape straightBar() {
    return {.radius_m = 0.003, .behind_m = 0.2, .ahead_m = 0.4};
}

inline scene::BarShape bentBar() {
    return {.radius_m = 0.003,
            .behind_m = 0.2,
            .ahead_m = 0.4,
            .straight_m = -0.01,
            .bend_m = 0.15,
            .fall_rad = 0.384,
            .turn_rad = 0.2};
}

/// The arm at lookingDown() in front of an object, with the housing.
inline ImpedanceArm armBefore(const TouchedShape& shape, double gap_m, double taxelStiffness_NPerM,
                              double bodyStiffness_NPerM = 1e9, bool hinged = false, double friction = 0.0) {
    TouchedObject object;
    object.shape = shape;
    object.X_Base_Object = servo::LwrKinematics(mounted()).X_Base_Tool(lookingDown()) * inFront(gap_m);
    if (hinged) {
        object.turns = true;
        object.axis_Base = object.X_Base_Object.linear().col(1);
        object.p_Base_Hinge = object.X_Base_Object * Eigen::Vector3d(0.0, 0.0, -0.01);
        object.damping_NmsPerRad = 0.001;
    }
    Impedance impedance;
    impedance.friction = friction;
    ImpedanceArm arm(mounted(), impedance,
                     ElasticArray(kLayout, taxelStiffness_NPerM, bodyStiffness_NPerM, {},
                                  housingRim({.stiffness_NPerM = 2e5}, kLayout)),
                     std::move(object));
    ImpedanceState state;
    state.q_rad = lookingDown();
    arm.setState(state);
    if (hinged)
        arm.setHinge(0.002, 0.0);
    return arm;
}

/// Lets the arm move with this velocity of the array, in {s}; the reference stays.
inline void push(ImpedanceArm& arm, const servo::Twist& velocity_Sensor) {
    servo::Twist velocity_Base;
    velocity_Base << arm.X_Base_Sensor().linear() * velocity_Sensor.head<3>(),
        arm.X_Base_Sensor().linear() * velocity_Sensor.tail<3>();
    const servo::LwrJacobian& J = arm.posture().jacobian;
    ImpedanceState state = arm.state();
    const servo::Matrix6 across = J * J.transpose();
    state.rate_radPerS = J.transpose() * across.inverse() * velocity_Base;
    arm.setState(state);
}

} // namespace teleta::simulation::test
