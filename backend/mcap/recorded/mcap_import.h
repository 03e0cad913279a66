// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/mcap/recorded/message_decoder.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace teleta::mcap {

struct McapImportOptions {
    /// What topics are read as, where their type leaves a choice.
    std::map<std::string, TopicKind> topics = {};
    /// Called now and then with how much has been read, 0 to 1; returning false ends the import.
    std::function<bool(double share)> goOn = {};
};

/// What was read.
struct McapImport {
    struct Topic {
        std::string name;
        std::string type;
        std::string stream;         ///< that it became; empty: it was left
        std::uint64_t messages = 0; ///< that were taken
        std::uint64_t bad = 0;      ///< that were damaged, or of another shape than those before
        bool isKept =
            false; ///< what it says is in the recording: as a stream, as events, or by another topic
    };
    std::string path; ///< of the recording
    std::vector<Topic> topics;
    std::uint64_t frames = 0;
    std::uint64_t badChunks = 0;
    std::uint64_t badRecords = 0;
    bool isComplete = true;            ///< the file ends as it should
    std::uint64_t bytes = 0;           ///< of the file
    std::uint64_t wholeBytes = 0;      ///< up to its last whole record
    bool isDataSectionDamaged = false; ///< its checksum is wrong
};

/// Makes a recording of an MCAP file. An export of a recording gets back its streams, values, times (to 1
/// ns), events and anchors; but for the source's own times, which become those since the start. Other files:
/// arrays from Image (32FC1, 16UC1, mono16), TactileArray and Float32MultiArray of two dimensions; cameras
/// from Image (mono8, 8UC1) and CompressedImage (png, jpeg); joints from JointState; forces from
/// WrenchStamped; in CDR, with the names of ros2msg or ros2idl. Other topics are listed and left. Times are
/// log_time, and the source's own time is that of the header. Error: notFound, ioFailed; badInput: it is not
/// an MCAP file; refused: the recording exists, an unknown topic, or no topic can be read, with the list;
/// cancelled by goOn. No recording is left then. Thread: any, one.
[[nodiscard]] core::Expected<McapImport> importMcap(const std::string& path, const std::string& recordingPath,
                                                    const McapImportOptions& options = {});

/// Whether a file begins as an MCAP file does, whatever its name. Waits for the disk. Thread: any.
[[nodiscard]] bool looksLikeMcap(const std::string& path);

} // namespace teleta::mcap
