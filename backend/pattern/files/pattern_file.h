// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/sampled_output.h"

#include <string>

namespace teleta::pattern {

/// Reads a pattern file; the format is told by the end of its name (see pattern_format.h). A file without an
/// id gets its name without the ending.
/// Error: notFound, ioFailed, badInput with the place; a format that is written only is refused.
[[nodiscard]] core::Expected<Pattern> loadPattern(const std::string& path);

/// A built-in pattern by its id, or a file.
[[nodiscard]] core::Expected<Pattern> findPattern(const std::string& idOrPath);

/// Writes a pattern file in the format of its name. The file appears when it is complete. samples: of CSV and
/// WAV files, all others leave them alone.
/// Error: refused with what the format cannot express; ioFailed.
[[nodiscard]] core::Expected<void> savePattern(const Pattern& pattern, const std::string& path,
                                               const SampleOptions& samples = {});

} // namespace teleta::pattern
