// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/arm_model.h"
#include "backend/core/device/joint_vector.h"
#include "backend/core/error.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::arm_model {

/// Six rows: velocity x, y, z (m/s), angular velocity x, y, z (rad/s), in the base frame. A column for each
/// joint of the chain.
using ChainJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, core::JointVector::kCapacity>;

/// The joints of a robot between two of its links that move the second one: what a console moves. All other
/// movable joints (fingers, a second arm) stand where they do least harm to the description: at 0, or at the
/// end of their range that is nearest to 0. Mimic joints follow their joint wherever they are. Thread: any
/// (const); nothing allocates but linkPoses() and pathPoints_m().
class SerialChain {
public:
    /// Failure: notFound where a link is missing (the message lists the links that exist); badInput where the
    /// tip does not hang on the base, where no joint between them moves, or more than JointVector::kCapacity
    /// do.
    [[nodiscard]] static core::Expected<SerialChain>
    create(std::shared_ptr<const ArmModel> model, std::string_view baseLink, std::string_view tipLink);

    [[nodiscard]] const ArmModel& model() const { return *m_model; }
    [[nodiscard]] std::size_t joints() const { return m_movable.size(); }
    /// The joint that coordinate i moves, from the base to the tip. i < joints().
    [[nodiscard]] const ModelJoint& joint(std::size_t i) const { return m_model->joints[m_movable[i]]; }
    [[nodiscard]] const std::string& baseLink() const { return m_model->links[m_base].name; }
    [[nodiscard]] const std::string& tipLink() const { return m_model->links[m_tip].name; }

    /// Range of the joints; infinite for a continuous one.
    [[nodiscard]] core::JointVector lowest() const;
    [[nodiscard]] core::JointVector highest() const;
    [[nodiscard]] core::JointVector fastest() const;

    // q: as many finite numbers as joints(), rad or m.

    /// Pose of the tip's frame in the base's.
    [[nodiscard]] Eigen::Isometry3d X_Base_Tip(const core::JointVector& q) const;

    /// Poses of all links of the robot in the base's frame, in the order of ArmModel::links.
    [[nodiscard]] std::vector<Eigen::Isometry3d> linkPoses(const core::JointVector& q) const;

    /// Origins of the frames from the base to the tip, both included, in the base's frame.
    [[nodiscard]] std::vector<Eigen::Vector3d> pathPoints_m(const core::JointVector& q) const;

    /// Derivative of the tip's pose: J qd is the velocity of a point that is fixed to the tip, and the
    /// angular velocity of the tip. p_Tip_Point_m: the point in the tip's frame.
    [[nodiscard]] ChainJacobian
    jacobian(const core::JointVector& q,
             const Eigen::Vector3d& p_Tip_Point_m = Eigen::Vector3d::Zero()) const;

    /// Torques (prismatic: forces) that hold the robot still against gravity:
    ///   tau_j = - sum over links i of m_i (d p_i / d q_j) . g,   p_i: centre of mass of link i
    /// over all links that the chain moves, fingers included. gravity_Base: m/s2, in the base's frame.
    /// Nothing where such a link has no inertial, see linkWithoutMass().
    [[nodiscard]] std::optional<core::JointVector>
    gravityTorque(const core::JointVector& q, const Eigen::Vector3d& gravity_Base = {0.0, 0.0, -9.81}) const;

    /// The first link which the chain moves and whose mass is not known. A link at which no mass hangs
    /// because it is a mere frame (no visual either, joined rigidly) counts as massless.
    [[nodiscard]] std::optional<std::string> linkWithoutMass() const;

    /// Sum of the known masses of the links that the chain moves.
    [[nodiscard]] double movedMass_kg() const;

private:
    /// How far a coordinate of the chain moves a joint: q_joint = factor * q[coordinate] + offset.
    struct Drive {
        std::optional<std::size_t> coordinate; ///< none: the joint stands at offset
        double factor = 0.0;
        double offset = 0.0;
    };

    SerialChain() = default;
    [[nodiscard]] double position(std::size_t joint, const core::JointVector& q) const;
    [[nodiscard]] Eigen::Isometry3d X_Parent_Child(std::size_t joint, const core::JointVector& q) const;
    [[nodiscard]] bool isMoved(std::size_t link) const { return m_moved[link]; }

    std::shared_ptr<const ArmModel> m_model;
    std::size_t m_base = 0;
    std::size_t m_tip = 0;
    std::vector<std::size_t> m_path;    ///< joints from the base to the tip, fixed ones too
    std::vector<std::size_t> m_movable; ///< joint of each coordinate
    std::vector<Drive> m_drives;        ///< of each joint of the model
    std::vector<bool> m_moved;          ///< of each link: some coordinate moves it relative to the base
};

} // namespace teleta::arm_model
