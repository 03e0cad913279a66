// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_camera_device.h"

#include <utility>

namespace teleta::simulated {

SimulatedCameraDevice::SimulatedCameraDevice(std::unique_ptr<core::CameraGenerator> generator,
                                             const core::StopSwitch& stopSwitch, SimulatedCameraConfig config)
    : m_worker(std::move(generator), stopSwitch, std::move(config)) {
}

SimulatedCameraDevice::~SimulatedCameraDevice() {
    stop();
}

void SimulatedCameraDevice::start(core::Wakeup& consumer) {
    m_thread.start(m_worker, consumer);
}

void SimulatedCameraDevice::stop() {
    m_thread.stop(m_worker);
}

} // namespace teleta::simulated
