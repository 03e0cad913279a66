// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/pattern.h"

#include <string>
#include <vector>

namespace teleta::pattern {

/// .haptic 1.0: JSON with one amplitude envelope, so one file a tactor. Frequency follows amplitude with
/// these motors: its envelope is written equal to it and left out when reading. An emphasis becomes a burst
/// of kEmphasis_s. Thread: any (pure).
inline constexpr double kEmphasis_s = 0.05;

/// The file of one tactor. Error: refused when objects have too many corners.
[[nodiscard]] core::Expected<std::string> tactorToHaptic(const Pattern& pattern, std::size_t tactor);

/// "tactor1.haptic" ... "tactor6.haptic".
[[nodiscard]] core::Expected<std::vector<ZipEntry>> patternToHaptics(const Pattern& pattern);

/// The number 1..6 before the ending of an entry's name tells its tactor. Error: badInput with entry, line
/// and column. file: of the archive.
[[nodiscard]] core::Expected<Pattern> patternFromHaptics(std::vector<ZipEntry> entries,
                                                         const std::string& file);

/// One file, for the first tactor.
[[nodiscard]] core::Expected<Pattern> patternFromHaptic(std::string text, const std::string& file);

} // namespace teleta::pattern
