// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_feed.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace teleta::camera {

bool isCameraNumber(const std::string& source) {
    return !source.empty() && std::ranges::all_of(source, [](char c) { return c >= '0' && c <= '9'; });
}

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

bool CameraFeed::pop(core::CameraFrame& frame) {
    CameraFrame taken;
    if (!m_device->frames().pop(taken))
        return false;
    frame = {.image = {},
             .time_ns = taken.time_ns,
             .capture_s = taken.capture_s,
             .number = taken.number,
             .discontinuity = taken.discontinuity};
    if (taken.image.empty())
        return true;
    const auto kept = std::make_shared<cv::Mat1b>(taken.image.isContinuous() ? std::move(taken.image)
                                                                             : taken.image.clone());
    frame.image = {{kept, kept->data}, kept->cols, kept->rows};
    return true;
}

} // namespace teleta::camera
