// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/channel.h"

#include <QString>

#include <memory>
#include <string>
#include <vector>

namespace teleta::app {

/// One source of a recording of this program (.teleta): an array, an arm with its skin, or a camera.
struct RecordingRequest {
    std::string path;
    std::string stream; ///< name of the array's or the camera's stream
    std::string source; ///< the device, as people know it
    bool loop = false;
    bool settingsChanged = false; ///< of the array, while it was recorded: the first ones are used
};

/// Whether a file is to be opened as a recording of this program, by its name.
[[nodiscard]] bool isRecordingName(const QString& path);
/// The same of an MCAP file, of which a recording is made first.
[[nodiscard]] bool isMcapName(const QString& path);
/// A file of frames of NumPy, HDF5, MATLAB or Tekscan by its name.
[[nodiscard]] bool isFrameFileName(const QString& path);
/// It is played as the recording that is made of it: MCAP, or frames of another program.
[[nodiscard]] bool isImported(const QString& path);
/// The same of whatever is played back: recordings, imported files and frames in CSV.
[[nodiscard]] bool isPlayable(const QString& path);

/// All sources of a recording. Reads the file: not on the GUI's thread. Error: as Recording::open and
/// pipeline::recordedSources.
[[nodiscard]] core::Expected<std::vector<RecordingRequest>> recordingRequestsOf(const std::string& path);

/// Opens a source of a recording, which waits at its begin; all of them are played from the first frame of
/// any to the last one. Not on the GUI's thread. Error: as recordingRequestsOf.
[[nodiscard]] core::Expected<std::shared_ptr<pipeline::Channel>>
openRecording(const RecordingRequest& request, const core::StopSwitch& stop);

} // namespace teleta::app
