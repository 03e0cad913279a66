// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/mcap/chunk_compression.h"
#include "backend/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace teleta::mcap {

struct McapExportOptions {
    /// Names of the streams to be written; empty: all.
    std::vector<std::string> streams = {};
    Compression compression = Compression::zstd;
    std::size_t chunkBytes = std::size_t{4} << 20U;
    /// Called now and then with the frames done so far and in total; returning false ends the export.
    std::function<bool(double frames, double allFrames)> goOn = {};
    /// Writes over an existing file.
    bool overwrite = false;
};

/// What was written.
struct McapExport {
    struct Topic {
        std::string name;
        std::string type;
        std::uint64_t messages = 0;
    };
    std::string path;
    std::vector<Topic> topics;
    std::uint64_t bytes = 0;
    std::uint64_t damagedBlocks = 0;  ///< that were left out
    std::vector<std::string> leftOut; ///< streams whose kind has no messages
    std::vector<std::string> turned;  ///< streams whose y has the other sign, in a right-handed frame
};

/// Writes streams and events of a recording as an MCAP file of ROS 2, as StreamEncoder describes it. Times
/// are UTC in ns: the steady time plus the offset of the first anchor. The metadata record "teleta" has
/// anchors, app_version, scene, start_utc and units; "teleta_streams" describes each stream, so that an
/// import gets it back. Attachments: the camera file of each camera, tare and gains of each array, scene and
/// configuration. Error: refused: an unknown stream, or the file exists; cancelled by goOn; ioFailed. No file
/// is left then, and an existing one is unchanged. Thread: the recording's.
[[nodiscard]] core::Expected<McapExport> exportMcap(const recording::Recording& recording,
                                                    const std::string& path,
                                                    const McapExportOptions& options = {});

} // namespace teleta::mcap
