// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_kinematics.h"

#include "backend/arm/arm4_kinematics.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/failure.h"
#include "backend/core/quantile.h"

#include <QCoreApplication>

#include <algorithm>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace teleta::pipeline {

namespace {

using core::JointVector;

struct SkinText {
    Q_DECLARE_TR_FUNCTIONS(SkinKinematics)
};

class ForearmSkin : public SkinKinematics {
public:
    explicit ForearmSkin(const core::ArmDescription& arm)
        : SkinKinematics(kElbow, springsOf(arm), arm.skin.centreSe_m)
        , m_kinematics({arm.upperArmLength_m, arm.forearmLength_m, arm.halfThickness_m})
        , m_skin(arm.skin) {}

    [[nodiscard]] SkinPoint at(const JointVector& angle_rad, double x_m, double y_m) const override {
        const arm::JointVector q_rad(angle_rad.data());
        SkinPoint point;
        point.contactDistance_m = m_skin.distance_m(x_m);
        point.side_rad = m_skin.side_rad(y_m);
        const Eigen::Vector3d p_Link = m_kinematics.p_Link_Skin(point.contactDistance_m, point.side_rad);
        const Eigen::Vector3d normal_Link = Eigen::Vector3d(0.0, p_Link.y(), p_Link.z()).normalized();
        point.p_Base_m = m_kinematics.p_Base_Point(arm::Link::forearm, q_rad, p_Link);
        point.normal_Base = m_kinematics.X_Base_Link(arm::Link::forearm, q_rad).linear() * normal_Link;
        point.jacobian = m_kinematics.pointJacobian(arm::Link::forearm, q_rad, p_Link);
        return point;
    }

private:
    static constexpr std::size_t kElbow = 3;

    static Springs springsOf(const core::ArmDescription& arm) {
        const auto& [roll, pitch, yaw] = arm.shoulderStiffness_NmPerRad;
        return {{roll, pitch, yaw, arm.elbowStiffness_NmPerRad}, arm.elbowStiffnessSe_NmPerRad};
    }

    arm::Arm4Kinematics m_kinematics;
    core::SkinPlacement m_skin;
};

class LinkPad : public SkinKinematics {
public:
    /// toLink: from the arm's base to the pad's link; its joints are the first of the arm's.
    LinkPad(arm_model::SerialChain toLink, const core::PadPlacement& pad, std::size_t pressing,
            const JointVector& stiffness_NmPerRad)
        : SkinKinematics(pressing, {stiffness_NmPerRad}, pad.centreSe_m)
        , m_toLink(std::move(toLink))
        , m_X_Link_Sensor(X_Link_Sensor(pad)) {}

    [[nodiscard]] SkinPoint at(const JointVector& angle_rad, double x_m, double y_m) const override {
        JointVector q_rad = JointVector::zeros(m_toLink.joints());
        std::copy_n(angle_rad.begin(), q_rad.size(), q_rad.begin());
        const Eigen::Vector3d p_Link_m = m_X_Link_Sensor * Eigen::Vector3d(x_m, y_m, 0.0);
        const Eigen::Isometry3d X_Base_Link = m_toLink.X_Base_Tip(q_rad);
        SkinPoint point;
        point.p_Base_m = X_Base_Link * p_Link_m;
        point.normal_Base = X_Base_Link.linear() * m_X_Link_Sensor.linear().col(2);
        // Joints behind the pad do not move it.
        point.jacobian.setZero(3, static_cast<Eigen::Index>(joints()));
        const arm_model::ChainJacobian jacobian = m_toLink.jacobian(q_rad, p_Link_m);
        point.jacobian.leftCols(jacobian.cols()) = jacobian.topRows<3>();
        const auto column = point.jacobian.col(static_cast<Eigen::Index>(pressingJoint()));
        point.contactDistance_m = column.norm();
        if (point.contactDistance_m > 0.0)
            point.side_rad =
                std::acos(std::clamp(column.dot(point.normal_Base) / point.contactDistance_m, -1.0, 1.0));
        return point;
    }

private:
    arm_model::SerialChain m_toLink;
    Eigen::Isometry3d m_X_Link_Sensor;
};

/// The share of a joint's range; of a turn where it has none.
double angleAt(const arm_model::ModelJoint& joint, double share) {
    const bool isBounded = std::isfinite(joint.lowest) && std::isfinite(joint.highest);
    return isBounded ? joint.lowest + share * (joint.highest - joint.lowest)
                     : (2.0 * share - 1.0) * std::numbers::pi;
}

bool turns(const arm_model::ModelJoint& joint) {
    return joint.type != arm_model::JointType::prismatic;
}

/// Median of the lever of a joint about the pad's centre, over poses all over the joints' ranges: in the
/// middle of them an arm is often stretched, where few joints have one.
double usualLever_m(const arm_model::SerialChain& toLink, const core::PadPlacement& pad, std::size_t joint) {
    constexpr std::size_t kPoses = 65;
    const LinkPad skin(toLink, pad, joint, JointVector::zeros(toLink.joints()));
    std::mt19937_64 random(1);
    std::vector<double> levers_m;
    for (std::size_t pose = 0; pose < kPoses; ++pose) {
        JointVector angle_rad = JointVector::zeros(toLink.joints());
        for (std::size_t i = 0; i < angle_rad.size(); ++i)
            angle_rad[i] = angleAt(toLink.joint(i), static_cast<double>(random()) /
                                                        static_cast<double>(std::mt19937_64::max()));
        levers_m.push_back(skin.at(angle_rad, 0.0, 0.0).lever_m());
    }
    return core::medianOf(levers_m);
}

core::Expected<std::size_t> pressingJointOf(const arm_model::SerialChain& toLink,
                                            const core::PadPlacement& pad) {
    const auto presses = [&](std::size_t joint) {
        return turns(toLink.joint(joint)) && usualLever_m(toLink, pad, joint) >= kLeastLever_m;
    };
    std::string before;
    for (std::size_t i = toLink.joints(); i-- > 0;) {
        const std::string& name = toLink.joint(i).name;
        before = before.empty() ? name : name + ", " + before;
        if (pad.joint.empty() ? !presses(i) : name != pad.joint)
            continue;
        if (!turns(toLink.joint(i)))
            return core::failed(core::ErrorKind::badInput,
                                SkinText::tr("the joint %1 slides, and stiffness is evaluated from an angle")
                                    .arg(QString::fromStdString(name)),
                                SkinText::tr("a joint that turns"));
        return i;
    }
    if (pad.joint.empty())
        return core::failed(
            core::ErrorKind::badInput,
            SkinText::tr("no joint presses the pad on %1: all of them move its centre along it")
                .arg(QString::fromStdString(pad.link)),
            SkinText::tr("a joint with a lever of 2 cm or more"));
    return core::failed(core::ErrorKind::notFound,
                        SkinText::tr("no joint %1 moves the pad on %2")
                            .arg(QString::fromStdString(pad.joint), QString::fromStdString(pad.link)),
                        SkinText::tr("one of %1").arg(QString::fromStdString(before)));
}

} // namespace

