// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <string>

namespace teleta::pattern {

/// Converts a pattern to HJIF, the JSON form of ISO/IEC 23090-31 (MPEG haptics): one perception on the
/// forearm; one channel per tactor, whose direction is its place on the ring; vectorial waves whose amplitude
/// is the intensity. Times are rounded to milliseconds; the first point of a step is moved one millisecond
/// earlier. date: "2026-01-31". Error: refused when objects have too many corners. Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToHjif(const Pattern& pattern, const std::string& date);

/// Reads HJIF. A channel belongs to the tactor nearest to its direction, or without a direction to the tactor
/// of its index. Basis effects with keyframes are read; intensity is amplitude times the gain of the channel;
/// frequencies follow from it and are ignored. file: for errors. Error: badInput with line and column, also
/// for what a pattern cannot represent (other effects, more than six channels, libraries). Thread: any
/// (pure).
[[nodiscard]] core::Expected<Pattern> patternFromHjif(std::string text, const std::string& file);

} // namespace teleta::pattern
