// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"

#include <string>

namespace teleta::mcap {

enum class PngPixel { grey, colour };

/// A picture as PNG, 8-bit grey or, where it has the bytes of core::ColourImage, red, green and blue. Rows
/// without filter: fast, where what holds it is compressed anyway. level: of zlib, 0 (stored) to 9. Thread:
/// any (pure). Source: PNG specification, third edition.
[[nodiscard]] std::string encodePng(const core::GreyImage& image, int level, PngPixel pixel = PngPixel::grey);

} // namespace teleta::mcap
