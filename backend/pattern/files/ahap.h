// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/pattern.h"

#include <string>
#include <vector>

namespace teleta::pattern {

inline constexpr std::size_t kMostCurvePoints = 16;
inline constexpr double kLongestEvent_s = 30.0;

/// Converts one tactor to AHAP: continuous events of at most kLongestEvent_s while it is on, and curves of
/// the intensity (the square root of the amplitude) with at most kMostCurvePoints points, whose times count
/// from the start of the curve. Error: refused when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> tactorToAhap(const Pattern& pattern, std::size_t tactor);

/// "tactor1.ahap" ... "tactor6.ahap".
[[nodiscard]] core::Expected<std::vector<ZipEntry>> patternToAhaps(const Pattern& pattern);

} // namespace teleta::pattern
