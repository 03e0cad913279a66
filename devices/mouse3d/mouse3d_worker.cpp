// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d_worker.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::mouse3d {

Mouse3dWorker::Mouse3dWorker(HidInputOpener opener, Mouse3dConfig config)
    : m_opener(std::move(opener))
    , m_config(std::move(config)) {
}

void Mouse3dWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_status = {};
    m_rate.reset();
    forget();
    setState(core::DeviceState::connecting);
}

void Mouse3dWorker::run(const std::stop_token& stop) {
    Lock lock(m_mutex);
    while (connect(lock, stop)) {
        lock.unlock();
        readReports(stop);
        lock.lock();
        m_input.reset();
        forget();
    }
    setState(core::DeviceState::closed);
}

void Mouse3dWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

SixAxes Mouse3dWorker::motion() const {
    const Mouse3dReading now = reading();
    return now.deadManHeld ? now.axes : SixAxes{};
}

Mouse3dReading Mouse3dWorker::reading() const {
    Mouse3dReading reading = m_reading.get();
    // The worker looks only after a read.
    if (isSilent(reading)) {
        reading.deadManHeld = false;
        reading.axes = {};
    }
    return reading;
}

/// While the dead-man button is held: nothing came for longer than such a mouse is silent.
bool Mouse3dWorker::isSilent(const Mouse3dReading& reading) const {
    if (!reading.deadManHeld)
        return false;
    const bool atRest = reading.axes == SixAxes{};
    const std::int64_t heard_ns = atRest ? reading.time_ns : reading.axesTime_ns;
    // The steady clock stands still while the machine sleeps.
    const std::int64_t silent_ns =
        now_ns() - heard_ns + m_config.clock->suspended_ns() - reading.suspended_ns;
    return silent_ns > (atRest ? m_config.restLifetime_ns : m_config.axesLifetime_ns);
}

/// A release may be among what did not come, and where the hand is nobody knows: the button has to be let go
/// and pressed anew.
void Mouse3dWorker::letGoIfSilent() {
    if (!isSilent(m_now))
        return;
    m_deadManSeenReleased = false;
    m_now.deadManHeld = false;
    m_now.axes = {};
    m_reading.set(m_now);
    publish();
}

/// Tries until there is a mouse, less and less often. False: stopped.
bool Mouse3dWorker::connect(Lock& lock, const std::stop_token& stop) {
    std::int64_t retry_ns = m_config.firstRetry_ns;
    while (!stop.stop_requested()) {
        if (m_status.state == core::DeviceState::lost) {
            const std::int64_t deadline_ns = now_ns() + retry_ns;
            retry_ns = std::min(2 * retry_ns, m_config.longestRetry_ns);
            while (!stop.stop_requested() && now_ns() < deadline_ns)
                m_config.clock->waitUntil(m_condition, lock, deadline_ns);
            if (stop.stop_requested())
                return false;
            setState(core::DeviceState::reconnecting, m_status.message);
        }
        lock.unlock();
        auto input = m_opener();
        lock.lock();
        if (input) {
            m_input = std::move(*input);
            m_name.set(m_input->name());
            // A mouse at rest is silent: it is live as soon as it is there.
            setState(core::DeviceState::live);
            return !stop.stop_requested();
        }
        setState(core::DeviceState::lost, input.error().message);
    }
    return false;
}

void Mouse3dWorker::readReports(const std::stop_token& stop) {
    std::array<std::uint8_t, 64> report{};
    while (!stop.stop_requested()) {
        const int size = m_input->read(report, m_config.readTimeout_ms);
        // Before a report that ends the silence counts.
        letGoIfSilent();
        if (size < 0) {
            setState(core::DeviceState::lost,
                     QCoreApplication::translate("Mouse3d", "The 3D mouse was unplugged.").toStdString());
            return;
        }
        if (size > 0)
            take(std::span(report).first(static_cast<std::size_t>(size)));
    }
}

void Mouse3dWorker::take(std::span<const std::uint8_t> report) {
    const std::int64_t time_ns = now_ns();
    switch (decodeReport(report, m_raw)) {
    case ReportKind::axes:
        m_now.axes = scaleAxes(m_raw, m_config.limits);
        m_now.axesTime_ns = time_ns;
        break;
    case ReportKind::buttons: {
        const bool held = ((m_raw.buttons >> static_cast<unsigned>(m_config.deadManButton)) & 1U) != 0;
        m_now.buttons = m_raw.buttons;
        // A button that was held when the mouse was connected shows with the first change of any other one.
        m_deadManSeenReleased = m_deadManSeenReleased || !held;
        m_now.deadManHeld = held && m_deadManSeenReleased;
        break;
    }
    case ReportKind::other:
        return;
    case ReportKind::damaged:
        ++m_status.framesLost;
        publish();
        return;
    }
    m_now.time_ns = time_ns;
    m_now.suspended_ns = m_config.clock->suspended_ns();
    m_reading.set(m_now);
    ++m_status.framesRead;
    m_status.lastData_ns = time_ns;
    m_rate.add(time_ns);
    publish();
}

/// Nothing of an earlier connection moves anything: the dead-man button must be pressed anew.
void Mouse3dWorker::forget() {
    m_raw = {};
    m_now = {};
    m_deadManSeenReleased = false;
    m_reading.set(m_now);
}

void Mouse3dWorker::setState(core::DeviceState state, std::string message) {
    if (m_status.state != state)
        m_status.since_ns = now_ns();
    m_status.state = state;
    m_status.message = std::move(message);
    publish();
}

void Mouse3dWorker::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(now_ns());
    m_published.set(m_status);
    m_consumer->notify();
}

} // namespace teleta::mouse3d
