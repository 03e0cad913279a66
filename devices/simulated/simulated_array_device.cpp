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
    m_thread.start(m_worker, consumer);
}

void SimulatedArrayDevice::stop() {
    m_thread.stop(m_worker);
}

} // namespace teleta::simulated
