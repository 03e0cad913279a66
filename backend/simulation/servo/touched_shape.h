// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/servo_world.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace teleta::simulation {

/// How deep a point lies in a body, and the body's outward normal at it. Negative depth: how far outside. The
/// depth changes by no more than the way of the point.
struct Depth {
    double depth_m;
    Eigen::Vector3d normal;
};

/// Of a point in a ball. away_m: the point from the ball's centre.
[[nodiscard]] inline Depth depthInBall(double radius_m, const Eigen::Vector3d& away_m) {
    const double distance_m = std::sqrt(away_m.squaredNorm());
    return {radius_m - distance_m,
            distance_m > 0.0 ? Eigen::Vector3d(away_m / distance_m) : Eigen::Vector3d::UnitZ()};
}

/// The round bar of scene::BarShape. Frame {o}: the line of contact is the curve (u, y(u), z(u)) through the
/// origin with the tangent x, z out of the surface. The axis lies a radius behind it.
///   y' = tan(turn) r,  z' = -tan(fall) r,  r = clamp((u - straight)/bend, -behind/bend, 1)
/// depth = radius - distance from the axis, by one step of Newton from the point's own u. Round ends, a
/// radius beyond behind_m and ahead_m.
class BarSurface {
public:
    explicit BarSurface(const scene::BarShape& shape);

    [[nodiscard]] Depth at(const Eigen::Vector3d& p_Object) const {
        return depthInBall(m_radius_m, fromAxis(p_Object));
    }

    /// As at(), where the point lies in the bar; false outside, and depth is left as it was.
    [[nodiscard]] bool contains(const Eigen::Vector3d& p_Object, Depth& depth) const {
        const Eigen::Vector3d away = fromAxis(p_Object);
        // Most springs that are near the bar are outside: those need no root.
        if (away.squaredNorm() > m_surelyOutside_m2)
            return false;
        const Depth found = depthInBall(m_radius_m, away);
        if (!(found.depth_m > 0.0))
            return false;
        depth = found;
        return true;
    }

    /// Point and unit tangent of the line of contact.
    [[nodiscard]] Eigen::Vector3d lineAt(double u_m) const;
    [[nodiscard]] Eigen::Vector3d tangentAt(double u_m) const;
    /// Distance of a point from the line of contact, by its nearest u.
    [[nodiscard]] double lineDistance_m(const Eigen::Vector3d& p_Object) const;

private:
    struct Axis {
        double y_m, z_m, ySlope, zSlope, yBend, zBend;
    };

    /// From the nearest point of the axis.
    [[nodiscard]] Eigen::Vector3d fromAxis(const Eigen::Vector3d& p_Object) const {
        const double u0 = std::clamp(p_Object.x(), m_low_m, m_high_m);
        // The general way gives the same for a straight bar, for the price of a division.
        if (!(m_bend_m > 0.0))
            return {p_Object.x() - u0, p_Object.y(), p_Object.z() + m_radius_m};
        const Axis first = axisAt(u0);
        const double share =
            ((p_Object.x() - u0) + (p_Object.y() - first.y_m) * first.ySlope +
             (p_Object.z() - first.z_m) * first.zSlope) /
            (1.0 + first.ySlope * first.ySlope + first.zSlope * first.zSlope -
             (p_Object.y() - first.y_m) * first.yBend - (p_Object.z() - first.z_m) * first.zBend);
        const double u = std::clamp(u0 + share, m_low_m, m_high_m);
        const Axis axis = axisAt(u);
        return {p_Object.x() - u, p_Object.y() - axis.y_m, p_Object.z() - axis.z_m};
    }

    [[nodiscard]] Axis axisAt(double u_m) const {
        const double into_m = u_m - m_straight_m;
        if (!(m_bend_m > 0.0))
            return {0.0, -m_radius_m, 0.0, 0.0, 0.0, 0.0};
        const double bent_m = std::clamp(into_m, -m_bendBehind_m, m_bend_m);
        const double share = bent_m / m_bend_m;
        const double area_m = (into_m - 0.5 * bent_m) * share;
        const double bend = bent_m == into_m ? 1.0 / m_bend_m : 0.0;
        return {m_ySlope * area_m, m_zSlope * area_m - m_radius_m,
                m_ySlope * share,  m_zSlope * share,
                m_ySlope * bend,   m_zSlope * bend};
    }

    double m_radius_m;
    double m_surelyOutside_m2; ///< square of a distance from the axis that no rounding brings inside
    double m_low_m;
    double m_high_m;
    double m_straight_m;
    double m_bend_m;
    double m_bendBehind_m;
    double m_ySlope;
    double m_zSlope;
};

/// Box edge along x: its faces are y = -+z, z <= 0.
struct EdgeSurface {
    static constexpr double kHalfRoot = 0.5 * std::numbers::sqrt2;

    [[nodiscard]] static Depth at(const Eigen::Vector3d& p_Object) {
        const double side = p_Object.y() < 0.0 ? -1.0 : 1.0;
        const Eigen::Vector3d normal(0.0, side * kHalfRoot, kHalfRoot);
        return {-normal.dot(p_Object), normal};
    }
};

struct BallSurface {
    double radius_m;

    [[nodiscard]] Depth at(const Eigen::Vector3d& p_Object) const {
        return depthInBall(radius_m, {p_Object.x(), p_Object.y(), p_Object.z() + radius_m});
    }
};

struct WallSurface {
    [[nodiscard]] static Depth at(const Eigen::Vector3d& p_Object) {
        return {-p_Object.z(), Eigen::Vector3d::UnitZ()};
    }
};

using TouchedShape = std::variant<BarSurface, EdgeSurface, BallSurface, WallSurface>;

/// True where a point lies in a body, with its depth there.
template <typename Shape>
[[nodiscard]] bool contains(const Shape& shape, const Eigen::Vector3d& p_Object, Depth& depth) {
    depth = shape.at(p_Object);
    return depth.depth_m > 0.0;
}
[[nodiscard]] inline bool contains(const BarSurface& bar, const Eigen::Vector3d& p_Object, Depth& depth) {
    return bar.contains(p_Object, depth);
}

[[nodiscard]] TouchedShape makeShape(const scene::ServoShape& shape);

} // namespace teleta::simulation
