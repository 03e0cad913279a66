// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm/arm4_kinematics.h"
#include "backend/core/device/arm_device.h"
#include "backend/pipeline/touch/touch_record.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace teleta::test {

/// The paper's arm with the geometry of arm::ArmDimensions; elbow as stiff as k_ri at P_C = 0.175 m says.
inline core::ArmDescription paperArm() {
    const arm::ArmDimensions dimensions;
    core::ArmDescription description;
    description.name = "paper";
    description.upperArmLength_m = dimensions.upperArmLength_m;
    description.forearmLength_m = dimensions.forearmLength_m;
    description.halfThickness_m = dimensions.halfThickness_m;
    description.elbowStiffness_NmPerRad = 3468.6 * 0.175 * 0.175;
    description.skin = {.centreDistance_m = 0.15, .centreSide_rad = std::numbers::pi, .radius_m = 0.030};
    description.lowest_rad = {-1.5, -1.5, -1.5, -0.1};
    description.highest_rad = {1.5, 1.5, 1.5, 2.4};
    description.fastest_radPerS = {1.0, 1.0, 1.0, 1.0};
    return description;
}

/// Joint samples of an arm that is pushed at one point of its forearm, one sample a millisecond. The torques
/// follow from tau = J^T F, the elbow's angle from its own torque and the compliance c = 1/k_ri + 1/k_o:
///   dTheta = c tau / lever^2,   lever = P_C |cos(side)|
class ScriptedArm {
public:
    explicit ScriptedArm(double contactDistance_m = 0.175, double side_rad = std::numbers::pi,
                         double objectStiffness_NPerM = 1325.9)
        : m_contactDistance_m(contactDistance_m)
        , m_side_rad(side_rad)
        , m_objectCompliance_mPerN(1.0 / objectStiffness_NPerM) {}

    /// Standard deviation of each joint's torque.
    double torqueNoise_Nm = 0.0;
    core::JointVector offset_Nm = core::JointVector::zeros(4);
    core::JointVector pose_rad{0.1, -0.2, 0.3, 0.9};
    core::JointVector reference_rad{0.1, -0.2, 0.3, 0.9};
    std::int64_t clockOffset_ns = 5'000'000'000;

    /// force_N: of the arm on the object along the normal of the skin, outwards.
    core::JointSample next(double force_N) {
        ++m_sample;
        core::JointSample sample;
        sample.sourceTime_s = 1e-3 * static_cast<double>(m_sample);
        sample.time_ns = clockOffset_ns + m_sample * 1'000'000;
        sample.arrived_ns = sample.time_ns + 3'000'000;
        const Eigen::Vector4d perNewton_m = torquePerNewton_m();
        const double lever_m = m_contactDistance_m * std::abs(std::cos(m_side_rad));
        const double elbowStiffness = paperArm().elbowStiffness_NmPerRad;
        const double elbow_Nm = perNewton_m[3] * force_N;
        sample.angle_rad = pose_rad;
        sample.torque_Nm = core::JointVector::zeros(4);
        for (std::size_t joint = 0; joint < 4; ++joint) {
            sample.torque_Nm[joint] = perNewton_m[static_cast<Eigen::Index>(joint)] * force_N +
                                      offset_Nm[joint] + torqueNoise_Nm * m_normal(m_random);
        }
        sample.angle_rad[3] += elbow_Nm / elbowStiffness;
        if (lever_m > 1e-6)
            sample.angle_rad[3] += elbow_Nm * m_objectCompliance_mPerN / (lever_m * lever_m);
        sample.reference_rad = reference_rad;
        return sample;
    }

    /// What the skin feels at the newest sample.
    [[nodiscard]] pipeline::SkinContact skin(double force_N) const {
        const core::SkinPlacement placement = paperArm().skin;
        return {.time_ns = clockOffset_ns + m_sample * 1'000'000,
                .sourceTime_s = 1e-3 * static_cast<double>(m_sample),
                .touching = force_N > 0.0,
                .x_m = placement.x_m(m_contactDistance_m),
                .y_m = placement.y_m(m_side_rad),
                .force_N = force_N};
    }

    /// The force with which the elbow feels this torque.
    [[nodiscard]] double forceFor_N(double elbow_Nm) const { return elbow_Nm / torquePerNewton_m()[3]; }

    [[nodiscard]] Eigen::Vector3d normal_Base() const {
        return arm::Arm4Kinematics()
                   .X_Base_Link(arm::Link::forearm, Eigen::Vector4d(pose_rad.data()))
                   .linear() *
               Eigen::Vector3d(0.0, -std::sin(m_side_rad), std::cos(m_side_rad));
    }

private:
    [[nodiscard]] Eigen::Vector4d torquePerNewton_m() const {
        const arm::Arm4Kinematics kinematics;
        const Eigen::Vector4d pose(pose_rad.data());
        return kinematics
                   .pointJacobian(arm::Link::forearm, pose,
                                  kinematics.p_Link_Skin(m_contactDistance_m, m_side_rad))
                   .transpose() *
               normal_Base();
    }

    double m_contactDistance_m;
    double m_side_rad;
    double m_objectCompliance_mPerN;
    std::int64_t m_sample = 0;
    std::mt19937_64 m_random{1};
    std::normal_distribution<double> m_normal;
};

} // namespace teleta::test
