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
    if (m_thread.joinable())
        return;
    m_worker.open(consumer);
    m_thread = std::jthread([this](const std::stop_token& stop) { m_worker.run(stop); });
}

void SimulatedCameraDevice::stop() {
    if (!m_thread.joinable())
        return;
    m_thread.request_stop();
    m_worker.wake();
    m_thread.join();
    m_thread = {};
}

} // namespace teleta::simulated
