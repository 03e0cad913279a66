// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/recording_request.h"
#include "app/sources/site_request.h"
#include "backend/core/data/array_layout.h"
#include "backend/core/device/required_devices.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/touch_pipeline.h"
#include "devices/wts/wts_config.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace teleta::app {

/// A recorded run of tactile frames (CSV) to be played back.
struct CsvRequest {
    std::string path;
    core::ArrayLayout layout;
    std::string tarePath;  ///< recording of the unloaded array; empty: none
    std::string gainsPath; ///< gains of its taxels; empty: none
    bool inverted = false;
    double gain = 1.0;
    double threshold_N = 0.2;
    double rate_Hz = 0.0; ///< play one frame per 1/rate_Hz; 0: at the recorded times
    double speed = 1.0;
    bool loop = true;
    std::string loadUnit = "N"; ///< shown with every load
};

/// A simulated scene (TOML).
struct SceneRequest {
    std::string path; ///< a file, or ":/scenes/NAME.toml" for one that comes with the program
    std::uint64_t seed = 1;
};

/// A Weiss WTS array that is connected.
struct WtsRequest {
    wts::WtsConfig config;
    double gain = 1.0;                              ///< load units per count
    std::optional<double> threshold = std::nullopt; ///< in load units; empty: 1 % of the sensor's full scale
    std::string loadUnit = "counts";                ///< shown with every load
    std::string gainsPath = {};                     ///< gains of its taxels; empty: none
};

/// A camera in a soft tube that is connected, or a video of one.
struct CameraRequest {
    std::string source;    ///< a file, a pattern of numbered images or the number of a camera
    std::string modelPath; ///< camera file (JSON) of its calibration
    bool loop = true;      ///< of a file
};

/// A flat gel with markers in front of a camera that is connected, or a video of one.
struct GelRequest {
    std::string path; ///< the file that describes it, see vision::readMarkerGel()
    bool loop = true; ///< of a video
};

/// A camera that is only looked at, or a video.
struct SceneCameraRequest {
    /// The number of a camera, a video, a pattern of numbered pictures, or a file that describes a camera
    /// over ROS 2, see ros_camera::readRosCamera().
    std::string source;
    int width_px = 0; ///< asked of a camera; 0: its own
    int height_px = 0;
    double rate_Hz = 0.0;
    bool loop = true; ///< of a video
};

/// An array that a file describes.
struct TaxelsRequest {
    std::string path; ///< the file, see readArrayFile()
};

/// An arm over ROS 2, or one whose joints a Modbus device reports.
struct ArmRequest {
    std::string path; ///< the file that describes it, see ros_arm::readRosArm(), modbus::readRegisterMap()
    /// The devices that the file may require; null: nobody knows them, and such a file is refused.
    std::shared_ptr<const core::RequiredDevices> required = {};
};

using SourceRequest = std::variant<CsvRequest, SceneRequest, WtsRequest, CameraRequest, RecordingRequest,
                                   ArmRequest, SiteRequest, TaxelsRequest, GelRequest, SceneCameraRequest>;

/// Name under which people know the source: the file name without its folder, or the name of the link.
[[nodiscard]] QString displayName(const SourceRequest& request);

/// The same, a file with its extension, for messages.
[[nodiscard]] QString fileName(const SourceRequest& request);

/// What opens the source on the pipeline's control thread. stop outlives the source. cancelled: asked while
/// it waits for a device that may never answer; the factory then fails as cancelled. The factory of a site's
/// device keeps the connection.
[[nodiscard]] pipeline::SourceFactory makeSourceFactory(SourceRequest request, const core::StopSwitch& stop,
                                                        std::function<bool()> cancelled = {});

/// Fills in what a recording's own file tells: the layout by the number of its taxel columns (known arrays
/// first, else the most square factorisation), and as tare the file beside it whose name differs by "empty".
/// Reads the header line only. Thread: any but the GUI's.
[[nodiscard]] core::Expected<CsvRequest> guessCsv(const std::string& path);

} // namespace teleta::app
