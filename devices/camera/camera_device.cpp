// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_device.h"

#include <utility>

namespace teleta::camera {

core::Expected<std::unique_ptr<CameraDevice>> CameraDevice::open(CameraConfig config) {
    auto stream = VideoStream::open(config.source, {config.width_px, config.height_px, config.rate_Hz});
    if (!stream)
        return core::Unexpected(stream.error());
    return std::unique_ptr<CameraDevice>(new CameraDevice(std::move(*stream), std::move(config)));
}

CameraDevice::CameraDevice(VideoStream stream, CameraConfig config)
    : m_nominalRate_Hz(stream.rate_Hz())
    , m_worker(std::move(stream), std::move(config)) {
}

CameraDevice::~CameraDevice() {
    stop();
}

void CameraDevice::start(core::Wakeup& consumer) {
    m_thread.start(m_worker, consumer);
}

void CameraDevice::stop() {
    m_thread.stop(m_worker);
}

} // namespace teleta::camera
