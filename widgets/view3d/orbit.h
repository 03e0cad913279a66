// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace teleta::view3d {

/// Camera position on a sphere around its focal point; z stays up on the screen.
///   direction = (cos el cos az, cos el sin az, sin el)     from the focal point to the camera
///   up = d direction / d el                                defined at the poles too
/// Thread: any (pure).
struct Orbit {
    double azimuth_rad = 0.0;
    double elevation_rad = 0.0; ///< -pi/2..pi/2

    [[nodiscard]] Eigen::Vector3d direction() const;
    [[nodiscard]] Eigen::Vector3d up() const;
    /// Rotated by two angles; the elevation stops at the poles.
    [[nodiscard]] Orbit turned(double azimuthStep_rad, double elevationStep_rad) const;
};

enum class CameraPreset {
    front,     ///< from -y; x to the right, z up
    top,       ///< from +z; x to the right, y up
    side,      ///< from +x; y to the right, z up
    isometric, ///< between the three
};

[[nodiscard]] Orbit orbitOf(CameraPreset preset);

/// The eight corners of a box; of an empty one none.
[[nodiscard]] std::vector<Eigen::Vector3d> cornersOf(const Eigen::AlignedBox3d& box_m);

/// Camera settings that show all corners.
struct CameraFit {
    double distance_m = 0.0;           ///< perspective: from the focal point to the camera
    double parallelHalfHeight_m = 0.0; ///< orthographic
};

/// Smallest distance and parallel scale that show every corner. viewAngle_rad: full vertical angle; aspect:
/// width/height, > 0; fill: usable share of the picture, 0..1. The result is at least that for a sphere of
/// minimumRadius_m around the focal point.
[[nodiscard]] CameraFit fitCamera(const Orbit& orbit, const Eigen::Vector3d& focal_m,
                                  std::span<const Eigen::Vector3d> corners_m, double viewAngle_rad,
                                  double aspect, double fill, double minimumRadius_m);

} // namespace teleta::view3d
