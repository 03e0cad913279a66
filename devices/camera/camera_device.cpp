// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_device.h"

#include <filesystem>
#include <utility>

namespace teleta::camera {

core::Expected<std::unique_ptr<CameraDevice>> CameraDevice::open(CameraConfig config) {
    TELETA_TRY(VideoStream stream,
               VideoStream::open(config.source, {config.width_px, config.height_px, config.rate_Hz}));
    core::CameraDescription description;
    description.recorded = !isCameraNumber(config.source);
    description.name = description.recorded ? std::filesystem::path(config.source).filename().string()
                                            : "/dev/video" + config.source;
    description.nominalRate_Hz = stream.rate_Hz();
    return std::unique_ptr<CameraDevice>(
        new CameraDevice(std::move(stream), std::move(description), std::move(config)));
}

CameraDevice::CameraDevice(VideoStream stream, core::CameraDescription description, CameraConfig config)
    : m_description(std::move(description))
    , m_worker(std::move(stream), std::move(config)) {
}

} // namespace teleta::camera
