// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/serial_chain.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::arm_model {

namespace {

struct ChainText {
    Q_DECLARE_TR_FUNCTIONS(ChainText)
};

core::Error missingLink(const ArmModel& model, std::string_view name) {
    QStringList names;
    for (const ModelLink& link : model.links)
        names << QString::fromStdString(link.name);
    return {core::ErrorKind::notFound,
            ChainText::tr("the robot has no link '%1'")
                .arg(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())))
                .toStdString(),
            ChainText::tr("one of %1").arg(names.join(QStringLiteral(", "))).toStdString(),
            {}};
}

core::Error badChain(const QString& message, const QString& expected) {
    return {core::ErrorKind::badInput, message.toStdString(), expected.toStdString(), {}};
}

} // namespace

core::Expected<SerialChain> SerialChain::create(std::shared_ptr<const ArmModel> model,
                                                std::string_view baseLink, std::string_view tipLink) {
    const std::optional<std::size_t> base = model->findLink(baseLink);
    if (!base)
        return core::Unexpected(missingLink(*model, baseLink));
    const std::optional<std::size_t> tip = model->findLink(tipLink);
    if (!tip)
        return core::Unexpected(missingLink(*model, tipLink));

    SerialChain chain;
    chain.m_base = *base;
    chain.m_tip = *tip;
    for (std::size_t link = *tip; link != *base; link = model->joints[link - 1].parentLink) {
        if (link == 0)
            return core::Unexpected(badChain(ChainText::tr("the link '%1' does not hang on '%2'")
                                                 .arg(QString::fromStdString(model->links[*tip].name),
                                                      QString::fromStdString(model->links[*base].name)),
                                             ChainText::tr("a base from which joints lead to the tip")));
        chain.m_path.push_back(link - 1);
    }
    std::ranges::reverse(chain.m_path);

    // A mimic joint between base and tip makes a coordinate of the joint that it follows, wherever that is.
    std::vector<std::optional<std::size_t>> coordinateOf(model->joints.size());
    for (const std::size_t joint : chain.m_path) {
        const ModelJoint& described = model->joints[joint];
        if (described.type == JointType::fixed)
            continue;
        const std::size_t leading = described.mimic ? described.mimic->followed : joint;
        if (!coordinateOf[leading]) {
            coordinateOf[leading] = chain.m_movable.size();
            chain.m_movable.push_back(leading);
        }
    }
    if (chain.m_movable.empty())
        return core::Unexpected(
            badChain(ChainText::tr("no joint between '%1' and '%2' moves")
                         .arg(QString::fromStdString(model->links[*base].name),
                              QString::fromStdString(model->links[*tip].name)),
                     ChainText::tr("at least one revolute, continuous or prismatic joint")));
    if (chain.m_movable.size() > core::JointVector::kCapacity)
        return core::Unexpected(badChain(ChainText::tr("%1 joints move the tip").arg(chain.m_movable.size()),
                                         ChainText::tr("at most %1").arg(core::JointVector::kCapacity)));

    chain.m_drives.resize(model->joints.size());
    chain.m_moved.assign(model->links.size(), false);
    for (std::size_t joint = 0; joint < model->joints.size(); ++joint) {
        const ModelJoint& described = model->joints[joint];
        const std::size_t leading = described.mimic ? described.mimic->followed : joint;
        const double factor = described.mimic ? described.mimic->factor : 1.0;
        const double offset = described.mimic ? described.mimic->offset : 0.0;
        Drive& drive = chain.m_drives[joint];
        drive.coordinate = coordinateOf[leading];
        drive.factor = factor;
        drive.offset = offset;
        if (!drive.coordinate) {
            const ModelJoint& leader = model->joints[leading];
            const double rest =
                leader.type == JointType::fixed ? 0.0 : std::clamp(0.0, leader.lowest, leader.highest);
            drive.offset = factor * rest + offset;
        }
        chain.m_moved[joint + 1] =
            chain.m_moved[described.parentLink] || (described.type != JointType::fixed && drive.coordinate);
    }
    if (chain.m_moved[chain.m_base])
        return core::Unexpected(badChain(ChainText::tr("a joint that moves '%1' moves the tip as well")
                                             .arg(QString::fromStdString(model->links[*base].name)),
                                         ChainText::tr("a base that stands still while the tip moves")));
    chain.m_model = std::move(model);
    return chain;
}

core::JointVector SerialChain::lowest() const {
    core::JointVector all = core::JointVector::zeros(joints());
    for (std::size_t i = 0; i < joints(); ++i)
        all[i] = joint(i).lowest;
    return all;
}

core::JointVector SerialChain::highest() const {
    core::JointVector all = core::JointVector::zeros(joints());
    for (std::size_t i = 0; i < joints(); ++i)
        all[i] = joint(i).highest;
    return all;
}

core::JointVector SerialChain::fastest() const {
    core::JointVector all = core::JointVector::zeros(joints());
    for (std::size_t i = 0; i < joints(); ++i)
        all[i] = joint(i).fastest;
    return all;
}

double SerialChain::position(std::size_t joint, const core::JointVector& q) const {
    const Drive& drive = m_drives[joint];
    return drive.coordinate ? drive.factor * q[*drive.coordinate] + drive.offset : drive.offset;
}

