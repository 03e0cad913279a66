// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d.h"

#include "backend/core/device/backoff.h"

#include <QCoreApplication>

#include <array>
#include <utility>

namespace teleta::mouse3d {

Mouse3d::Mouse3d(Mouse3dConfig config, HidInputOpener opener)
    : m_opener(std::move(opener))
    , m_config(std::move(config))
    , m_wait(m_config.clock) {
}

void Mouse3d::open(core::Wakeup& consumer) {
    forget();
    m_status.open(consumer, now_ns());
}

void Mouse3d::run(const std::stop_token& stop) {
    while (connect(stop)) {
        readReports(stop);
        m_input.reset();
        forget();
    }
    m_status.setState(core::DeviceState::closed, now_ns());
}

SixAxes Mouse3d::motion() const {
    const Mouse3dReading now = reading();
    return now.deadManHeld ? now.axes : SixAxes{};
}

Mouse3dReading Mouse3d::reading() const {
    Mouse3dReading reading = m_reading.get();
    // The worker looks only after a read.
    if (isSilent(reading)) {
        reading.deadManHeld = false;
        reading.axes = {};
    }
    return reading;
}

/// While the dead-man button is held: nothing came for longer than such a mouse is silent.
bool Mouse3d::isSilent(const Mouse3dReading& reading) const {
    if (!reading.deadManHeld)
        return false;
    const bool atRest = reading.axes == SixAxes{};
    const std::int64_t heard_ns = atRest ? reading.time_ns : reading.axesTime_ns;
    // The steady clock stands still while the machine sleeps.
    const std::int64_t silent_ns =
        now_ns() - heard_ns + m_config.clock->suspended_ns() - reading.suspended_ns;
    return silent_ns > (atRest ? m_config.restLifetime_ns : m_config.axesLifetime_ns);
}

/// The release of the button may be among the missing reports: it has to be released and pressed again.
void Mouse3d::letGoIfSilent() {
    if (!isSilent(m_now))
        return;
    m_deadManSeenReleased = false;
    m_now.deadManHeld = false;
    m_now.axes = {};
    m_reading.set(m_now);
    m_status.publishAndWake();
}

/// Tries until there is a mouse, less and less often. False: stopped.
bool Mouse3d::connect(const std::stop_token& stop) {
    core::Backoff retry(m_config.firstRetry_ns, m_config.longestRetry_ns);
    while (!stop.stop_requested()) {
        if (m_status.state() == core::DeviceState::lost) {
            if (!m_wait.until(now_ns() + retry.next_ns(), stop))
                return false;
            m_status.setState(core::DeviceState::reconnecting, now_ns(), m_status.current().message);
        }
        auto input = m_opener();
        if (input) {
            m_input = std::move(*input);
            m_name.set(m_input->name());
            // A mouse at rest is silent, so it is live as soon as it is connected.
            m_status.setState(core::DeviceState::live, now_ns());
            return !stop.stop_requested();
        }
        m_status.setState(core::DeviceState::lost, now_ns(), input.error().message);
    }
    return false;
}

void Mouse3d::readReports(const std::stop_token& stop) {
    std::array<std::uint8_t, 64> report{};
    while (!stop.stop_requested()) {
        const int size = m_input->read(report, m_config.readTimeout_ms);
        // First: a report that ends the silence must not revive the old state.
        letGoIfSilent();
        if (size < 0) {
            m_status.setState(
                core::DeviceState::lost, now_ns(),
                QCoreApplication::translate("Mouse3d", "The 3D mouse was unplugged.").toStdString());
            return;
        }
        if (size > 0)
            take(std::span(report).first(static_cast<std::size_t>(size)));
    }
}

void Mouse3d::take(std::span<const std::uint8_t> report) {
    const std::int64_t time_ns = now_ns();
    switch (decodeReport(report, m_raw)) {
    case ReportKind::axes:
        m_now.axes = scaleAxes(m_raw, m_config.limits);
        m_now.axesTime_ns = time_ns;
        break;
    case ReportKind::buttons: {
        const bool held = ((m_raw.buttons >> static_cast<unsigned>(m_config.deadManButton)) & 1U) != 0;
        m_now.buttons = m_raw.buttons;
        // If the button was held while the mouse was connected, the first change of any button shows it.
        m_deadManSeenReleased = m_deadManSeenReleased || !held;
        m_now.deadManHeld = held && m_deadManSeenReleased;
        break;
    }
    case ReportKind::other:
        return;
    case ReportKind::damaged:
        m_status.lose(1);
        m_status.publishAndWake();
        return;
    }
    m_now.time_ns = time_ns;
    m_now.suspended_ns = m_config.clock->suspended_ns();
    m_reading.set(m_now);
    m_status.receive(core::DeviceState::live, time_ns);
    m_status.publishAndWake();
}

/// Nothing carries over from an earlier connection: the dead-man button must be pressed again.
void Mouse3d::forget() {
    m_raw = {};
    m_now = {};
    m_deadManSeenReleased = false;
    m_reading.set(m_now);
}

} // namespace teleta::mouse3d
