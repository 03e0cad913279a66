// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"
#include "tests/backend/vision/foreign_cameras.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace teleta::vision {

inline constexpr double kNormal95 = 1.959963984540054;

/// A point of the tube as a calibrated camera locates it: along and around the axis.
struct LocatedPoint {
    Eigen::Vector2d error_m;
    Eigen::Vector2d deviation_m; ///< as told, by the camera alone

    [[nodiscard]] int covered() const {
        return (std::abs(error_m.x()) <= kNormal95 * deviation_m.x() ? 1 : 0) +
               (std::abs(error_m.y()) <= kNormal95 * deviation_m.y() ? 1 : 0);
    }
};

/// The calibrated camera without noise of the pixel, on a tube that goes on beyond its ends.
inline CylinderCamera withoutNoise(const CylinderCamera& camera) {
    CylinderSurface longer = camera.surface();
    longer.lowest_z_m -= 0.01;
    longer.highest_z_m += 0.1;
    return {camera.camera(), longer, camera.covariance(), 0.0};
}

/// Where `found` (withoutNoise) locates what the true camera sees of a point; empty: nowhere.
inline std::optional<LocatedPoint> located(const ForeignCamera& truth, const CylinderCamera& found,
                                           double angle_rad, double z_m) {
    const Eigen::Vector3d around(-std::sin(angle_rad), std::cos(angle_rad), 0.0);
    const Eigen::Vector3d point_m(0.025 * std::cos(angle_rad), 0.025 * std::sin(angle_rad), z_m);
    const auto at_m = found.locate_m(truth.pixel(point_m));
    if (!at_m)
        return std::nullopt;
    const auto covariance_m2 = found.covariance_m2(*at_m);
    if (!covariance_m2)
        return std::nullopt;
    const Eigen::Vector3d error_m = *at_m - point_m;
    return LocatedPoint{{error_m.z(), error_m.dot(around)},
                        {std::sqrt((*covariance_m2)(2, 2)), std::sqrt(around.dot(*covariance_m2 * around))}};
}

/// Points all over the tube, counted.
struct Coverage {
    int asked = 0;
    int covered = 0;
    int notLocated = 0;
    double squares_m2 = 0.0;

    [[nodiscard]] double share() const { return static_cast<double>(covered) / asked; }
    [[nodiscard]] double rms_m() const { return std::sqrt(2.0 * squares_m2 / asked); }
    Coverage& operator+=(const Coverage& other) {
        asked += other.asked;
        covered += other.covered;
        notLocated += other.notLocated;
        squares_m2 += other.squares_m2;
        return *this;
    }
};

/// Coverage from this height on of what the true camera sees.
inline Coverage coverageOf(const ForeignCamera& truth, const CylinderCamera& calibrated,
                           double lowest_z_m = 0.0) {
    const CylinderCamera found = withoutNoise(calibrated);
    Coverage coverage;
    for (int along = 0; along <= 20; ++along) {
        for (int i = 0; i < 24; ++i) {
            const double angle_rad = 2.0 * std::numbers::pi * (i + 0.5) / 24.0;
            const double z_m = 0.1 * along / 20.0;
            if (z_m < lowest_z_m ||
                !truth.sees({0.025 * std::cos(angle_rad), 0.025 * std::sin(angle_rad), z_m}))
                continue;
            coverage.asked += 2;
            if (const auto point = located(truth, found, angle_rad, z_m)) {
                coverage.covered += point->covered();
                coverage.squares_m2 += point->error_m.squaredNorm();
            } else {
                ++coverage.notLocated;
            }
        }
    }
    return coverage;
}

} // namespace teleta::vision
