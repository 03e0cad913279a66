// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace teleta::recording {

/// One file that was written.
struct ExportedFile {
    std::string path;
    std::uint64_t rows = 0;
    std::uint64_t damagedBlocks = 0; ///< that were left out
};

struct ExportOptions {
    /// Called now and then with the frames so far and of all streams; false ends the export.
    std::function<bool(double frames, double allFrames)> goOn = {};
    /// An export that is ended so finishes its files: the rows so far of the stream at hand, no files of
    /// those after it, and the events. Otherwise it leaves none.
    bool finishesWhenEnded = false;
    /// Files that are there already are written over.
    bool overwrite = false;
};

/// Writes each stream as NAME.csv into a folder, which is made when it is missing, and events.csv. Names that
/// would be the same get numbers. Times are since the start of the recording, from the steady clock.
/// - array: time_s,t0,t1,... as `teleta features` reads them
/// - joints: time_s,joint_angle_rad,joint_torque_nm,q1,... the elbow first, as `teleta stiffness` reads it
/// - features: time_s,contact_type,force_n,... as `teleta features` writes them
/// - camera: time_s,frame_time_s,width_px,height_px, the pictures' times
/// - others: time_s and the stream's own columns; NA where there is no value
/// - events: time_s,utc,event,text,value
/// Damaged blocks are left out and counted. The files appear together at the end: a file that is cut short,
/// or the first of several, would be taken for a whole export.
/// Error: ioFailed; cancelled by goOn, unless it finishes its files; refused when there is a file already.
/// Then no file of it is left. Files that were there stay as they were, unless the last step failed, in which
/// the new ones take their names.
[[nodiscard]] core::Expected<std::vector<ExportedFile>>
exportCsv(const Recording& recording, const std::string& folder, const ExportOptions& options = {});

} // namespace teleta::recording
