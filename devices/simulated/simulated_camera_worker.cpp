// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_camera_worker.h"

#include "devices/simulated/simulated_times.h"

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
    , m_faults(m_config.faults)
    , m_random(m_config.faultSeed) {
}

void SimulatedCameraWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_status = {};
    m_number = 0;
    m_lost = 0;
    m_overflowAtOpen = m_frames.overflow();
    begin();
}

void SimulatedCameraWorker::run(const std::stop_token& stop) {
    Lock lock(m_mutex);
    begin();
    bool silent = false;
    while (!stop.stop_requested()) {
        const SimulatedFaults faults = m_faults;
        if (faults.unplugged) {
            waitForPlug(lock, stop);
            continue;
        }
        if (std::exchange(silent, faults.silent) && !faults.silent) {
            m_epoch_ns = now_ns();
            m_sinceEpoch = 0;
        }
        const std::int64_t due = faults.silent ? core::PacingClock::kNever_ns : due_ns(faults.lag_s);
        if (due > now_ns()) {
            m_config.clock->waitUntil(m_condition, lock, due);
            continue;
        }
        lock.unlock();
        makeFrame(faults);
        lock.lock();
        if (const std::int64_t late_ns = now_ns() - due_ns(faults.lag_s); late_ns > 0)
            m_epoch_ns += late_ns;
    }
    enter(core::DeviceState::closed);
    m_discontinuity = true;
}

void SimulatedCameraWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void SimulatedCameraWorker::setFaults(const SimulatedFaults& faults) {
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
    m_condition.notify_all();
}

SimulatedFaults SimulatedCameraWorker::faults() const {
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

void SimulatedCameraWorker::begin() {
    m_epoch_ns = now_ns();
    m_sinceEpoch = 0;
    enter(core::DeviceState::connecting);
}

/// Behaves as a driver does whose device is gone: says so, then tries again less and less often.
void SimulatedCameraWorker::waitForPlug(Lock& lock, const std::stop_token& stop) {
    const std::string message =
        QCoreApplication::translate("SimulatedCameraDevice", "The camera was unplugged.").toStdString();
    enter(core::DeviceState::lost, message);
    for (std::int64_t retry_ns = kFirstRetry_ns;; retry_ns = std::min(2 * retry_ns, kLongestRetry_ns)) {
        const std::int64_t deadline_ns = now_ns() + retry_ns;
        while (now_ns() < deadline_ns) {
            if (stop.stop_requested())
                return;
            m_config.clock->waitUntil(m_condition, lock, deadline_ns);
        }
        enter(core::DeviceState::reconnecting, message);
        if (!m_faults.unplugged)
            break;
    }
    m_discontinuity = true;
    begin();
}

std::int64_t SimulatedCameraWorker::due_ns(double lag_s) const {
    const double since_s = static_cast<double>(m_sinceEpoch + 1) / m_description.nominalRate_Hz;
    return m_epoch_ns + toNs(since_s + (lag_s > 0.0 ? std::min(lag_s, kLongestLag_s) : 0.0));
}

bool SimulatedCameraWorker::happens(double share) {
    return static_cast<double>(m_random() >> 11) * 0x1.0p-53 < share;
}

void SimulatedCameraWorker::makeFrame(const SimulatedFaults& faults) {
    core::CameraFrame frame;
    if (m_generator->next(frame.image, m_stopSwitch.engaged()))
        m_discontinuity = true;
    ++m_sinceEpoch;
    frame.number = m_number++;
    if (happens(faults.dropShare)) {
        ++m_lost;
        publish();
        return;
    }
    if (happens(m_config.undecodableShare)) {
        ++m_lost;
        frame.image = {};
    }
    frame.time_ns = now_ns();
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
    m_status.since_ns = now_ns();
    m_status.message = std::move(message);
    if (state != core::DeviceState::live)
        m_rate.reset();
    publish();
}

void SimulatedCameraWorker::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_status.framesLost = m_lost + (m_frames.overflow() - m_overflowAtOpen);
    m_published.set(m_status);
    m_consumer->notify();
}

} // namespace teleta::simulated
