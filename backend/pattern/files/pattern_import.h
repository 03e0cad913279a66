// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/files/loss.h"
#include "backend/pattern/files/zip_archive.h"
#include "backend/pattern/model/pattern.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::pattern {

/// What a file leaves open. The own format ignores all of it.
struct ImportOptions {
    std::optional<Arm> arm;           ///< .tact with both arms; empty: the left one if it has effects
    std::vector<std::size_t> tactors; ///< for a file of one signal; empty: the tactor that the program wrote
                                      ///< into the file, else all
};

/// A pattern and what it lacks of its file.
struct PatternImport {
    Pattern pattern;
    std::vector<Loss> losses;
    bool oneSignal = false; ///< ImportOptions::tactors has a meaning
    bool bothArms = false;  ///< ImportOptions::arm has a meaning
};

/// Adds the signal of a file to one tactor of a pattern and extends the pattern to its length. Returns what
/// the file says of its source. Error: badInput with line and column.
using AddSignal = core::Expected<std::string> (*)(std::string text, const std::string& file,
                                                  std::size_t tactor, Pattern& pattern, LossCounter& losses);

/// Reads a file of one signal. file: for errors. Thread: any.
[[nodiscard]] core::Expected<PatternImport> importSignal(std::string text, const std::string& file,
                                                         const ImportOptions& options, AddSignal add);

/// Reads an archive of one file a tactor: the tactor is the number 1..6 before the ending of a name. Error:
/// badInput with the file inside the archive.
[[nodiscard]] core::Expected<PatternImport> importSignals(std::vector<ZipEntry> entries,
                                                          const std::string& file, const std::string& ending,
                                                          AddSignal add);

/// Moves the signal of the first tactor to others and counts LossKind::oneSignal unless it stays where the
/// program wrote it from. source: "tactor 3" in files that the program wrote.
void placeSignal(Pattern& pattern, const ImportOptions& options, const std::string& source,
                 LossCounter& losses);

} // namespace teleta::pattern
