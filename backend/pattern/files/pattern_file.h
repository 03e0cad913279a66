// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/pattern_format.h"
#include "backend/pattern/files/pattern_import.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/sampled_output.h"

#include <string>
#include <vector>

namespace teleta::pattern {

/// Reads a pattern file in the format of its file name extension (see pattern_format.h). A pattern without an
/// id gets the base name of the file. Error: notFound, ioFailed; badInput with line and column, also for
/// formats that are only written. Thread: any.
[[nodiscard]] core::Expected<Pattern> loadPattern(const std::string& path);

/// The same, with what the pattern lacks of the file.
[[nodiscard]] core::Expected<PatternImport> importPattern(const std::string& path,
                                                          const ImportOptions& options = {});

/// Returns a built-in pattern by its id, or reads a file.
[[nodiscard]] core::Expected<Pattern> findPattern(const std::string& idOrPath);
[[nodiscard]] core::Expected<PatternImport> findImport(const std::string& idOrPath,
                                                       const ImportOptions& options = {});

/// What a file of a format will lack of a pattern; empty for the own format, and for samples. Error: as
/// savePattern(). Thread: any (pure).
[[nodiscard]] core::Expected<std::vector<Loss>> exportLosses(const Pattern& pattern, PatternFormat format);

/// Writes a pattern file atomically, in the format of its file name extension. samples: for CSV and WAV
/// files, ignored by all others. Error: refused with what the format cannot express; ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> savePattern(const Pattern& pattern, const std::string& path,
                                               const SampleOptions& samples = {});

} // namespace teleta::pattern
