// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/taxel_layout.h"
#include "backend/core/error.h"
#include "backend/frames/frame_reader.h"
#include "backend/pipeline/touch/touch_snapshot.h"

#include <cstdint>
#include <functional>
#include <string>

namespace teleta::frames {

struct FrameImportOptions {
    std::string name{}; ///< of the array; empty: that of the file
    /// How its frames are evaluated when they are played. An empty loadUnit is that of the file, or else of
    /// the likely array of so many taxels.
    pipeline::ChannelSettings settings{
        .conditioning = {}, .features = {}, .segmentation = {}, .loadUnit = {}};
    /// Called now and then with the share that is done, 0..1; returning false ends the import.
    std::function<bool(double share)> goOn = {};
};

/// What was made.
struct FrameImport {
    std::string path;
    std::string stream;
    core::TaxelLayout layout{};
    std::uint64_t frames = 0;
    double rate_Hz = 0.0; ///< mean; 0: a single frame
};

/// Makes a recording of the frames of another program, which the console plays and everything else reads.
/// file: where the frames come from. The recording begins with the first frame; a first time between the
/// years 2000 and 2100 in seconds since 1970 is that of the wall clock, otherwise it is not known. Error: as
/// recording::makeRecording() and FrameReader::next(); cancelled by goOn; no file is left then. Thread: any.
[[nodiscard]] core::Expected<FrameImport> importFrames(FrameReader frames, const std::string& file,
                                                       const std::string& recording,
                                                       const FrameImportOptions& options);

} // namespace teleta::frames
