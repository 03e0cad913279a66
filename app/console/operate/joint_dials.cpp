// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/joint_dials.h"

#include "widgets/touch/touch_texts.h"

#include <array>

namespace teleta::console {

std::vector<view3d::JointDial> armDials(const arm::Arm4Kinematics& kinematics,
                                        const core::ArmDescription& description,
                                        const arm::JointVector& q_rad) {
    constexpr std::size_t kJoints = 4;
    if (description.joints() != kJoints)
        return {};
    // The frames before each joint: those of the arm with this joint and the later shoulder joints at 0.
    const auto upperArm = [&](Eigen::Index turned) {
        arm::JointVector q = arm::JointVector::Zero();
        q.head(turned) = q_rad.head(turned);
        return kinematics.X_Base_Link(arm::Link::upperArm, q);
    };
    struct Axis {
        Eigen::Isometry3d X_Base_Before;
        Eigen::Vector3d axis;
        Eigen::Vector3d zero;
    };
    Eigen::Isometry3d X_Base_Elbow = upperArm(3);
    X_Base_Elbow.translation() = kinematics.X_Base_Link(arm::Link::forearm, q_rad).translation();
    const std::array<Axis, kJoints> axes{{
        {upperArm(0), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()},
        {upperArm(1), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()},
        {upperArm(2), Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()},
        {X_Base_Elbow, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()},
    }};
    std::vector<view3d::JointDial> dials;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
        const auto& [X_Base_Before, axis, zero] = axes[joint];
        dials.push_back({touch::TouchTexts::joint(joint, kJoints),
                         view3d::frameAround(X_Base_Before.translation(), X_Base_Before.linear() * axis,
                                             X_Base_Before.linear() * zero),
                         q_rad[static_cast<Eigen::Index>(joint)], description.lowest_rad[joint],
                         description.highest_rad[joint], description.halfThickness_m});
    }
    return dials;
}

ChainDials::ChainDials(std::shared_ptr<const arm_model::SerialChain> chain)
    : m_chain(std::move(chain)) {
    const core::JointVector rest = core::JointVector::zeros(m_chain->joints());
    const std::vector<Eigen::Isometry3d> poses = m_chain->linkPoses(rest);
    const Eigen::Vector3d tip = m_chain->X_Base_Tip(rest).translation();
    for (std::size_t i = 0; i < m_chain->joints(); ++i) {
        const arm_model::ModelJoint& joint = m_chain->joint(i);
        if (joint.type != arm_model::JointType::revolute)
            continue;
        // 0 points where the tip lies when all joints are at 0.
        const Eigen::Vector3d towards = (poses[joint.parentLink] * joint.X_Parent_Joint).inverse() * tip;
        m_turning.push_back({i, view3d::frameAround(Eigen::Vector3d::Zero(), joint.axis, towards)});
    }
}

std::vector<view3d::JointDial> ChainDials::at(const core::JointVector& q, double radius_m) const {
    const std::vector<Eigen::Isometry3d> poses = m_chain->linkPoses(q);
    std::vector<view3d::JointDial> dials;
    for (const auto& [i, X_Joint_Dial] : m_turning) {
        const arm_model::ModelJoint& joint = m_chain->joint(i);
        dials.push_back({QString::fromStdString(joint.name),
                         poses[joint.parentLink] * joint.X_Parent_Joint * X_Joint_Dial, q[i], joint.lowest,
                         joint.highest, radius_m});
    }
    return dials;
}

std::vector<view3d::JointDial> servoDials(const servo::LwrVector& q_rad, double radius_m) {
    if (!q_rad.allFinite())
        return {};
    const servo::LwrLimits limits;
    const servo::LwrPosture posture = servo::LwrKinematics().forward(q_rad);
    std::vector<view3d::JointDial> dials;
    for (Eigen::Index i = 0; i < servo::kLwrJoints; ++i) {
        const auto joint = static_cast<std::size_t>(i);
        // The next joint's axis is at right angles, and turns with this joint.
        const Eigen::Vector3d& axis = posture.axis[joint];
        const Eigen::Vector3d turned = i + 1 < servo::kLwrJoints
                                           ? posture.axis[joint + 1]
                                           : Eigen::Vector3d(posture.X_Base_Tool.linear().col(0));
        dials.push_back({QStringLiteral("A%1").arg(i + 1),
                         view3d::frameAround(posture.p_Base_Joint[joint], axis,
                                             Eigen::AngleAxisd(-q_rad[i], axis) * turned),
                         q_rad[i], limits.lowest_rad[i], limits.highest_rad[i], radius_m});
    }
    return dials;
}

} // namespace teleta::console
