// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/bracelet_link.h"

#include "backend/core/device/backoff.h"
#include "backend/core/device/device_state.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace teleta::core {

namespace {

/// Most reports read at a time, so that a board that sends endlessly does not block the worker.
constexpr int kReportsAtOnce = 256;
constexpr std::uint16_t kIdleTimeout_ms = 1000;

std::string lostMessage() {
    return QCoreApplication::translate("Bracelet", "The connection to the bracelet was lost.").toStdString();
}

} // namespace

BraceletLink::BraceletLink(OpenedBracelet opened, BraceletOpener opener, const StopSwitch& stopSwitch,
                           BraceletLinkConfig config)
    : m_description(std::move(opened.description))
    , m_opener(std::move(opener))
    , m_stopSwitch(stopSwitch)
    , m_config(std::move(config))
    , m_staleAfter_ns(staleAfter_ns(1e9 / static_cast<double>(m_config.idleWrite_ns)))
    , m_port(std::move(opened.port)) {
    m_description.highestDrive = std::min(m_description.highestDrive, kFullDrive);
    m_description.longestTimeout_ms = std::max<std::uint16_t>(m_description.longestTimeout_ms, 1);
}

void BraceletLink::open(Wakeup& consumer) {
    const std::scoped_lock lock(m_mutex);
    m_ledger = {};
    m_telemetryNow = {};
    publishTelemetry();
    m_status.open(consumer, now_ns());
}

void BraceletLink::run(const std::stop_token& stop) {
    Lock lock(m_mutex);
    if (m_port)
        adopt(std::move(m_port));
    while (!stop.stop_requested()) {
        if (!m_connected && !reconnect(lock, stop))
            break;
        writeZeroIfDue();
        readReports();
        if (!m_connected)
            continue;
        checkAge();
        const std::int64_t deadline_ns =
            std::min(now_ns() + m_config.poll_ns, m_lastWrite_ns + m_config.idleWrite_ns);
        m_config.clock->waitUntil(m_condition, lock, deadline_ns);
    }
    if (m_connected)
        (void)send({}, kIdleTimeout_ms);
    m_connected = false;
    m_publishedConnection.store(0, std::memory_order_release);
    m_port.reset();
    m_ledger.endConnection();
    setState(DeviceState::closed);
}

void BraceletLink::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

WriteResult BraceletLink::write(const BraceletFrame& frame) {
    const std::scoped_lock lock(m_mutex);
    if (!m_connected)
        return {WriteOutcome::lost, now_ns()};
    const bool off = isOff(frame.drive);
    if (!off && frame.connection != m_connections)
        return {WriteOutcome::refused, now_ns()};
    Drive drive{};
    if (!off && !m_stopSwitch.engaged())
        std::transform(frame.drive.begin(), frame.drive.end(), drive.begin(),
                       [this](std::uint16_t value) { return std::min(value, m_description.highestDrive); });
    if (!send(drive, frame.timeout_ms))
        return {WriteOutcome::lost, now_ns()};
    const std::int64_t written_ns = now_ns();
    // STOP may have been engaged during the write; zero the motors right away.
    if (!isOff(drive) && m_stopSwitch.engaged() && !send({}, kIdleTimeout_ms))
        return {WriteOutcome::lost, now_ns()};
    readReports();
    return {WriteOutcome::written, written_ns};
}

/// False: stop was requested.
bool BraceletLink::reconnect(Lock& lock, const std::stop_token& stop) {
    closePort(lock);
    Backoff retry(m_config.firstRetry_ns, m_config.longestRetry_ns);
    for (bool atOnce = m_status.state() == DeviceState::connecting;; atOnce = false) {
        const std::int64_t deadline_ns = now_ns() + (atOnce ? 0 : retry.next_ns());
        if (!m_config.clock->sleepUntil(m_condition, lock, deadline_ns, stop))
            return false;
        if (m_status.state() == DeviceState::lost)
            setState(DeviceState::reconnecting, m_status.current().message);
        // Opening may take a while; meanwhile write() reports that there is no connection.
        lock.unlock();
        Expected<OpenedBracelet> opened = m_opener();
        lock.lock();
        if (opened && opened->description.serial == m_description.serial) {
            adopt(std::move(opened->port));
            if (m_connected)
                return true;
            // Some boards accept a single connection: close this one before the next attempt.
            closePort(lock);
        } else if (m_status.state() == DeviceState::connecting) {
            setState(DeviceState::reconnecting, opened ? lostMessage() : opened.error().message);
        }
    }
}

