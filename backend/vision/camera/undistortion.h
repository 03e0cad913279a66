// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera/camera_model.h"

#include <optional>
#include <vector>

namespace teleta::vision {

/// Point at unit distance before the lens of a pixel by a fixed number of steps
///   (x, y) <- ((x'', y'') - decentring(x, y)) / q(x, y),  started at (x'', y'')
/// A step leaves the share 1 - r R'(r) / R(r) of the error, R the radial map: little where the lens bends
/// little, two thirds at 63 degrees off the axis of an equidistant lens; where it is above 1 the steps lead
/// away (CameraModel::undistort has no such place). iterations: >= 0; 0 is no undistortion. Empty where a
/// step leaves the numbers. Thread: any (pure). Source: J. Heikkila, O. Silven, A four-step camera
/// calibration procedure with implicit image correction (1997); the way of OpenCV's undistortPoints.
[[nodiscard]] std::optional<Eigen::Vector2d>
undistortByIteration(const CameraParameters& camera, const Eigen::Vector2d& pixel, int iterations);

/// The directions in which the pixels of an image look, kept for a grid and interpolated between (bilinear,
/// then to unit length). The error grows with the square of the step. Thread: any (immutable).
class DirectionTable {
public:
    /// step_px: distance of the grid, >= 1; nodes without a ray leave their neighbourhood without directions.
    DirectionTable(const CameraModel& camera, int step_px);

    /// Unit direction in the camera's frame (z along its axis), as CameraModel::undistort gives it. Empty
    /// outside the image and beside a node without a ray.
    [[nodiscard]] std::optional<Eigen::Vector3d> direction(const Eigen::Vector2d& pixel) const;

    [[nodiscard]] std::size_t nodes() const { return m_direction.size(); }

private:
    double m_step_px;
    int m_columns;
    int m_rows;
    std::vector<Eigen::Vector3d> m_direction; ///< row after row; zero: none
};

} // namespace teleta::vision
