// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/pattern.h"

#include <string>
#include <vector>

namespace teleta::pattern {

/// The format .haptic 1.0: JSON with one amplitude envelope, hence one file per tactor. The frequency of
/// these motors follows the amplitude; its envelope is written equal to it and ignored when read. An emphasis
/// becomes a burst of kEmphasis_s. Thread: any (pure).
inline constexpr double kEmphasis_s = 0.05;

/// The file of one tactor. Error: refused when objects have too many corners.
[[nodiscard]] core::Expected<std::string> tactorToHaptic(const Pattern& pattern, std::size_t tactor);

/// "tactor1.haptic" ... "tactor6.haptic".
[[nodiscard]] core::Expected<std::vector<ZipEntry>> patternToHaptics(const Pattern& pattern);

/// The tactor of an entry is the number 1..6 at the end of its base name. file: name of the archive, for
/// errors. Error: badInput with entry, line and column.
[[nodiscard]] core::Expected<Pattern> patternFromHaptics(std::vector<ZipEntry> entries,
                                                         const std::string& file);

/// Reads a single file as the pattern of the first tactor.
[[nodiscard]] core::Expected<Pattern> patternFromHaptic(std::string text, const std::string& file);

} // namespace teleta::pattern
