// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/camera/camera_model.h"

#include <optional>
#include <span>
#include <vector>

namespace teleta::vision {

/// Camera without distortion by the direct linear transformation: the 3 x 4 matrix P with the least
/// algebraic error of u ~ P (p, 1) after moving pixels and points to their centroid and a mean distance of
/// sqrt(2) and sqrt(3), decomposed into K, R and C. A linear part with a negative determinant makes a
/// mirrored camera. Empty when the pairs (at least 6) do not determine P. Only K (with skew), R, C and
/// mirrored of the answer are set.
/// Source: Hartley and Zisserman, Multiple view geometry, algorithm 7.1 and section 6.2.4; VTacArm, [28].
[[nodiscard]] std::optional<CameraParameters> directLinearCamera(std::span<const CalibrationPair> pairs);

/// Cameras near the true one, the best first, from pairs of which up to half may be wrong: by the alignment
/// of pixels with the directions of their points, which no radial distortion disturbs, found by consensus of
/// samples of seven pairs (a fixed sequence of samples: the same pairs give the same answer) around the
/// middle of the image; then depth and focal length by a search over perspective and equidistant lenses and
/// both handednesses. Empty for fewer than 8 pairs or without consensus.
/// Source: Tsai, A versatile camera calibration technique (1987), radial alignment constraint.
[[nodiscard]] std::vector<CameraParameters> alignedCameras(std::span<const CalibrationPair> pairs,
                                                           int width_px, int height_px);

/// The lens whose distances from the centre are in proportion to the angle, as rational distortion.
[[nodiscard]] RationalDistortion equidistantLens();

} // namespace teleta::vision