double SkinKinematics::linkStiffness_NPerM(const SkinPoint& point) const {
    const JointVector& springs = m_springs.stiffness_NmPerRad;
    const arm::AnyJointVector depth_m = point.depthPerAngle_m();
    double compliance_mPerN = 0.0;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const double lever_m = i == m_pressing ? point.lever_m() : depth_m[static_cast<Eigen::Index>(i)];
        if (springs[i] > 0.0)
            compliance_mPerN += lever_m * lever_m / springs[i];
    }
    return std::min(kRigid_NPerM, 1.0 / compliance_mPerN);
}

double SkinKinematics::linkStiffnessSe_NPerM(const SkinPoint& point) const {
    const double spring = m_springs.stiffness_NmPerRad[m_pressing];
    if (!(spring > 0.0))
        return 0.0;
    // 1/k_ri = lever^2 / K and the rest.
    return std::pow(linkStiffness_NPerM(point) * point.lever_m() / spring, 2) * m_springs.pressingSe_NmPerRad;
}

std::shared_ptr<const SkinKinematics> skinAroundForearm(const core::ArmDescription& arm) {
    if (arm.joints() != arm::JointVector::SizeAtCompileTime)
        return nullptr;
    return std::make_shared<const ForearmSkin>(arm);
}

core::Expected<std::shared_ptr<const SkinKinematics>>
padOnLink(const std::shared_ptr<const arm_model::SerialChain>& chain, const core::PadPlacement& pad) {
    const std::shared_ptr<const arm_model::ArmModel> model(chain, &chain->model());
    TELETA_TRY(auto toLink, arm_model::SerialChain::create(model, chain->baseLink(), pad.link));
    for (std::size_t i = 0; i < toLink.joints(); ++i) {
        if (i < chain->joints() && toLink.joint(i).name == chain->joint(i).name)
            continue;
        return core::failed(
            core::ErrorKind::badInput,
            SkinText::tr("the link %1 is moved by %2, which is no joint of the arm")
                .arg(QString::fromStdString(pad.link), QString::fromStdString(toLink.joint(i).name)),
            SkinText::tr("a link between %1 and %2")
                .arg(QString::fromStdString(chain->baseLink()), QString::fromStdString(chain->tipLink())));
    }
    JointVector springs = pad.jointStiffness_NmPerRad;
    if (springs.empty())
        springs = JointVector::zeros(chain->joints());
    if (springs.size() != chain->joints())
        return core::failed(core::ErrorKind::badInput,
                            SkinText::tr("%1 joint stiffnesses are given").arg(springs.size()),
                            SkinText::tr("%1, one for each joint").arg(chain->joints()));
    TELETA_TRY(const std::size_t pressing, pressingJointOf(toLink, pad));
    return std::make_shared<const LinkPad>(std::move(toLink), pad, pressing, springs);
}

Eigen::Isometry3d X_Link_Sensor(const core::PadPlacement& pad) {
    const auto& [roll, pitch, yaw] = pad.rollPitchYaw_rad;
    return Eigen::Translation3d(Eigen::Vector3d::Map(pad.position_m.data())) *
           Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

} // namespace teleta::pipeline
