// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::figure {

/// Pictures for a screen have so many pixels for each px of the SVG.
inline constexpr double kPngScale = 2.0;

/// An SVG with a size in px as the bytes of a PDF of one page of that size (96 px an inch): text stays text,
/// lines stay lines. Error: badInput when it is no SVG or has no size, ioFailed. Thread: any.
[[nodiscard]] core::Expected<std::string> pdfOf(const std::string& svg);

/// The same as the bytes of a PNG. scale: pixels for each px, > 0. Error: as pdfOf(), and badInput for more
/// than 32767 pixels a side.
[[nodiscard]] core::Expected<std::string> pngOf(const std::string& svg, double scale = kPngScale);

} // namespace teleta::figure
