// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/mcap/mcap_reader.h"
#include "backend/recording/recording_types.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace teleta::mcap {

/// A stream as the note of an export describes it.
struct NotedStream {
    recording::StreamInfo info;
    bool turnsY = false; ///< y has the other sign in the file
};

/// What an MCAP file says of the recording that it becomes.
struct ImportedRecording {
    recording::RecordingHead head;
    std::vector<recording::TimeAnchor> anchors;
    std::int64_t utcOffset_ns = 0; ///< UTC = steady time + this
    bool isExport = false;         ///< a recording was exported to it
    /// Of an export, by the first part of their topics; in the order in which they were recorded.
    std::vector<std::pair<std::string, NotedStream>> streams;
};

/// Reads the notes of an export. A file without them, or with damaged ones, begins with its first message.
/// Thread: the reader's.
[[nodiscard]] ImportedRecording importedRecording(McapReader& reader, const std::string& path);

} // namespace teleta::mcap