Eigen::Isometry3d SerialChain::X_Parent_Child(std::size_t joint, const core::JointVector& q) const {
    const ModelJoint& described = m_model->joints[joint];
    return described.X_Parent_Joint * jointMotion(described, position(joint, q));
}

Eigen::Isometry3d SerialChain::X_Base_Tip(const core::JointVector& q) const {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (const std::size_t joint : m_path)
        pose = pose * X_Parent_Child(joint, q);
    return pose;
}

std::vector<Eigen::Isometry3d> SerialChain::linkPoses(const core::JointVector& q) const {
    std::vector<Eigen::Isometry3d> poses(m_model->links.size(), Eigen::Isometry3d::Identity());
    for (std::size_t joint = 0; joint < m_model->joints.size(); ++joint)
        poses[joint + 1] = poses[m_model->joints[joint].parentLink] * X_Parent_Child(joint, q);
    const Eigen::Isometry3d X_Base_Root = poses[m_base].inverse();
    for (Eigen::Isometry3d& pose : poses)
        pose = X_Base_Root * pose;
    return poses;
}

std::vector<Eigen::Vector3d> SerialChain::pathPoints_m(const core::JointVector& q) const {
    std::vector<Eigen::Vector3d> points_m{Eigen::Vector3d::Zero()};
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (const std::size_t joint : m_path) {
        pose = pose * X_Parent_Child(joint, q);
        points_m.push_back(pose.translation());
    }
    return points_m;
}

ChainJacobian SerialChain::jacobian(const core::JointVector& q, const Eigen::Vector3d& p_Tip_Point_m) const {
    ChainJacobian jacobian = ChainJacobian::Zero(6, static_cast<Eigen::Index>(joints()));
    const Eigen::Vector3d p_Base_Point = X_Base_Tip(q) * p_Tip_Point_m;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (const std::size_t joint : m_path) {
        const ModelJoint& described = m_model->joints[joint];
        const Eigen::Isometry3d X_Base_Joint = pose * described.X_Parent_Joint;
        const Drive& drive = m_drives[joint];
        if (described.type != JointType::fixed && drive.coordinate) {
            const Eigen::Vector3d axis = drive.factor * (X_Base_Joint.linear() * described.axis);
            auto column = jacobian.col(static_cast<Eigen::Index>(*drive.coordinate));
            if (described.type == JointType::prismatic) {
                column.head<3>() += axis;
            } else {
                column.head<3>() += axis.cross(p_Base_Point - X_Base_Joint.translation());
                column.tail<3>() += axis;
            }
        }
        pose = X_Base_Joint * jointMotion(described, position(joint, q));
    }
    return jacobian;
}

std::optional<core::JointVector> SerialChain::gravityTorque(const core::JointVector& q,
                                                            const Eigen::Vector3d& gravity_Base) const {
    if (linkWithoutMass())
        return std::nullopt;
    // First moment and mass of everything that hangs on each joint, from the leaves to the root.
    const std::vector<Eigen::Isometry3d> poses = linkPoses(q);
    const std::size_t count = m_model->links.size();
    std::vector<double> mass_kg(count, 0.0);
    std::vector<Eigen::Vector3d> moment_kgm(count, Eigen::Vector3d::Zero());
    for (std::size_t link = count; link-- > 0;) {
        if (!isMoved(link))
            continue;
        if (const std::optional<Inertial>& inertial = m_model->links[link].inertial) {
            mass_kg[link] += inertial->mass_kg;
            moment_kgm[link] += inertial->mass_kg * (poses[link] * inertial->p_Link_Com_m);
        }
        if (link > 0) {
            const std::size_t parent = m_model->joints[link - 1].parentLink;
            mass_kg[parent] += mass_kg[link];
            moment_kgm[parent] += moment_kgm[link];
        }
    }
    core::JointVector torque = core::JointVector::zeros(joints());
    for (std::size_t joint = 0; joint < m_model->joints.size(); ++joint) {
        const ModelJoint& described = m_model->joints[joint];
        const Drive& drive = m_drives[joint];
        if (described.type == JointType::fixed || !drive.coordinate)
            continue;
        const std::size_t child = joint + 1;
        // The axis is the same before and after the joint's own motion.
        const Eigen::Vector3d axis = poses[child].linear() * described.axis;
        double work = 0.0;
        if (described.type == JointType::prismatic) {
            work = mass_kg[child] * axis.dot(gravity_Base);
        } else {
            const Eigen::Vector3d origin = poses[child].translation();
            work = axis.cross(moment_kgm[child] - mass_kg[child] * origin).dot(gravity_Base);
        }
        torque[*drive.coordinate] -= drive.factor * work;
    }
    return torque;
}

std::optional<std::string> SerialChain::linkWithoutMass() const {
    for (std::size_t link = 1; link < m_model->links.size(); ++link) {
        const ModelLink& described = m_model->links[link];
        const bool isFrame = described.visuals.empty() && m_model->joints[link - 1].type == JointType::fixed;
        if (isMoved(link) && !described.inertial && !isFrame)
            return described.name;
    }
    return std::nullopt;
}

double SerialChain::movedMass_kg() const {
    double sum_kg = 0.0;
    for (std::size_t link = 0; link < m_model->links.size(); ++link) {
        if (isMoved(link) && m_model->links[link].inertial)
            sum_kg += m_model->links[link].inertial->mass_kg;
    }
    return sum_kg;
}

} // namespace teleta::arm_model
