// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dot_detection.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace teleta::vision {

namespace {

int odd(double size) {
    return 2 * std::max(1, static_cast<int>(std::lround(0.5 * size))) + 1;
}

/// Vertex of the parabola through three neighbouring values, -0.5 .. 0.5.
float peakOffset(float before, float here, float after) {
    const float curvature = before - 2.0F * here + after;
    return curvature < 0.0F ? std::clamp(0.5F * (before - after) / curvature, -0.5F, 0.5F) : 0.0F;
}

} // namespace

std::vector<cv::Point2f> detectDots(const cv::Mat1f& image, const cv::Mat1b& mask, double diameter_px,
                                    double leastDarkness) {
    const int groundSize = odd(3.0 * diameter_px);
    std::vector<cv::Point2f> dots;
    if (image.rows < 3 || image.cols < 3)
        return dots;
    cv::Mat1f ground;
    cv::morphologyEx(image, ground, cv::MORPH_CLOSE,
                     cv::getStructuringElement(cv::MORPH_RECT, {groundSize, groundSize}));
    cv::blur(ground, ground, {groundSize, groundSize});
    cv::Mat1f darkness(image.size());
    for (int v = 0; v < image.rows; ++v) {
        for (int u = 0; u < image.cols; ++u)
            darkness(v, u) = ground(v, u) > 1.0F ? 1.0F - image(v, u) / ground(v, u) : 0.0F;
    }
    cv::GaussianBlur(darkness, darkness, {0, 0}, std::max(0.5, 0.2 * diameter_px));
    cv::Mat1f highest;
    const int apart = odd(diameter_px);
    cv::dilate(darkness, highest, cv::getStructuringElement(cv::MORPH_ELLIPSE, {apart, apart}));
    for (int v = 1; v + 1 < image.rows; ++v) {
        for (int u = 1; u + 1 < image.cols; ++u) {
            const float here = darkness(v, u);
            if (here < static_cast<float>(leastDarkness) || here < highest(v, u) ||
                (!mask.empty() && mask(v, u) == 0))
                continue;
            // Only the first pixel of a plateau counts.
            if (here == darkness(v, u - 1) || here == darkness(v - 1, u - 1) || here == darkness(v - 1, u) ||
                here == darkness(v - 1, u + 1))
                continue;
            dots.emplace_back(
                static_cast<float>(u) + peakOffset(darkness(v, u - 1), here, darkness(v, u + 1)),
                static_cast<float>(v) + peakOffset(darkness(v - 1, u), here, darkness(v + 1, u)));
        }
    }
    return dots;
}

} // namespace teleta::vision
