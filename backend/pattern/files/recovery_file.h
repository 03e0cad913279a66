// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"

#include <cstdint>
#include <string>

namespace teleta::pattern {

/// Edits that the user has not saved.
struct RecoveredPattern {
    Pattern pattern;
    std::string path;           ///< of the file that was edited; empty: it had none
    std::int64_t edited_ms = 0; ///< since 1970-01-01 UTC
};

/// A recovery file is a pattern file in the program's own format with one more key,
///   "recovery": {"path", "edited_ms"}
/// so that every reader of patterns can read it. It is written atomically and durably. Error: ioFailed.
/// Thread: any.
[[nodiscard]] core::Expected<void> writeRecovery(const std::string& file, const RecoveredPattern& recovered);
/// Error: as loadPattern(); badInput without the key.
[[nodiscard]] core::Expected<RecoveredPattern> readRecovery(const std::string& file);

} // namespace teleta::pattern
