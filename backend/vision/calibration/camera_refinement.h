// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/camera/camera_model.h"

#include <optional>
#include <span>

namespace teleta::vision {

/// Settings of a fit.
struct RefinementSettings {
    /// Residuals larger than this have no effect (Tukey's biweight), px; 0: least squares over all.
    double lossScale_px = 0.0;
    /// Noise of the pixels, px; sets the weight of the distortion prior relative to the pairs. The prior, an
    /// equidistant lens with the standard deviations of distortionPrior(), decides only what the pairs do not
    /// determine: how the lens continues beyond them.
    double noise_px = 1.0;
    /// Number of distortion parameters that are fitted, in the order k1, k4, k2, k5, p1, p2, k3, k6; the
    /// others are kept.
    int freeDistortion = 8;
    /// The lens model is constrained to be monotone up to this tangent of the angle to the axis; 0: no
    /// constraint.
    double monotoneUpTo = 0.0;
    /// Relative decrease of the loss in a step at which the fit ends. The steps converge quadratically, so
    /// the camera is much nearer to the minimum than this says.
    double tolerance = 1e-9;
    int mostSteps = 200;
    /// Whether the start is near the minimum: the first steps are not shortened then. From afar a long step
    /// may end beyond a pole of the lens model, from where there is no way back.
    bool isNear = false;
};

/// Prior standard deviation of a distortion parameter (0..7: k1..k6, p1, p2).
[[nodiscard]] constexpr double distortionPrior(int parameter) {
    return parameter < 6 ? 1.0 : 0.01;
}

/// Whether a parameter (0..7: k1..k6, p1, p2) is fitted with this RefinementSettings::freeDistortion.
[[nodiscard]] bool isFreeDistortion(int parameter, int freeDistortion);

/// Fits a camera by minimising the loss of the distances between pixels and projected points. All parameters
/// except the skew are fitted together by Levenberg-Marquardt with exact derivatives. start: must
/// have all points to be fitted in front of it; pairs that it cannot project are left out. Empty when the
/// solver finds no camera. Thread: any (pure).
[[nodiscard]] std::optional<CameraParameters> refineCamera(const CameraParameters& start,
                                                           std::span<const CalibrationPair> pairs,
                                                           const RefinementSettings& settings);

} // namespace teleta::vision
