// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/camera/camera_model.h"

#include <optional>
#include <span>
#include <vector>

namespace teleta::vision {

/// Finds a camera without distortion by direct linear transformation: the 3 x 4 matrix P with the least
/// algebraic error of u ~ P (p, 1), after normalising pixels and points to their centroid and mean distances
/// of sqrt(2) and sqrt(3), decomposed into K, R and C. A negative determinant of the linear part means a
/// mirrored camera. Sets K (with skew), R, C and mirrored only. Empty when the pairs (at least 6) do not
/// determine P. Thread: any (pure). Source: Hartley and Zisserman, Multiple view geometry, algorithm 7.1 and
/// section 6.2.4; VTacArm, [28].
[[nodiscard]] std::optional<CameraParameters> directLinearCamera(std::span<const CalibrationPair> pairs);

/// Finds cameras near the true one, best first, from pairs of which up to half may be wrong. First the pixels
/// are aligned with the directions of their points around the middle of the image, which is not affected by
/// radial distortion, by consensus of samples of seven pairs (a fixed sequence of samples, so that equal
/// pairs give equal results). Then depth and focal length are searched for perspective and equidistant lenses
/// and both handednesses. Empty for fewer than 8 pairs or without consensus. Thread: any (pure). Source:
/// Tsai, A versatile camera calibration technique (1987), radial alignment constraint.
[[nodiscard]] std::vector<CameraParameters> alignedCameras(std::span<const CalibrationPair> pairs,
                                                           int width_px, int height_px);

/// Rational distortion of an equidistant lens: the distance from the centre is proportional to the angle.
[[nodiscard]] RationalDistortion equidistantLens();

} // namespace teleta::vision
