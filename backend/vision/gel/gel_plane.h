// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/camera/rational_distortion.h"
#include "backend/vision/gel/marker_gel_file.h"

#include <Eigen/Core>

#include <optional>

namespace teleta::vision {

/// From a pixel to a place on the gel's surface: pixel -> undistorted pixel -> homography -> (x, y) in m.
/// x points along u, y along v, z out of the surface, away from the camera. Thread: any (immutable).
class GelPlane {
public:
    /// width_px, height_px: of the picture after crop and flip. pitch_px: distance of neighbouring markers in
    /// undistorted pixels, used when the file gives their distance in mm; > 0.
    /// Error: refused when the lens folds, or the homography sends a pixel to infinity, within the picture.
    [[nodiscard]] static core::Expected<GelPlane> make(const MarkerGelFile& gel, int width_px, int height_px,
                                                       double pitch_px);

    [[nodiscard]] Eigen::Vector2d surface_m(const Eigen::Vector2d& pixel) const;
    /// Square root of the area on the surface of a pixel here, in m.
    [[nodiscard]] double scale_m(const Eigen::Vector2d& pixel) const;

    /// The pixel where it would be without the lens's distortion.
    [[nodiscard]] static Eigen::Vector2d undistorted(const MarkerGelFile& gel, const Eigen::Vector2d& pixel);

private:
    std::optional<MarkerGelFile::Lens> m_lens;
    Eigen::Matrix3d m_homography = Eigen::Matrix3d::Identity();
};

} // namespace teleta::vision
