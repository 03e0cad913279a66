// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/outline_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace teleta::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Corners at angle 0 about the origin, counter-clockwise.
struct CornersOf {
    std::vector<Vector2d> operator()(const scene::RectangleOutline& box) const {
        const double x_m = 0.5 * box.length_m;
        const double y_m = 0.5 * box.width_m;
        return {{x_m, -y_m}, {x_m, y_m}, {-x_m, y_m}, {-x_m, -y_m}};
    }
    std::vector<Vector2d> operator()(const scene::TriangleOutline& triangle) const {
        const double radius_m = triangle.side_m / std::numbers::sqrt3;
        return {{radius_m, 0.0},
                {-0.5 * radius_m, 0.5 * triangle.side_m},
                {-0.5 * radius_m, -0.5 * triangle.side_m}};
    }
    std::vector<Vector2d> operator()(const scene::RoundOutline&) const { return {}; }
    std::vector<Vector2d> operator()(const scene::WallOutline&) const { return {}; }
};

/// Distance of a point of the axis and its slope along the axis.
struct PointDistance {
    double distance_m;
    double slope;
    Vector3d normal;
};

PointDistance pointDistance(const OutlineGeometry& outline, const Vector3d& point_m,
                            const Vector3d& direction) {
    const OutlineDistance flat = outline.distance(point_m.head<2>());
    Vector3d away_m(0.0, 0.0, point_m.z() - outline.height_m());
    if (flat.distance_m > 0.0)
        away_m.head<2>() = flat.distance_m * flat.normal;
    const double distance_m = away_m.norm();
    // On the figure itself every direction along the normal is as good; upwards keeps the slope's sign.
    const Vector3d normal = distance_m > 0.0 ? Vector3d(away_m / distance_m) : Vector3d(Vector3d::UnitZ());
    return {distance_m, normal.dot(direction), normal};
}

} // namespace

OutlineGeometry::OutlineGeometry(const scene::ArmObject& object)
    : m_centre_m(object.x_m, object.y_m)
    , m_height_m(object.z_m)
    , m_corners_m(std::visit(CornersOf(), object.outline)) {
    const Eigen::Rotation2Dd turn(object.angle_rad);
    for (Vector2d& corner : m_corners_m) {
        m_reach_m = std::max(m_reach_m, corner.norm());
        corner = m_centre_m + turn * corner;
    }
    if (const auto* round = std::get_if<scene::RoundOutline>(&object.outline))
        m_reach_m = m_radius_m = round->radius_m;
    if (std::holds_alternative<scene::WallOutline>(object.outline)) {
        m_wallNormal = turn * Vector2d::UnitX();
        m_reach_m = std::numeric_limits<double>::infinity();
    }
}

std::vector<Vector2d> OutlineGeometry::drawnCorners_m() const {
    if (!m_corners_m.empty())
        return m_corners_m;
    std::vector<Vector2d> corners_m;
    if (m_radius_m > 0.0) {
        for (int i = 0; i < kCircleCorners; ++i)
            corners_m.emplace_back(
                m_centre_m + m_radius_m * (Eigen::Rotation2Dd(2.0 * std::numbers::pi * i / kCircleCorners) *
                                           Vector2d::UnitX()));
        return corners_m;
    }
    const Vector2d along(-m_wallNormal.y(), m_wallNormal.x());
    for (const auto& [deep, wide] : {std::pair{0.0, 0.5}, {1.0, 0.5}, {1.0, -0.5}, {0.0, -0.5}})
        corners_m.emplace_back(m_centre_m - deep * kWallThickness_m * m_wallNormal +
                               wide * kWallShown_m * along);
    return corners_m;
}

