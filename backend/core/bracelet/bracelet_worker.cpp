// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/bracelet_worker.h"

#include "backend/core/device/device_state.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace teleta::core {

namespace {

/// Reports of one look; a board that sends without end does not keep the worker.
constexpr int kReportsAtOnce = 256;
constexpr std::uint16_t kIdleTimeout_ms = 1000;

std::string lostMessage() {
    return QCoreApplication::translate("Bracelet", "The connection to the bracelet was lost.").toStdString();
}

} // namespace

BraceletWorker::BraceletWorker(OpenedBracelet opened, BraceletOpener opener, const StopSwitch& stopSwitch,
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

void BraceletWorker::open(Wakeup& consumer) {
    const std::scoped_lock lock(m_mutex);
    m_consumer = &consumer;
    m_ledger = {};
    m_rate.reset();
    m_statusNow = {};
    m_telemetryNow = {};
    setState(DeviceState::connecting);
}

void BraceletWorker::run(const std::stop_token& stop) {
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

void BraceletWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

WriteResult BraceletWorker::write(const BraceletFrame& frame) {
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
    // STOP came while the device took its time: nobody else has to notice first.
    if (!isOff(drive) && m_stopSwitch.engaged() && !send({}, kIdleTimeout_ms))
        return {WriteOutcome::lost, now_ns()};
    readReports();
    return {WriteOutcome::written, written_ns};
}

/// False when the worker shall end instead.
bool BraceletWorker::reconnect(Lock& lock, const std::stop_token& stop) {
    m_port.reset();
    const bool first = m_statusNow.state == DeviceState::connecting;
    std::int64_t retry_ns = first ? 0 : m_config.firstRetry_ns;
    for (;;) {
        const std::int64_t deadline_ns = now_ns() + retry_ns;
        while (now_ns() < deadline_ns) {
            if (stop.stop_requested())
                return false;
            m_config.clock->waitUntil(m_condition, lock, deadline_ns);
        }
        if (stop.stop_requested())
            return false;
        if (m_statusNow.state == DeviceState::lost)
            setState(DeviceState::reconnecting, m_statusNow.message);
        // Looking for a device takes its time; write() tells meanwhile that there is none.
        lock.unlock();
        Expected<OpenedBracelet> opened = m_opener();
        lock.lock();
        if (opened && opened->description.serial == m_description.serial) {
            adopt(std::move(opened->port));
            if (m_connected)
                return true;
            // A board may bear one connection only: an open one would keep the next one out.
            m_port.reset();
        } else if (m_statusNow.state == DeviceState::connecting) {
            setState(DeviceState::reconnecting, opened ? lostMessage() : opened.error().message);
        }
        retry_ns = std::clamp(2 * retry_ns, m_config.firstRetry_ns, m_config.longestRetry_ns);
    }
}

void BraceletWorker::adopt(std::unique_ptr<BraceletPort> port) {
    m_port = std::move(port);
    m_connected = true;
    setState(DeviceState::connecting);
    // Before anybody can write: motors that went on turning do not any more.
    if (send({}, kIdleTimeout_ms))
        m_publishedConnection.store(++m_connections, std::memory_order_release);
}

void BraceletWorker::lose() {
    m_connected = false;
    m_publishedConnection.store(0, std::memory_order_release);
    m_ledger.endConnection();
    const std::string why = m_port->failure();
    setState(DeviceState::lost, why.empty() ? lostMessage() : why);
    // The worker closes the port and looks for the bracelet again.
    m_condition.notify_all();
}

bool BraceletWorker::send(const Drive& drive, std::uint16_t timeout_ms) {
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

void BraceletWorker::writeZeroIfDue() {
    const bool driven = !isOff(m_telemetryNow.written);
    const bool silent = now_ns() - m_lastWrite_ns >= m_config.idleWrite_ns;
    if (!silent && !(driven && m_stopSwitch.engaged()))
        return;
    if (driven && silent)
        ++m_telemetryNow.zeroedByDevice;
    (void)send({}, kIdleTimeout_ms);
}

void BraceletWorker::readReports() {
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
            // A frame that was not understood is not felt: the board's answer to it confirms nothing.
            if (report.frameRefused)
                m_ledger.refuse(report.sequence);
            else
                m_ledger.echo(report.sequence);
            m_telemetryNow.board = report;
            m_telemetryNow.reported_ns = now_ns();
            m_rate.add(m_telemetryNow.reported_ns);
            ++m_statusNow.framesRead;
            m_statusNow.lastData_ns = m_telemetryNow.reported_ns;
            any = true;
            if (m_statusNow.state != DeviceState::live)
                setState(DeviceState::live);
            break;
        }
    }
    if (any) {
        publish();
        m_consumer->notify();
    }
}

void BraceletWorker::checkAge() {
    if (m_statusNow.state == DeviceState::live && now_ns() - m_statusNow.lastData_ns > m_staleAfter_ns)
        setState(DeviceState::stale);
}

void BraceletWorker::setState(DeviceState state, std::string message) {
    m_statusNow.state = state;
    m_statusNow.since_ns = now_ns();
    m_statusNow.message = std::move(message);
    if (state != DeviceState::live)
        m_rate.reset();
    publish();
    m_consumer->notify();
}

void BraceletWorker::publish() {
    m_telemetryNow.framesEchoed = m_ledger.echoed();
    m_telemetryNow.newestSent = m_ledger.sent();
    m_telemetryNow.newestEchoed = m_ledger.newestEchoed();
    m_telemetryNow.framesLost = m_ledger.lost();
    m_telemetryNow.framesRefused = m_ledger.refused();
    m_telemetryNow.strayEchoes = m_ledger.stray();
    m_telemetry.set(m_telemetryNow);
    m_statusNow.rate_Hz = m_rate.rate_Hz(m_statusNow.lastData_ns);
    m_statusNow.framesLost = m_ledger.lost();
    m_status.set(m_statusNow);
}

} // namespace teleta::core
