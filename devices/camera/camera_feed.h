// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "devices/camera/camera_device.h"

#include <memory>

namespace teleta::camera {

/// A camera or a video as a source of the running system. Thread: as core::CameraSource.
class CameraFeed : public core::CameraSource {
public:
    /// Error: as CameraDevice::open.
    [[nodiscard]] static core::Expected<std::unique_ptr<CameraFeed>> open(CameraConfig config);

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_device->start(consumer); }
    void stop() override { m_device->stop(); }
    bool pop(core::CameraFrame& frame) override { return m_device->frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_device->status(); }

private:
    CameraFeed(std::unique_ptr<CameraDevice> device, core::CameraDescription description);

    std::unique_ptr<CameraDevice> m_device;
    core::CameraDescription m_description;
};

} // namespace teleta::camera
