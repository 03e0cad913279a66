// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/model/pattern_map.h"

#include <string>

namespace teleta::pattern {

/// The program's own pattern format, JSON in UTF-8, version 1:
///   {"format": "teleta-pattern", "version": 1, "id", "name", "task", "condition", "notes", "tags",
///    "duration_s", "tracks": [6 x [[time_s, intensity, easing?] ...]], "objects": [{"type", "name", ...}]}
/// Tactors are numbered 1..6. Unknown keys, here and in objects, are kept and written back. file: for errors.
/// Error: badInput with line and column, also for a newer version. Thread: any (pure).
[[nodiscard]] core::Expected<Pattern> patternFromJson(std::string text, const std::string& file);

/// Error: refused when the pattern has values that patternFromJson() would not accept (NaN, out of range).
[[nodiscard]] core::Expected<std::string> patternToJson(const Pattern& pattern);

/// {"format": "teleta-pattern-map", "version": 1, "stiffness": [5 ids], "shape": {"circle": id, ...}}; a
/// missing shape has no pattern. Thread: any (pure).
[[nodiscard]] core::Expected<PatternMap> patternMapFromJson(std::string text, const std::string& file);
[[nodiscard]] std::string patternMapToJson(const PatternMap& map);

} // namespace teleta::pattern
