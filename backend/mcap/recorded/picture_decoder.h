// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/mcap/recorded/png_encoder.h"

#include <optional>
#include <string_view>

namespace teleta::mcap {

/// Pixels of a picture, at most.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 26U;

/// A PNG or JPEG picture as grey levels of 8 bits, or as the bytes of core::ColourImage; empty: it is
/// another, damaged, or too large, or opencv::pictures() fails. Thread: any.
[[nodiscard]] std::optional<core::GreyImage> decodePicture(std::string_view bytes,
                                                           PngPixel pixel = PngPixel::grey);

} // namespace teleta::mcap
