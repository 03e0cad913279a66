// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/cylinder_projection.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace teleta::vision {

/// A place of the skin at rest and how displacements are read at it. One camera sees two of the three
/// components of a displacement; it is read as if the skin had moved around the tube and inward. What it
/// moved along the tube appears as inward, by radius / distance from the lens as much.
struct SkinSample {
    Eigen::Vector3d p_Sensor_m;
    Eigen::Matrix2d metresPerPixel;  ///< displacement (around, inward) from (u, v)
    Eigen::Matrix2d surfacePerPixel; ///< distance along the surface (around, along the axis) from (u, v)

    /// Area of the skin at rest that one pixel sees.
    [[nodiscard]] double areaPerPixel_m2() const { return std::abs(surfacePerPixel.determinant()); }

    [[nodiscard]] double angle_rad() const { return std::atan2(p_Sensor_m.y(), p_Sensor_m.x()); }
};

/// Empty where the pixel's ray does not meet the skin. Thread: any (pure).
[[nodiscard]] std::optional<SkinSample> skinSample(const CylinderCamera& camera,
                                                   const Eigen::Vector2d& pixel);

} // namespace teleta::vision
