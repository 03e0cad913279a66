// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace teleta::frames {

struct NpzExportOptions {
    std::string stream = {}; ///< an array; empty: the only one
    bool overwrite = false;
    /// Called now and then with the frames done so far and in total; returning false ends the export.
    std::function<bool(double frames, double allFrames)> goOn = {};
};

/// What was written.
struct NpzExport {
    std::string path;
    std::string stream;
    std::vector<std::uint64_t>
        shape; ///< frames, rows, columns; or frames, taxels; of vectors frames, taxels, 3
    std::uint64_t damagedBlocks = 0; ///< that were left out
};

/// Writes an array of a recording as npz: frames (float32, raw values) and time_s (float64, since the start
/// of the recording). A grid of loads is frames x rows x columns. Loads off a grid are frames x taxels,
/// vectors frames x taxels x 3, in the order of the layout; positions_m (taxels x 3, float64) tells where the
/// taxels stand then. Error: ioFailed; cancelled by goOn; refused when the file
/// exists, when the recording has no array, or several and none is named; no file is left then. Thread: the
/// recording's.
[[nodiscard]] core::Expected<NpzExport> exportNpz(const recording::Recording& recording,
                                                  const std::string& path, const NpzExportOptions& options);

} // namespace teleta::frames
