// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/rigid_indenter.h"

#include <algorithm>
#include <cmath>

namespace teleta::simulation {

namespace {

/// Half width of a circle of radius R at height d over its lowest point; R from the equator on.
double halfChord_m(double radius_m, double depth_m) {
    return depth_m < radius_m ? std::sqrt(depth_m * (2.0 * radius_m - depth_m)) : radius_m;
}

/// Height of the circle over its lowest point; without the cancellation of R - sqrt(R^2 - v^2).
double sagitta_m(double radius_m, double square_m2) {
    return square_m2 / (radius_m + std::sqrt(std::max(radius_m * radius_m - square_m2, 0.0)));
}

struct HalfSize {
    double u_m = 0.0;
    double v_m = 0.0;
};

struct ContactSize {
    double depth_m;

    HalfSize operator()(const scene::Sphere& shape) const {
        const double half_m = halfChord_m(shape.radius_m, depth_m);
        return {half_m, half_m};
    }
    HalfSize operator()(const scene::Cylinder& shape) const {
        return {0.5 * shape.length_m, halfChord_m(shape.radius_m, depth_m)};
    }
    HalfSize operator()(const scene::BoxEdge& shape) const { return {0.5 * shape.length_m, depth_m}; }
    HalfSize operator()(const scene::FlatPunch& shape) const {
        return {0.5 * shape.length_m, 0.5 * shape.width_m};
    }
};

/// Integral of the depth across the body from low to high, both within the contact.
struct AcrossIntegral {
    double depth_m;
    double u_m; ///< along the body's axis
    double low_m;
    double high_m;

    double operator()(const scene::Sphere& shape) const { return underCircle(shape.radius_m, u_m * u_m); }
    double operator()(const scene::Cylinder& shape) const { return underCircle(shape.radius_m, 0.0); }
    double operator()(const scene::BoxEdge&) const {
        const auto fromZero = [this](double v_m) { return v_m * (depth_m - 0.5 * std::abs(v_m)); };
        return fromZero(high_m) - fromZero(low_m);
    }
    double operator()(const scene::FlatPunch&) const { return depth_m * (high_m - low_m); }

    /// Three Gauss points: the interval is a small part of the chord, or, for a thin body, at most the whole
    /// of it, where the rule is 1.3 % off.
    double underCircle(double radius_m, double u_m2) const {
        constexpr double kNode = 0.7745966692414834;
        const double middle_m = 0.5 * (low_m + high_m);
        const double offset_m = 0.5 * kNode * (high_m - low_m);
        const auto depthAt_m = [&](double v_m) { return depth_m - sagitta_m(radius_m, u_m2 + v_m * v_m); };
        const double mean_m = (5.0 * depthAt_m(middle_m - offset_m) + 8.0 * depthAt_m(middle_m) +
                               5.0 * depthAt_m(middle_m + offset_m)) /
                              18.0;
        return std::max(mean_m, 0.0) * (high_m - low_m);
    }
};

} // namespace

void RigidIndenter::moveTo(const Pose& pose) {
    m_pose = pose;
    m_halfX_m = m_halfY_m = 0.0;
    if (!touches())
        return;
    m_cos = std::cos(pose.angle_rad);
    m_sin = std::sin(pose.angle_rad);
    const HalfSize half = std::visit(ContactSize{pose.depth_m}, m_shape);
    m_halfU_m = half.u_m;
    m_halfV_m = half.v_m;
    if (std::holds_alternative<scene::Sphere>(m_shape)) {
        m_halfX_m = m_halfY_m = half.u_m;
    } else {
        m_halfX_m = half.u_m * std::abs(m_cos) + half.v_m * std::abs(m_sin);
        m_halfY_m = half.u_m * std::abs(m_sin) + half.v_m * std::abs(m_cos);
    }
}

double RigidIndenter::meanPenetration_m(double x_m, double y_m, double width_m, double height_m) const {
    if (!touches())
        return 0.0;
    double u_m = x_m - m_pose.x_m;
    double v_m = y_m - m_pose.y_m;
    double cellV_m = height_m;
    double halfV_m = m_halfV_m;
    double shareAlong = 1.0;
    if (std::holds_alternative<scene::Sphere>(m_shape)) {
        halfV_m = std::sqrt(std::max(m_halfU_m * m_halfU_m - u_m * u_m, 0.0));
    } else {
        const double dx_m = u_m;
        const double dy_m = v_m;
        u_m = m_cos * dx_m + m_sin * dy_m;
        v_m = m_cos * dy_m - m_sin * dx_m;
        const double cellU_m = width_m * std::abs(m_cos) + height_m * std::abs(m_sin);
        cellV_m = width_m * std::abs(m_sin) + height_m * std::abs(m_cos);
        shareAlong =
            (std::min(u_m + 0.5 * cellU_m, m_halfU_m) - std::max(u_m - 0.5 * cellU_m, -m_halfU_m)) / cellU_m;
    }
    const double low_m = std::max(v_m - 0.5 * cellV_m, -halfV_m);
    const double high_m = std::min(v_m + 0.5 * cellV_m, halfV_m);
    if (shareAlong <= 0.0 || high_m <= low_m)
        return 0.0;
    return std::visit(AcrossIntegral{m_pose.depth_m, u_m, low_m, high_m}, m_shape) * shareAlong / cellV_m;
}

} // namespace teleta::simulation
