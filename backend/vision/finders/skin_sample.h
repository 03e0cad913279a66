// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/cylinder_projection.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace teleta::vision {

/// A place of the skin at rest and how displacements are measured there. One camera sees two of the three
/// components of a displacement. They are interpreted as motion around the tube and inwards; motion along the
/// tube appears as an inward one, multiplied by radius / distance from the lens.
struct SkinSample {
    Eigen::Vector3d p_Sensor_m;
    Eigen::Matrix2d metresPerPixel;  ///< maps (u, v) to displacement (around, inward)
    Eigen::Matrix2d surfacePerPixel; ///< maps (u, v) to distance on the surface (around, along the axis)

    /// Area of the skin at rest that one pixel covers.
    [[nodiscard]] double areaPerPixel_m2() const { return std::abs(surfacePerPixel.determinant()); }

    [[nodiscard]] double angle_rad() const { return std::atan2(p_Sensor_m.y(), p_Sensor_m.x()); }
};

/// The place of the skin that a pixel shows; empty where its ray does not meet the skin. Thread: any (pure).
[[nodiscard]] std::optional<SkinSample> skinSample(const CylinderCamera& camera,
                                                   const Eigen::Vector2d& pixel);

} // namespace teleta::vision
