// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording_types.h"

#include <span>
#include <string>

namespace teleta::recording {

class RecordingDatabase;

/// Carries out the changes in order, within the caller's transaction. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeMarkChanges(RecordingDatabase& database,
                                                    std::span<const MarkChange> changes);

/// Changes the marks of a finished recording: all or none. Waits for the disk and briefly for readers of the
/// file: not on the GUI's thread. Error: as Recording::open; ioFailed: it cannot be written.
[[nodiscard]] core::Expected<void> changeMarks(const std::string& path, std::span<const MarkChange> changes);

} // namespace teleta::recording
