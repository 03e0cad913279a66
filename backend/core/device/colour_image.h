// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace teleta::core {

/// A colour picture, row by row without gaps: red, green and blue of each pixel, one byte each. Copies share
/// the immutable pixels.
struct ColourImage {
    std::shared_ptr<const std::uint8_t> pixels; ///< null: no picture
    int width_px = 0;
    int height_px = 0;

    [[nodiscard]] bool isEmpty() const { return pixels == nullptr || width_px <= 0 || height_px <= 0; }
};

/// The same bytes as the picture of a frame, which is three times as wide: so devices, recordings and
/// players need no second way for colours.
[[nodiscard]] inline GreyImage bytesOf(ColourImage image) {
    return {std::move(image.pixels), 3 * image.width_px, image.height_px};
}

/// The colour picture of which a frame has the bytes; empty: its width is no multiple of three.
[[nodiscard]] inline ColourImage colourOf(GreyImage bytes) {
    if (bytes.isEmpty() || bytes.width_px % 3 != 0)
        return {};
    return {std::move(bytes.pixels), bytes.width_px / 3, bytes.height_px};
}

} // namespace teleta::core
