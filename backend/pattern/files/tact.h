// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <string>

namespace teleta::pattern {

/// Length of the constant pieces that approximate slopes.
inline constexpr int kTactPiece_ms = 20;

/// Converts a pattern to .tact with the layout of a forearm (ForearmL or ForearmR, six motors) in DOT_MODE:
/// one effect with constant pieces at whole milliseconds. Error: refused when objects have too many corners.
/// Thread: any (pure).
[[nodiscard]] core::Expected<std::string> patternToTact(const Pattern& pattern);

/// Reads the dots of ForearmL, or of ForearmR when there is no ForearmL, with the playback types NONE,
/// FADE_IN, FADE_OUT and FADE_IN_OUT. Disabled tracks are ignored. file: for errors. Error: badInput with
/// line and column, also for what a pattern cannot represent (paths, other devices only). Thread: any (pure).
[[nodiscard]] core::Expected<Pattern> patternFromTact(std::string text, const std::string& file);

} // namespace teleta::pattern
