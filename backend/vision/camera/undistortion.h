// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/camera_model.h"

#include <optional>
#include <vector>

namespace teleta::vision {

/// Undistorts a pixel, on the plane at unit distance, by a fixed number of steps
///   (x, y) <- ((x'', y'') - decentring(x, y)) / q(x, y),  started at (x'', y'')
/// Each step leaves the share 1 - r R'(r) / R(r) of the error, R being the radial map: little where the
/// distortion is small, two thirds at 63 degrees off the axis of an equidistant lens. Where the share exceeds
/// 1 the steps diverge (CameraModel::undistort() converges everywhere). iterations: >= 0; 0: no undistortion.
/// Empty where a step overflows. Thread: any (pure). Source: J. Heikkila, O. Silven, A four-step camera
/// calibration procedure with implicit image correction (1997); same method as OpenCV's undistortPoints.
[[nodiscard]] std::optional<Eigen::Vector2d>
undistortByIteration(const CameraParameters& camera, const Eigen::Vector2d& pixel, int iterations);

/// Precomputed directions of the pixels of an image on a grid, with bilinear interpolation (then normalised).
/// The error grows with the square of the grid step. Thread: any (immutable).
class DirectionTable {
public:
    /// step_px: distance of the grid nodes, >= 1. Next to a node without a ray there are no directions.
    DirectionTable(const CameraModel& camera, int step_px);

    /// Unit direction in the camera frame (z along its axis), approximating CameraModel::undistort(). Empty
    /// outside the image and next to a node without a ray.
    [[nodiscard]] std::optional<Eigen::Vector3d> direction(const Eigen::Vector2d& pixel) const;

    [[nodiscard]] std::size_t nodes() const { return m_direction.size(); }

private:
    double m_step_px;
    int m_columns;
    int m_rows;
    std::vector<Eigen::Vector3d> m_direction; ///< row-major; zero: none
};

} // namespace teleta::vision
