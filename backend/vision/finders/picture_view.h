// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>

namespace teleta::vision {

/// A view of the pixels of a picture without copying; empty when there is none. The pixels must not be
/// changed. Valid while the picture, or a copy of it, exists. Thread: any (pure).
[[nodiscard]] inline cv::Mat1b viewOf(const core::GreyImage& image) {
    if (image.isEmpty())
        return {};
    return {image.height_px, image.width_px, const_cast<std::uint8_t*>(image.pixels.get())};
}

} // namespace teleta::vision
