// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;

} // namespace

Eigen::Vector3d Orbit::direction() const {
    const double level = std::cos(elevation_rad);
    return {level * std::cos(azimuth_rad), level * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

Eigen::Vector3d Orbit::up() const {
    const double slope = -std::sin(elevation_rad);
    return {slope * std::cos(azimuth_rad), slope * std::sin(azimuth_rad), std::cos(elevation_rad)};
}

Orbit Orbit::turned(double azimuthStep_rad, double elevationStep_rad) const {
    return {.azimuth_rad = std::remainder(azimuth_rad + azimuthStep_rad, 2.0 * std::numbers::pi),
            .elevation_rad = std::clamp(elevation_rad + elevationStep_rad, -kRightAngle, kRightAngle)};
}

std::vector<Eigen::Vector3d> cornersOf(const Eigen::AlignedBox3d& box_m) {
    std::vector<Eigen::Vector3d> corners_m;
    for (int corner = 0; corner < 8 && !box_m.isEmpty(); ++corner)
        corners_m.push_back(box_m.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    return corners_m;
}

Orbit orbitOf(CameraPreset preset) {
    switch (preset) {
    case CameraPreset::front:
        return {.azimuth_rad = -kRightAngle, .elevation_rad = 0.0};
    case CameraPreset::top:
        return {.azimuth_rad = -kRightAngle, .elevation_rad = kRightAngle};
    case CameraPreset::side:
        return {.azimuth_rad = 0.0, .elevation_rad = 0.0};
    case CameraPreset::isometric:
        break;
    }
    return {.azimuth_rad = -0.5 * kRightAngle, .elevation_rad = std::atan(std::numbers::sqrt2 / 2.0)};
}

CameraFit fitCamera(const Orbit& orbit, const Eigen::Vector3d& focal_m,
                    std::span<const Eigen::Vector3d> corners_m, double viewAngle_rad, double aspect,
                    double fill, double minimumRadius_m) {
    const Eigen::Vector3d toCamera = orbit.direction();
    const Eigen::Vector3d up = orbit.up();
    const Eigen::Vector3d right = up.cross(toCamera);
    const double tangentY = std::tan(0.5 * viewAngle_rad) * fill;
    const double tangentX = tangentY * aspect;
    const double narrow = std::min(1.0, aspect);
    CameraFit fit{.distance_m = minimumRadius_m / std::sin(std::atan(tangentY * narrow)),
                  .parallelHalfHeight_m = minimumRadius_m / (narrow * fill)};
    for (const Eigen::Vector3d& corner : corners_m) {
        const Eigen::Vector3d p = corner - focal_m;
        const double x = std::abs(p.dot(right));
        const double y = std::abs(p.dot(up));
        fit.distance_m = std::max(fit.distance_m, p.dot(toCamera) + std::max(x / tangentX, y / tangentY));
        fit.parallelHalfHeight_m = std::max({fit.parallelHalfHeight_m, y / fill, x / (aspect * fill)});
    }
    return fit;
}

} // namespace teleta::view3d
