// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_array_device.h"

#include <utility>

namespace teleta::simulated {

SimulatedArrayDevice::SimulatedArrayDevice(std::unique_ptr<core::FrameGenerator> generator,
                                           const core::StopSwitch& stopSwitch, SimulatedArrayConfig config)
    : m_description(generator->description())
    , m_worker(std::move(generator), stopSwitch, std::move(config)) {
}

SimulatedArrayDevice::~SimulatedArrayDevice() {
    stop();
}

void SimulatedArrayDevice::start(core::Wakeup& consumer) {
    if (m_thread.joinable())
        return;
    m_worker.open(consumer);
    m_thread = std::jthread([this](const std::stop_token& stop) { m_worker.run(stop); });
}

void SimulatedArrayDevice::stop() {
    if (!m_thread.joinable())
        return;
    m_thread.request_stop();
    m_worker.wake();
    m_thread.join();
}

} // namespace teleta::simulated
