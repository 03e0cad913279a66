// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/touched_shape.h"

#include <algorithm>

namespace teleta::simulation {

BarSurface::BarSurface(const scene::BarShape& shape)
    : m_radius_m(shape.radius_m)
    , m_low_m(-shape.behind_m)
    , m_high_m(shape.ahead_m)
    , m_straight_m(shape.straight_m)
    , m_bend_m(shape.bend_m)
    , m_perBend(shape.bend_m > 0.0 ? 1.0 / shape.bend_m : 0.0)
    , m_bendBehind_m(shape.bendBehind_m)
    , m_ySlope(std::tan(shape.turn_rad))
    , m_zSlope(-std::tan(shape.fall_rad)) {
}

Eigen::Vector3d BarSurface::tangentAt(double u_m) const {
    if (!isBent())
        return Eigen::Vector3d::UnitX();
    const Axis axis = axisAt(u_m);
    return Eigen::Vector3d(1.0, axis.ySlope, axis.zSlope).normalized();
}

Eigen::Vector3d BarSurface::centreAt(double u_m) const {
    if (!isBent())
        return {u_m, 0.0, -m_radius_m};
    const Axis axis = axisAt(u_m);
    return {u_m, axis.y_m, axis.z_m};
}

Eigen::Vector3d BarSurface::lineAt(double u_m) const {
    if (!isBent())
        return {u_m, 0.0, 0.0};
    // The side of the bar that looks along z, across its tangent.
    const Eigen::Vector3d tangent = tangentAt(u_m);
    const Eigen::Vector3d normal = (Eigen::Vector3d::UnitZ() - tangent.z() * tangent).normalized();
    return centreAt(u_m) + m_radius_m * normal;
}

double BarSurface::lineDistance_m(const Eigen::Vector3d& p_Object) const {
    double u_m = std::clamp(p_Object.x(), m_low_m, m_high_m);
    for (int i = 0; i < 4; ++i)
        u_m = std::clamp(u_m + (p_Object - lineAt(u_m)).dot(tangentAt(u_m)) * tangentAt(u_m).x(), m_low_m,
                         m_high_m);
    return (p_Object - lineAt(u_m)).norm();
}

TouchedShape makeShape(const scene::ServoShape& shape) {
    struct Make {
        TouchedShape operator()(const scene::BarShape& bar) const { return BarSurface(bar); }
        TouchedShape operator()(const scene::EdgeShape&) const { return EdgeSurface{}; }
        TouchedShape operator()(const scene::BallShape& ball) const { return BallSurface{ball.radius_m}; }
        TouchedShape operator()(const scene::WallShape&) const { return WallSurface{}; }
    };
    return std::visit(Make(), shape);
}

servo::TouchedBody bodyOf(const scene::ServoObject& object) {
    constexpr double kPieces = 64.0; // of a bar that is bent
    servo::TouchedBody body{.name = object.name};
    if (const auto* ball = std::get_if<scene::BallShape>(&object.shape)) {
        body.axis_m = {Eigen::Vector3d(0.0, 0.0, -ball->radius_m)};
        body.radius_m = ball->radius_m;
    } else if (const auto* bar = std::get_if<scene::BarShape>(&object.shape)) {
        const BarSurface surface(*bar);
        const double pieces = surface.isBent() ? kPieces : 1.0;
        for (double piece = 0.0; piece <= pieces; piece += 1.0)
            body.axis_m.push_back(
                surface.centreAt(-bar->behind_m + piece / pieces * (bar->ahead_m + bar->behind_m)));
        body.radius_m = bar->radius_m;
    }
    return body;
}

} // namespace teleta::simulation
