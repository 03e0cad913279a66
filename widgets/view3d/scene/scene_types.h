// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace teleta::view3d {

/// An object that was found before the one that is touched now. World frame, m.
struct DrawnObject {
    std::uint64_t number = 0; ///< decides the colour
    QString label;            ///< empty: none is written
    std::vector<Eigen::Vector3d> points_m;
    std::vector<Eigen::Vector3d> curve_m; ///< through the points; fewer than two: not drawn
    bool marked = false;                  ///< drawn larger, as what is selected
    bool elsewhere = false;               ///< something else draws it unless it is marked
};

/// Something in a simulated world: upright with an outline in a plane z = z_m of the world, or round.
struct SceneryItem {
    QString name;
    std::vector<Eigen::Vector2d> outline_m{}; ///< corners of a closed line, in order
    double z_m = 0.0;
    /// In the world: a tube with round ends around this line, or a ball around its only point; then the
    /// outline does not count.
    std::vector<Eigen::Vector3d> axis_m{};
    double radius_m = 0.0; ///< > 0 with an axis

    bool operator==(const SceneryItem&) const = default;
};

/// One link of the arm, drawn as a tube with a ball at its joint. It runs from the origin of its frame along
/// its frame's x axis.
struct ArmLink {
    Eigen::Isometry3d X_World_Link = Eigen::Isometry3d::Identity();
    double length_m = 0.0; ///< >= 0
    double radius_m = 0.0; ///< > 0
};

/// A joint that turns within limits, with its present angle.
struct JointDial {
    QString name;
    /// Origin on the joint's axis, z along it, x the direction of the angle 0. Stands still while this joint
    /// turns.
    Eigen::Isometry3d X_World_Joint = Eigen::Isometry3d::Identity();
    double angle_rad = 0.0;
    double lowest_rad = 0.0;
    double highest_rad = 0.0; ///< > lowest_rad; a joint without finite limits is not drawn
    double radius_m = 0.0;    ///< of what turns, > 0: the dial is drawn around it
};

/// A force on the arm, as the joint torques tell it. World frame.
struct DrawnForce {
    Eigen::Vector3d p_World_m = Eigen::Vector3d::Zero(); ///< where it acts
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
    bool measured = false; ///< by a sensor at the wrist; otherwise computed from the joints' torques
    double time_s = 0.0;   ///< when, with measured
};

/// A frame with z along an axis and x towards a direction, which need not be at right angles to the axis; any
/// x when it lies along the axis. axis: of length 1.
[[nodiscard]] inline Eigen::Isometry3d frameAround(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
                                                   const Eigen::Vector3d& towards) {
    constexpr double kLeastShare = 1e-6; ///< of `towards` that is at right angles to the axis
    Eigen::Vector3d x = towards - towards.dot(axis) * axis;
    x = x.norm() > kLeastShare * towards.norm() ? Eigen::Vector3d(x.normalized()) : axis.unitOrthogonal();
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear() << x, axis.cross(x), axis;
    frame.translation() = origin;
    return frame;
}

} // namespace teleta::view3d
