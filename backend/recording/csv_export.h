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
    std::uint64_t rows = 0;          ///< 0 of recording.json
    std::uint64_t damagedBlocks = 0; ///< that were left out
};

struct ExportOptions {
    /// Called now and then with the frames done so far and in total; returning false ends the export.
    std::function<bool(double frames, double allFrames)> goOn = {};
    /// An export ended by goOn keeps its files: those of the streams so far, the last one incomplete, and the
    /// events. Otherwise it leaves none.
    bool finishesWhenEnded = false;
    /// Adds a last column utc_s to each file: Unix time in s with nine decimals.
    bool utc = false;
    /// Overwrites existing files.
    bool overwrite = false;
};

/// Writes each stream as NAME.csv, events.csv, and recording.json, into a folder, which is created if
/// missing. Equal names get numbers. Times are since the start of the recording, from the steady clock.
/// - array: time_s,t0,t1,... as `teleta features` reads them; of vectors time_s,t0_x,t0_y,t0_z,t1_x,...
/// - joints: time_s,joint_angle_rad,joint_torque_nm,q1,... the elbow first, as `teleta stiffness` reads it
/// - features: time_s,contact_type,force_n,... as `teleta features` writes them
/// - camera: time_s,frame_time_s,width_px,height_px, the pictures' times
/// - others: time_s and the stream's own columns; NA where there is no value
/// - events: time_s,utc,event,text,value
/// - recording.json, the last of the files: see exportDescription()
/// Damaged blocks are skipped and counted. All files appear together at the end, so that a partial export
/// cannot be mistaken for a whole one.
/// Error: ioFailed; cancelled by goOn, unless the files are to be kept; refused when a file exists already.
/// No new file is left then, and existing files are unchanged unless renaming the new ones failed midway.
[[nodiscard]] core::Expected<std::vector<ExportedFile>>
exportCsv(const Recording& recording, const std::string& folder, const ExportOptions& options = {});

} // namespace teleta::recording