/// A device that hangs may take seconds to close: nobody else waits for it.
void BraceletLink::closePort(Lock& lock) {
    std::unique_ptr<BraceletPort> closing = std::move(m_port);
    lock.unlock();
    closing.reset();
    lock.lock();
}

void BraceletLink::adopt(std::unique_ptr<BraceletPort> port) {
    m_port = std::move(port);
    m_connected = true;
    setState(DeviceState::connecting);
    // Before anybody else can write: stops motors that kept turning.
    if (send({}, kIdleTimeout_ms))
        m_publishedConnection.store(++m_connections, std::memory_order_release);
}

void BraceletLink::lose() {
    m_connected = false;
    m_publishedConnection.store(0, std::memory_order_release);
    m_ledger.endConnection();
    const std::string why = m_port->failure();
    setState(DeviceState::lost, why.empty() ? lostMessage() : why);
    // The worker closes the port and looks for the bracelet again.
    m_condition.notify_all();
}

bool BraceletLink::send(const Drive& drive, std::uint16_t timeout_ms) {
    const bool taken = m_port->write(
        m_ledger.send(), drive, std::clamp<std::uint16_t>(timeout_ms, 1, m_description.longestTimeout_ms));
    m_lastWrite_ns = now_ns();
    if (!taken) {
        lose();
        return false;
    }
    m_telemetryNow.written = drive;
    ++m_telemetryNow.framesWritten;
    publish();
    return true;
}

void BraceletLink::writeZeroIfDue() {
    const bool driven = !isOff(m_telemetryNow.written);
    const bool silent = now_ns() - m_lastWrite_ns >= m_config.idleWrite_ns;
    if (!silent && !(driven && m_stopSwitch.engaged()))
        return;
    if (driven && silent)
        ++m_telemetryNow.zeroedByDevice;
    (void)send({}, kIdleTimeout_ms);
}

void BraceletLink::readReports() {
    BoardReport report;
    bool any = false;
    for (int i = 0; m_connected && i < kReportsAtOnce; ++i) {
        switch (m_port->read(report)) {
        case BraceletPort::Read::nothing:
            i = kReportsAtOnce;
            break;
        case BraceletPort::Read::damaged:
            ++m_telemetryNow.damagedReports;
            any = true;
            break;
        case BraceletPort::Read::lost:
            lose();
            break;
        case BraceletPort::Read::report:
            // The answer to a frame that the board did not understand confirms nothing.
            if (report.frameRefused)
                m_ledger.refuse(report.sequence);
            else
                m_ledger.echo(report.sequence);
            m_telemetryNow.board = report;
            m_telemetryNow.reported_ns = now_ns();
            m_status.receive(DeviceState::live, m_telemetryNow.reported_ns);
            any = true;
            break;
        }
    }
    if (any) {
        publish();
        m_status.wakeConsumer();
    }
}

void BraceletLink::checkAge() {
    if (m_status.state() == DeviceState::live && now_ns() - m_status.current().lastData_ns > m_staleAfter_ns)
        setState(DeviceState::stale);
}

void BraceletLink::setState(DeviceState state, std::string message) {
    publishTelemetry();
    m_status.setState(state, now_ns(), std::move(message));
}

void BraceletLink::publish() {
    publishTelemetry();
    m_status.publish();
}

void BraceletLink::publishTelemetry() {
    m_telemetryNow.framesEchoed = m_ledger.echoed();
    m_telemetryNow.newestSent = m_ledger.sent();
    m_telemetryNow.newestEchoed = m_ledger.newestEchoed();
    m_telemetryNow.framesLost = m_ledger.lost();
    m_telemetryNow.framesRefused = m_ledger.refused();
    m_telemetryNow.strayEchoes = m_ledger.stray();
    m_telemetry.set(m_telemetryNow);
    m_status.setLost(m_ledger.lost());
}

} // namespace teleta::core
