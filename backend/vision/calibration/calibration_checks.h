// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/calibration/camera_calibration.h"

#include <optional>
#include <span>
#include <vector>

namespace teleta::vision {

/// Radius of the surface over the median distance of the points from the axis. The standard error is that of
/// a median, from the median deviation. Empty for no pairs, or when the median point is on the axis. Thread:
/// any (pure).
[[nodiscard]] std::optional<SurfaceFactor> surfaceFactorOf(std::span<const CalibrationPair> kept,
                                                           const CylinderSurface& surface);

/// Correlation of the residuals of neighbouring kept pairs; see Calibration::structure. residuals: one per
/// pair. Thread: any (pure).
[[nodiscard]] double structureOf(std::span<const CalibrationPair> pairs,
                                 const std::vector<PairResidual>& residuals);

/// Distances of the principal point from the middle of the image, px, as fitted and with u and v swapped.
struct OffMiddle {
    double fitted_px = 0.0;
    double swapped_px = 0.0;
};
[[nodiscard]] OffMiddle offMiddle(const CameraParameters& camera);

/// Looks for what makes a camera that fits wrong all the same. kept: its pairs.
/// offSurface: the error of surfaceFactor moves a located point by more than the uncertainty told, and is
/// larger than four of its standard errors. beyondEnds, outsideImage: more than one kept pair in twenty.
/// swappedPixels: swapping u and v brings the principal point nearer to the middle of the image, and a
/// principal point off the middle by chance (3 % of the longer side, one standard deviation) would do so
/// less than a thousandth as likely; in a square image this cannot be told. The methods without a lens model
/// do not find the principal point and have no such warning. Thread: any (pure).
[[nodiscard]] std::vector<CalibrationWarning> warningsOf(std::span<const CalibrationPair> kept,
                                                         const Calibration& calibration);

} // namespace teleta::vision
