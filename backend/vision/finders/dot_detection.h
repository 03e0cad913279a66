// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>

#include <vector>

namespace teleta::vision {

/// Detects dark dots on a brighter background in an image in which all have about the same size:
///   darkness = 1 - I / ground, ground: closing with a square of three diameters, smoothed
/// A dot is a local maximum of the smoothed darkness above leastDarkness; of two that are less than one
/// diameter apart the darker one is kept. image: grey levels >= 0. mask: 0 where dots are ignored, of the
/// size of the image, or empty. diameter_px: > 0. Returns the centres in pixels from top to bottom; empty for
/// an image without texture. Thread: any (pure).
[[nodiscard]] std::vector<cv::Point2f> detectDots(const cv::Mat1f& image, const cv::Mat1b& mask,
                                                  double diameter_px, double leastDarkness = 0.2);

} // namespace teleta::vision
