// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_camera_worker.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace teleta::simulated {

SimulatedCameraWorker::SimulatedCameraWorker(std::unique_ptr<core::CameraGenerator> generator,
                                             const core::StopSwitch& stopSwitch, SimulatedCameraConfig config)
    : m_generator(std::move(generator))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_description(m_generator->description())
    , m_frames(m_config.queueFrames)
    , m_link(m_config.clock, m_description.nominalRate_Hz, m_config.faults, m_config.faultSeed) {
}

void SimulatedCameraWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_status = {};
    m_number = 0;
    m_lost = 0;
    begin();
}

void SimulatedCameraWorker::run(const std::stop_token& stop) {
    SimulatedLink::Lock lock = m_link.lock();
    begin();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_link.faults(lock);
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        if (std::exchange(silent, faults.silent) && !faults.silent)
            m_link.restart();
        const std::int64_t due = faults.silent ? core::PacingClock::kNever_ns : m_link.due_ns(faults.lag_s);
        if (due > m_link.now_ns()) {
            m_link.waitUntil(lock, due);
            continue;
        }
        lock.unlock();
        makeFrame(faults);
        lock.lock();
        if (const std::int64_t late_ns = m_link.now_ns() - m_link.due_ns(faults.lag_s); late_ns > 0)
            m_link.standStill(late_ns);
    }
    enter(core::DeviceState::closed);
    m_discontinuity = true;
}

void SimulatedCameraWorker::begin() {
    m_link.restart();
    enter(core::DeviceState::connecting);
}

void SimulatedCameraWorker::waitForPlug(SimulatedLink::Lock& lock, const std::stop_token& stop) {
    const std::string message =
        QCoreApplication::translate("SimulatedCameraDevice", "The camera was unplugged.").toStdString();
    if (!m_link.waitForPlug(lock, stop, [&](core::DeviceState state) { enter(state, message); }))
        return;
    m_discontinuity = true;
    begin();
}

void SimulatedCameraWorker::makeFrame(const SimulatedFaults& faults) {
    core::CameraFrame frame;
    if (m_generator->next(frame.image, m_stopSwitch.engaged()))
        m_discontinuity = true;
    m_link.count();
    frame.number = m_number++;
    if (m_link.happens(faults.dropShare)) {
        ++m_lost;
        publish();
        return;
    }
    if (m_link.happens(m_config.undecodableShare)) {
        ++m_lost;
        frame.image = {};
    }
    frame.time_ns = m_link.now_ns();
    frame.capture_s = m_generator->time_s();
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_status.lastData_ns = frame.time_ns;
    ++m_status.framesRead;
    m_rate.add(frame.time_ns);
    m_frames.push(std::move(frame));
    if (m_status.state != core::DeviceState::live)
        enter(core::DeviceState::live);
    else
        publish();
}

void SimulatedCameraWorker::enter(core::DeviceState state, std::string message) {
    m_status.state = state;
    m_status.since_ns = m_link.now_ns();
    m_status.message = std::move(message);
    if (state != core::DeviceState::live)
        m_rate.reset();
    publish();
}

void SimulatedCameraWorker::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_status.framesLost = m_lost;
    m_published.set(m_status);
    m_consumer->notify();
}

} // namespace teleta::simulated
