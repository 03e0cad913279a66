// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::arm_model {

enum class JointType {
    revolute,   ///< turns within limits
    continuous, ///< turns without limits
    prismatic,  ///< slides within limits
    fixed,      ///< does not move
};

/// The joint follows another one and is never commanded: q = factor * q_followed + offset.
struct Mimic {
    std::size_t followed = 0; ///< index in ArmModel::joints; never itself a mimic joint
    double factor = 1.0;
    double offset = 0.0; ///< rad or m
};

/// A joint of the tree. Its coordinate q is in rad, for a prismatic joint in m. The child's frame is the
/// joint's frame moved by q:
///   X_Parent_Child = X_Parent_Joint * (turn by q about axis, or shift by q along it)
struct ModelJoint {
    std::string name;
    JointType type = JointType::fixed;
    std::size_t parentLink = 0; ///< index in ArmModel::links
    Eigen::Isometry3d X_Parent_Joint = Eigen::Isometry3d::Identity();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX(); ///< in the joint's frame; of length 1
    double lowest = 0.0;                             ///< rad or m; -infinity for a continuous joint
    double highest = 0.0;                            ///< rad or m; +infinity for a continuous joint
    double fastest = 0.0;                            ///< rad/s or m/s; 0: the joint must not be moved
    double strongest = 0.0;                          ///< Nm or N; 0: not stated
    std::optional<Mimic> mimic;

    [[nodiscard]] bool movable() const { return type != JointType::fixed && !mimic; }
};

/// Mass of a link, in the frame of the link.
struct Inertial {
    double mass_kg = 0.0;
    Eigen::Vector3d p_Link_Com_m = Eigen::Vector3d::Zero();
};

enum class ShapeKind { box, cylinder, sphere, mesh };

/// What a link looks like. A cylinder lies along z of its frame; all shapes are centred on its origin.
struct Visual {
    ShapeKind kind = ShapeKind::mesh;
    Eigen::Isometry3d X_Link_Shape = Eigen::Isometry3d::Identity();
    /// box: its sides, m; cylinder: radius, length, 0, m; sphere: radius, 0, 0, m; mesh: scale.
    Eigen::Vector3d size = Eigen::Vector3d::Ones();
    std::string mesh; ///< as the file names it, for example package://robot/link.stl; empty without a mesh
    std::optional<Eigen::Vector4f> colour; ///< red, green, blue, alpha, 0..1
};

struct ModelLink {
    std::string name;
    std::optional<Inertial> inertial;
    std::vector<Visual> visuals;
};

/// A robot as its URDF describes it: a tree of links. links[0] is the root; joints[i] carries links[i + 1],
/// and parents stand before their children. Names are unique among links and among joints. Immutable once
/// read.
struct ArmModel {
    std::string name;
    std::vector<ModelLink> links;
    std::vector<ModelJoint> joints;
    std::string urdf; ///< the text it was read from

    [[nodiscard]] std::optional<std::size_t> findLink(std::string_view linkName) const;
    [[nodiscard]] std::optional<std::size_t> findJoint(std::string_view jointName) const;
    /// The links that no joint leaves: candidates for the tip.
    [[nodiscard]] std::vector<std::size_t> leaves() const;
};

/// The child's frame in the joint's frame. q: finite; ignored by a fixed joint.
[[nodiscard]] Eigen::Isometry3d jointMotion(const ModelJoint& joint, double q);

} // namespace teleta::arm_model
