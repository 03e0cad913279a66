// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_camera_device.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::simulated {

SimulatedCameraDevice::SimulatedCameraDevice(std::unique_ptr<core::CameraGenerator> generator,
                                             const core::StopSwitch& stopSwitch, SimulatedCameraConfig config)
    : SimulatedWorker(config.clock, generator->description().nominalRate_Hz, config.faults, config.faultSeed)
    , m_generator(std::move(generator))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_description(m_generator->description())
    , m_outlet(m_config.queueFrames) {
}

void SimulatedCameraDevice::open(core::Wakeup& consumer) {
    m_number = 0;
    m_outlet.open(consumer, now_ns());
}

std::string SimulatedCameraDevice::unpluggedMessage() const {
    return QCoreApplication::translate("SimulatedCameraDevice", "The camera was unplugged.").toStdString();
}

void SimulatedCameraDevice::makeDue(const SimulatedFaults& faults, std::int64_t /*now_ns*/) {
    makeFrame(faults);
    if (const std::int64_t late_ns = now_ns() - due_ns(faults.lag_s); late_ns > 0)
        standStill(late_ns);
}

void SimulatedCameraDevice::makeFrame(const SimulatedFaults& faults) {
    core::CameraFrame frame;
    if (m_generator->next(frame.image, m_stopSwitch.engaged()))
        m_discontinuity = true;
    count();
    frame.number = m_number++;
    if (happens(faults.dropShare)) {
        m_outlet.lose(1);
        return;
    }
    if (happens(m_config.undecodableShare)) {
        m_outlet.lose(1);
        frame.image = {};
    }
    frame.time_ns = now_ns();
    frame.capture_s = m_generator->time_s();
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::move(frame));
}

} // namespace teleta::simulated
