// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"
#include "backend/core/error.h"
#include "backend/core/keys/keys.h"

#include <string>
#include <string_view>
#include <vector>

namespace teleta::app {

/// What a [[source]] of a list is.
enum class SourceKind {
    scene,       ///< a simulated scene
    recording,   ///< frames of an array as CSV; what is missing is guessed as in guessCsv
    playback,    ///< a recording of this program, all sources of it
    wts,         ///< a Weiss array
    camera,      ///< a camera in a soft tube, or a video of one
    arm,         ///< an arm over ROS 2, or the joints of a Modbus device
    taxels,      ///< an array that a file describes
    gel,         ///< a flat gel with markers, or a video of one
    sceneCamera, ///< a camera that is only looked at, or a video
};

/// Describes the keys of a source and adds what it opens. Relative paths start at the list's folder.
void describeSource(core::Keys& keys, SourceKind kind, const std::string& listPath,
                    std::vector<SourceRequest>& requests);

/// Describes the keys of a camera that is only looked at. key: the one that names it.
void describeSceneCamera(core::Keys& keys, std::string_view key, const std::string& listPath,
                         SceneCameraRequest& request);

/// Reads a source list (TOML): one [[source]] a tactile array, an arm or a camera, in the order in which they
/// open. A file that describes an array, a gel or a camera over ROS 2 is a list of that one. Errors carry
/// file, line and column. Reads the header of each recording: not on the GUI's thread.
[[nodiscard]] core::Expected<std::vector<SourceRequest>> readSourceList(const std::string& path);

/// Whether a TOML file means to be a source list, whatever is wrong with its sources: it has a key "source",
/// which no scene has, or it describes an array, a gel or a camera over ROS 2. A file that cannot be read at
/// all is none. Not on the GUI's thread.
[[nodiscard]] bool isSourceList(const std::string& path);

/// Whether a TOML file means to describe an arm over ROS 2 or a Modbus device, whatever is wrong with it. Not
/// on the GUI's thread.
[[nodiscard]] bool isArmFile(const std::string& path);
/// The same of a Modbus device alone, which may tell the joints of an arm.
[[nodiscard]] bool isModbusFile(const std::string& path);
/// The same of a site as a console sees it.
[[nodiscard]] bool isSiteFile(const std::string& path);

} // namespace teleta::app
