// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_feed.h"

#include <filesystem>
#include <utility>

namespace teleta::camera {

core::Expected<std::unique_ptr<CameraFeed>> CameraFeed::open(CameraConfig config) {
    core::CameraDescription description;
    description.recorded = !isCameraNumber(config.source);
    description.name = description.recorded ? std::filesystem::path(config.source).filename().string()
                                            : "/dev/video" + config.source;
    auto device = CameraDevice::open(std::move(config));
    if (!device)
        return core::Unexpected(device.error());
    description.nominalRate_Hz = (*device)->nominalRate_Hz();
    return std::unique_ptr<CameraFeed>(new CameraFeed(std::move(*device), std::move(description)));
}

CameraFeed::CameraFeed(std::unique_ptr<CameraDevice> device, core::CameraDescription description)
    : m_device(std::move(device))
    , m_description(std::move(description)) {
}

} // namespace teleta::camera
