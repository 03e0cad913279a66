// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/camera/camera_model.h"
#include "backend/vision/gel/marker_gel_file.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace teleta::vision {

/// From a pixel to a place on the gel's surface: pixel -> undistorted pixel -> homography -> (x, y) in m.
/// x points along u, y along v, z out of the surface, away from the camera. Thread: any (immutable).
class GelPlane {
public:
    /// width_px, height_px: of the picture after crop and flip. markers_px: at rest, at least two when the
    /// file gives their distance in mm. Error: refused when the lens folds, or the homography sends a pixel
    /// to infinity, within the picture.
    [[nodiscard]] static core::Expected<GelPlane> make(const MarkerGelFile& gel, int width_px, int height_px,
                                                       std::span<const Eigen::Vector2d> markers_px);

    /// NaN for a pixel so far out of the picture that the lens shows no place there.
    [[nodiscard]] Eigen::Vector2d surface_m(const Eigen::Vector2d& pixel) const;
    /// Square root of the area on the surface of a pixel here, in m.
    [[nodiscard]] double scale_m(const Eigen::Vector2d& pixel) const;

private:
    /// The pixel where it would be without the lens's distortion.
    [[nodiscard]] Eigen::Vector2d undistorted(const Eigen::Vector2d& pixel) const;

    std::optional<CameraModel> m_lens;
    Eigen::Matrix3d m_homography = Eigen::Matrix3d::Identity();
};

} // namespace teleta::vision
