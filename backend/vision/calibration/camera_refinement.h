// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/camera/camera_model.h"

#include <optional>
#include <span>

namespace teleta::vision {

/// How a camera is fitted.
struct RefinementSettings {
    /// Residuals beyond this do not count (Tukey's biweight), px; 0: squares of all.
    double lossScale_px = 0.0;
    /// Noise of the pixels, px: weighs the prior of the distortion against the pairs. The prior, an
    /// equidistant lens with the deviations of distortionPrior(), decides only what the pairs say nothing
    /// about: how the lens goes on beyond them.
    double noise_px = 1.0;
    /// How many distortion parameters are fitted: k1, k4, k2, k5, p1, p2, k3, k6, in this order; the others
    /// stay.
    int freeDistortion = 8;
    /// The lens model is asked to be increasing up to this tangent of the angle to the axis; 0: it is not.
    double monotoneUpTo = 0.0;
};

/// Standard deviation of the prior of a distortion parameter (0..7: k1..k6, p1, p2).
[[nodiscard]] constexpr double distortionPrior(int parameter) {
    return parameter < 6 ? 1.0 : 0.01;
}

/// Whether the parameter of this number (0..7: k1..k6, p1, p2) is among the first so many that are fitted.
[[nodiscard]] bool isFreeDistortion(int parameter, int freeDistortion);

/// Camera with the least sum of losses of the distances between pixels and projected points, all parameters
/// but the skew fitted together by Levenberg-Marquardt (Ceres) with exact derivatives. start: in front of
/// all points whose pairs shall count; pairs that the start cannot project are left out. Empty when the
/// solver finds no camera. Thread: any (pure).
[[nodiscard]] std::optional<CameraParameters> refineCamera(const CameraParameters& start,
                                                           std::span<const CalibrationPair> pairs,
                                                           const RefinementSettings& settings);

} // namespace teleta::vision