OutlineDistance OutlineGeometry::distance(const Vector2d& p_Base_Point_m) const {
    if (m_radius_m > 0.0) {
        const Vector2d out_m = p_Base_Point_m - m_centre_m;
        const double fromCentre_m = out_m.norm();
        return {fromCentre_m - m_radius_m,
                fromCentre_m > 0.0 ? Vector2d(out_m / fromCentre_m) : Vector2d(Vector2d::UnitX())};
    }
    if (m_corners_m.empty())
        return {m_wallNormal.dot(p_Base_Point_m - m_centre_m), m_wallNormal};

    OutlineDistance inside{-std::numeric_limits<double>::infinity(), Vector2d::UnitX()};
    Vector2d nearest_m = m_corners_m.front();
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_corners_m.size(); ++i) {
        const Vector2d& from_m = m_corners_m[i];
        const Vector2d edge_m = m_corners_m[(i + 1) % m_corners_m.size()] - from_m;
        const Vector2d normal = Vector2d(edge_m.y(), -edge_m.x()).normalized();
        const double beyond_m = normal.dot(p_Base_Point_m - from_m);
        if (beyond_m > inside.distance_m)
            inside = {beyond_m, normal};
        const double share = std::clamp(edge_m.dot(p_Base_Point_m - from_m) / edge_m.squaredNorm(), 0.0, 1.0);
        const Vector2d onEdge_m = from_m + share * edge_m;
        const double distance_m = (p_Base_Point_m - onEdge_m).norm();
        if (distance_m < least_m) {
            least_m = distance_m;
            nearest_m = onEdge_m;
        }
    }
    if (inside.distance_m <= 0.0 || !(least_m > 0.0))
        return inside;
    return {least_m, (p_Base_Point_m - nearest_m) / least_m};
}

bool isBeyond(const OutlineGeometry& outline, const Vector3d& start_m, const Vector3d& direction,
              double length_m, double distance_m) {
    const Vector3d centre_m(outline.centre_m().x(), outline.centre_m().y(), outline.height_m());
    const double along_m = std::clamp(direction.dot(centre_m - start_m), 0.0, length_m);
    return (start_m + along_m * direction - centre_m).norm() > outline.reach_m() + distance_m;
}

AxisDistance axisDistance(const OutlineGeometry& outline, const Vector3d& start_m, const Vector3d& direction,
                          double length_m) {
    const double crossing_m =
        direction.z() != 0.0 ? (outline.height_m() - start_m.z()) / direction.z() : -1.0;
    if (crossing_m >= 0.0 && crossing_m <= length_m) {
        const OutlineDistance flat = outline.distance((start_m + crossing_m * direction).head<2>());
        if (flat.distance_m <= 0.0) {
            // Out of the object at right angles to the axis, as outside.
            Vector3d normal(flat.normal.x(), flat.normal.y(), 0.0);
            normal.z() = -normal.dot(direction) / direction.z();
            const double norm = normal.norm();
            return {flat.distance_m / norm, crossing_m, normal / norm};
        }
    }
    const auto at = [&](double along_m) {
        return pointDistance(outline, start_m + along_m * direction, direction);
    };
    double low_m = 0.0;
    double high_m = length_m;
    PointDistance low = at(low_m);
    PointDistance high = at(high_m);
    if (low.slope >= 0.0)
        return {low.distance_m, low_m, low.normal};
    if (high.slope <= 0.0)
        return {high.distance_m, high_m, high.normal};
    // Regula falsi with halved weights (Illinois): the slope rises along the axis.
    double lowSlope = low.slope;
    double highSlope = high.slope;
    int lastSide = 0;
    for (int i = 0; i < 100; ++i) {
        const double middle_m = (low_m * highSlope - high_m * lowSlope) / (highSlope - lowSlope);
        const PointDistance middle = at(middle_m);
        if (std::abs(middle.slope) < 1e-14 || high_m - low_m < 1e-15 * length_m)
            return {middle.distance_m, middle_m, middle.normal};
        if (middle.slope < 0.0) {
            low_m = middle_m;
            lowSlope = middle.slope;
            if (std::exchange(lastSide, -1) == -1)
                highSlope *= 0.5;
        } else {
            high_m = middle_m;
            highSlope = middle.slope;
            if (std::exchange(lastSide, 1) == 1)
                lowSlope *= 0.5;
        }
    }
    const PointDistance end = at(0.5 * (low_m + high_m));
    return {end.distance_m, 0.5 * (low_m + high_m), end.normal};
}

} // namespace teleta::simulation
