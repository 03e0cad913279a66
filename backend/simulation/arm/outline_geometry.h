// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/arm_world.h"

#include <Eigen/Core>

#include <vector>

namespace teleta::simulation {

/// Where a point lies against an outline, in the x-y plane of the base.
struct OutlineDistance {
    double distance_m = 0.0; ///< > 0 outside, < 0 inside
    Eigen::Vector2d normal =
        Eigen::Vector2d::UnitX(); ///< out of the object at the nearest point of the outline
};

/// The outline of an object: a circle, a convex polygon or a straight wall. Thread: any (const).
class OutlineGeometry {
public:
    explicit OutlineGeometry(const scene::ArmObject& object);

    /// At the centre of a circle the normal is x; elsewhere, of equally near edges the first counts.
    [[nodiscard]] OutlineDistance distance(const Eigen::Vector2d& p_Base_Point_m) const;
    [[nodiscard]] double height_m() const { return m_height_m; } ///< z of the outline's plane in the base
    [[nodiscard]] const Eigen::Vector2d& centre_m() const { return m_centre_m; }
    /// Of the farthest point of the figure from the centre; infinite for a wall.
    [[nodiscard]] double reach_m() const { return m_reach_m; }
    /// The outline as a polygon, for pictures: of a circle with kCircleCorners corners, of a wall a strip
    /// behind its surface, kWallShown_m long.
    [[nodiscard]] std::vector<Eigen::Vector2d> drawnCorners_m() const;
    static constexpr int kCircleCorners = 48;
    static constexpr double kWallShown_m = 0.3;
    static constexpr double kWallThickness_m = 0.02;

    /// Corners of a polygon, counter-clockwise; empty for the others.
    [[nodiscard]] const std::vector<Eigen::Vector2d>& corners_m() const { return m_corners_m; }

private:
    Eigen::Vector2d m_centre_m;
    double m_height_m;
    double m_radius_m = 0.0; ///< of a circle
    double m_reach_m = 0.0;
    std::vector<Eigen::Vector2d> m_corners_m;
    Eigen::Vector2d m_wallNormal = Eigen::Vector2d::Zero(); ///< zero: no wall
};

/// Where the axis of a capsule comes nearest to an outline.
struct AxisDistance {
    double distance_m = 0.0; ///< of the axis from the object; < 0 when it went through it
    double along_m = 0.0;    ///< of the nearest point of the axis, from its start
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); ///< from the object to the axis, unit
};

/// The nearest points of an axis and the flat figure within an outline. The distance to a convex figure is
/// convex along a line, so the nearest point is where its slope changes its sign.
/// start_m: in the base; direction: unit; length_m > 0. Thread: any (pure).
[[nodiscard]] AxisDistance axisDistance(const OutlineGeometry& outline, const Eigen::Vector3d& start_m,
                                        const Eigen::Vector3d& direction, double length_m);

/// Whether the axis is farther than distance_m from the object, told by the disc around the object alone:
/// false does not say that it is nearer. Arguments as of axisDistance. Thread: any (pure).
[[nodiscard]] bool isBeyond(const OutlineGeometry& outline, const Eigen::Vector3d& start_m,
                            const Eigen::Vector3d& direction, double length_m, double distance_m);

} // namespace teleta::simulation
