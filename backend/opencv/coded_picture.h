// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace teleta::opencv {

/// Whether bytes begin as a PNG or JPEG picture that has so many pixels at most. Asked before they are
/// decoded, since a few bytes can claim any size. Thread: any (pure). Source: PNG specification, third
/// edition; ITU-T T.81, annex B.
[[nodiscard]] bool isPicture(std::string_view bytes, std::size_t mostPixels);
/// Whether they begin as one with colours; false for grey levels, and for what begins as no picture. Thread:
/// any (pure).
[[nodiscard]] bool isColourPicture(std::string_view bytes);

} // namespace teleta::opencv
