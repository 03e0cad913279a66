// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/servo_world.h"
#include "backend/servo/touched_body.h"

#include <Eigen/Core>

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

/// The same with the normal before it is divided by its length. Plain numbers, so that many points are
/// computed side by side.
struct Nearest {
    double depth_m;
    double x, y, z;
    double length; ///< of (x, y, z); where it is 0, the normal is z

    [[nodiscard]] Depth depth() const {
        return {depth_m, length > 0.0 ? Eigen::Vector3d(x / length, y / length, z / length)
                                      : Eigen::Vector3d::UnitZ()};
    }
};

/// Of a point in a ball. x, y, z: the point from the ball's centre.
[[nodiscard]] inline Nearest nearestInBall(double radius_m, double x, double y, double z) {
    const double distance_m = std::sqrt(x * x + y * y + z * z);
    return {radius_m - distance_m, x, y, z, distance_m};
}

/// The round bar of scene::BarShape. Frame {o}: the line of contact is the curve (u, y(u), z(u)) through the
/// origin with the tangent x, z out of the surface. The axis lies a radius behind it.
///   y' = tan(turn) r,  z' = -tan(fall) r,  r = clamp((u - straight)/bend, -behind/bend, 1)
/// depth = radius - distance from the axis, by one step of Newton from the point's own u. Round ends, a
/// radius beyond behind_m and ahead_m.
class BarSurface {
public:
    explicit BarSurface(const scene::BarShape& shape);

    [[nodiscard]] Nearest nearest(double x, double y, double z) const {
        return isBent() ? nearestBent(x, y, z) : nearestStraight(x, y, z);
    }
    [[nodiscard]] bool isBent() const { return m_bend_m > 0.0; }
    /// Of a bar that is not bent: the general way gives the same, for the price of a division.
    [[nodiscard]] Nearest nearestStraight(double x, double y, double z) const {
        return nearestInBall(m_radius_m, x - within(x, m_low_m, m_high_m), y, z + m_radius_m);
    }
    /// Of a bar that is bent.
    [[nodiscard]] Nearest nearestBent(double x, double y, double z) const {
        const double u0 = within(x, m_low_m, m_high_m);
        const Axis first = axisAt(u0);
        const double share = ((x - u0) + (y - first.y_m) * first.ySlope + (z - first.z_m) * first.zSlope) /
                             (1.0 + first.ySlope * first.ySlope + first.zSlope * first.zSlope -
                              (y - first.y_m) * first.yBend - (z - first.z_m) * first.zBend);
        const double u = within(u0 + share, m_low_m, m_high_m);
        const Axis axis = axisAt(u);
        return nearestInBall(m_radius_m, x - u, y - axis.y_m, z - axis.z_m);
    }

    /// Point of the bar's own axis.
    [[nodiscard]] Eigen::Vector3d centreAt(double u_m) const;
    /// Point and unit tangent of the line of contact.
    [[nodiscard]] Eigen::Vector3d lineAt(double u_m) const;
    [[nodiscard]] Eigen::Vector3d tangentAt(double u_m) const;
    /// Distance of a point from the line of contact, by its nearest u.
    [[nodiscard]] double lineDistance_m(const Eigen::Vector3d& p_Object) const;

private:
    struct Axis {
        double y_m, z_m, ySlope, zSlope, yBend, zBend;
    };

    // Not std::clamp, whose references keep compilers from computing several at once.
    [[nodiscard]] static double within(double value, double low, double high) {
        const double raised = value < low ? low : value;
        return raised > high ? high : raised;
    }

    /// Of a bar that is bent.
    [[nodiscard]] Axis axisAt(double u_m) const {
        const double into_m = u_m - m_straight_m;
        const double bent_m = within(into_m, -m_bendBehind_m, m_bend_m);
        const double share = bent_m / m_bend_m;
        const double area_m = (into_m - 0.5 * bent_m) * share;
        // Where it bends 1, else 0. A choice by the difference would keep compilers from computing several at
        // once; it is 0 or over 1e-20 m.
        const double beyond = std::abs(into_m - bent_m) * 1e100;
        const double bend = (1.0 - (beyond < 1.0 ? beyond : 1.0)) * m_perBend;
        return {m_ySlope * area_m, m_zSlope * area_m - m_radius_m,
                m_ySlope * share,  m_zSlope * share,
                m_ySlope * bend,   m_zSlope * bend};
    }

    double m_radius_m;
    double m_low_m;
    double m_high_m;
    double m_straight_m;
    double m_bend_m;
    double m_perBend; ///< 1 / m_bend_m; 0 of a straight bar
    double m_bendBehind_m;
    double m_ySlope;
    double m_zSlope;
};

/// Box edge along x: its faces are y = -+z, z <= 0.
struct EdgeSurface {
    static constexpr double kHalfRoot = 0.5 * std::numbers::sqrt2;

    [[nodiscard]] static Nearest nearest(double /*x*/, double y, double z) {
        const double side = y < 0.0 ? -kHalfRoot : kHalfRoot;
        return {-(side * y + kHalfRoot * z), 0.0, side, kHalfRoot, 1.0};
    }
};

struct BallSurface {
    double radius_m;

    [[nodiscard]] Nearest nearest(double x, double y, double z) const {
        return nearestInBall(radius_m, x, y, z + radius_m);
    }
};

struct WallSurface {
    [[nodiscard]] static Nearest nearest(double /*x*/, double /*y*/, double z) {
        return {-z, 0.0, 0.0, 1.0, 1.0};
    }
};

using TouchedShape = std::variant<BarSurface, EdgeSurface, BallSurface, WallSurface>;

template <typename Shape>
[[nodiscard]] Depth depthIn(const Shape& shape, const Eigen::Vector3d& p_Object) {
    return shape.nearest(p_Object.x(), p_Object.y(), p_Object.z()).depth();
}

[[nodiscard]] TouchedShape makeShape(const scene::ServoShape& shape);

/// What is drawn of an object: a bar or a ball; of an edge or a wall, which have no end, only the name.
[[nodiscard]] servo::TouchedBody bodyOf(const scene::ServoObject& object);

} // namespace teleta::simulation
