// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/colour_image.h"
#include "backend/core/error.h"

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::site_link {

/// A picture as JPEG (ITU-T T.81). quality: 1 to 100, as the Independent JPEG Group means it. Error:
/// unavailable, the coder of OpenCV is not there; refused, it cannot code this picture. Thread: any.
[[nodiscard]] core::Expected<std::vector<std::uint8_t>> toJpeg(const core::ColourImage& picture, int quality);
/// The same of a grey picture.
[[nodiscard]] core::Expected<std::vector<std::uint8_t>> toJpeg(const core::GreyImage& picture, int quality);

/// Whether bytes begin and end as a JPEG picture does: one that was cut off does not. Thread: any (pure).
[[nodiscard]] bool isWholeJpeg(std::span<const std::uint8_t> bytes);

} // namespace teleta::site_link
