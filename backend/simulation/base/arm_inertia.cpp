// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/base/arm_inertia.h"

#include <array>

namespace teleta::simulation {

namespace {

using arm::JointVector;
using arm::PointJacobian;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kGravity_mPerS2 = 9.80665;

Matrix3d inertiaOf(double along_kgm2, double across_kgm2, const Vector3d& axis) {
    return across_kgm2 * Matrix3d::Identity() + (along_kgm2 - across_kgm2) * axis * axis.transpose();
}

} // namespace

arm::ArmDimensions dimensionsOf(const scene::ArmBody& body) {
    return {.upperArmLength_m = body.upperArmLength_m,
            .forearmLength_m = body.forearmLength_m,
            .halfThickness_m = body.halfThickness_m};
}

/// Joint axes, middles of the links and their axes, in the base.
struct ArmInertia::Pose {
    std::array<Vector3d, 4> axes;
    Vector3d upperArm;
    Vector3d forearm;
    Vector3d elbow_m;
    Vector3d upperArmMiddle_m;
    Vector3d forearmMiddle_m; ///< from the elbow
    PointJacobian upperArmJacobian;
    PointJacobian forearmJacobian;
    PointJacobian upperArmTurn;
    PointJacobian forearmTurn;
};

ArmInertia::Bar ArmInertia::barOf(double mass_kg, double length_m, double radius_m) {
    const double radius2_m2 = radius_m * radius_m;
    return {.mass_kg = mass_kg,
            .length_m = length_m,
            .along_kgm2 = 0.5 * mass_kg * radius2_m2,
            .across_kgm2 = mass_kg * (3.0 * radius2_m2 + length_m * length_m) / 12.0};
}

ArmInertia::ArmInertia(const scene::ArmBody& body)
    : m_upperArm(barOf(body.upperArmMass_kg, body.upperArmLength_m, body.halfThickness_m))
    , m_forearm(barOf(body.forearmMass_kg, body.forearmLength_m, body.halfThickness_m))
    , m_jointInertia_kgm2(body.jointInertia_kgm2) {
}

ArmInertia::Pose ArmInertia::poseAt(const JointVector& q_rad) const {
    const Matrix3d roll = AngleAxisd(q_rad[0], Vector3d::UnitX()).toRotationMatrix();
    const Matrix3d pitch = roll * AngleAxisd(q_rad[1], Vector3d::UnitY());
    const Matrix3d upperArm = pitch * AngleAxisd(q_rad[2], Vector3d::UnitZ());
    const Matrix3d forearm = upperArm * AngleAxisd(q_rad[3], Vector3d::UnitY());

    Pose pose;
    pose.axes = {Vector3d::UnitX(), roll.col(1), pitch.col(2), upperArm.col(1)};
    pose.upperArm = upperArm.col(0);
    pose.forearm = forearm.col(0);
    pose.elbow_m = m_upperArm.length_m * pose.upperArm;
    pose.upperArmMiddle_m = 0.5 * pose.elbow_m;
    pose.forearmMiddle_m = 0.5 * m_forearm.length_m * pose.forearm;
    for (int i = 0; i < 4; ++i) {
        const Vector3d& axis = pose.axes[static_cast<std::size_t>(i)];
        const Vector3d arm_m = i < 3 ? Vector3d(pose.elbow_m + pose.forearmMiddle_m) : pose.forearmMiddle_m;
        pose.upperArmTurn.col(i) = i < 3 ? axis : Vector3d(Vector3d::Zero());
        pose.upperArmJacobian.col(i) = i < 3 ? axis.cross(pose.upperArmMiddle_m) : Vector3d(Vector3d::Zero());
        pose.forearmTurn.col(i) = axis;
        pose.forearmJacobian.col(i) = axis.cross(arm_m);
    }
    return pose;
}

MassMatrix ArmInertia::massMatrix(const JointVector& q_rad) const {
    const Pose pose = poseAt(q_rad);
    MassMatrix mass = m_jointInertia_kgm2 * MassMatrix::Identity();
    const auto add = [&mass](const Bar& bar, const PointJacobian& jacobian, const PointJacobian& turn,
                             const Vector3d& axis) {
        mass += bar.mass_kg * jacobian.transpose() * jacobian +
                turn.transpose() * inertiaOf(bar.along_kgm2, bar.across_kgm2, axis) * turn;
    };
    add(m_upperArm, pose.upperArmJacobian, pose.upperArmTurn, pose.upperArm);
    add(m_forearm, pose.forearmJacobian, pose.forearmTurn, pose.forearm);
    return mass;
}

JointVector ArmInertia::velocityTorque(const JointVector& q_rad, const JointVector& rate_radPerS) const {
    const Pose pose = poseAt(q_rad);
    Vector3d turn = Vector3d::Zero();
    Vector3d turnChange = Vector3d::Zero();
    const auto join = [&](std::size_t joint) {
        const Vector3d part = rate_radPerS[static_cast<Eigen::Index>(joint)] * pose.axes[joint];
        turnChange += turn.cross(part);
        turn += part;
    };
    const auto torque = [&](const Bar& bar, const Vector3d& axis, const PointJacobian& jacobian,
                            const PointJacobian& turnJacobian, const Vector3d& acceleration) {
        const Matrix3d inertia = inertiaOf(bar.along_kgm2, bar.across_kgm2, axis);
        return JointVector(jacobian.transpose() * (bar.mass_kg * acceleration) +
                           turnJacobian.transpose() * (inertia * turnChange + turn.cross(inertia * turn)));
    };
    const auto swing = [&](const Vector3d& arm_m) {
        return Vector3d(turnChange.cross(arm_m) + turn.cross(turn.cross(arm_m)));
    };
    for (std::size_t joint = 0; joint < 3; ++joint)
        join(joint);
    JointVector result = torque(m_upperArm, pose.upperArm, pose.upperArmJacobian, pose.upperArmTurn,
                                swing(pose.upperArmMiddle_m));
    const Vector3d elbow = swing(pose.elbow_m);
    join(3);
    result += torque(m_forearm, pose.forearm, pose.forearmJacobian, pose.forearmTurn,
                     elbow + swing(pose.forearmMiddle_m));
    return result;
}

JointVector ArmInertia::weightTorque(const JointVector& q_rad) const {
    const Pose pose = poseAt(q_rad);
    return kGravity_mPerS2 * (m_upperArm.mass_kg * pose.upperArmJacobian.row(2) +
                              m_forearm.mass_kg * pose.forearmJacobian.row(2))
                                 .transpose();
}

} // namespace teleta::simulation
