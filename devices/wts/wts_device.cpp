// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_device.h"

#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/wts/wts_text.h"

#include <QString>

#include <algorithm>
#include <utility>

namespace teleta::wts {

namespace {

using core::DeviceState;
using Rest = MessageDecoder::Rest;

constexpr double kPeriodsUntilLost = 5.0;
constexpr double kBitsPerByte = 10.0; // with start and stop bit

MessageDecoder::Counters sum(MessageDecoder::Counters a, const MessageDecoder::Counters& b) {
    a.messages += b.messages;
    a.messageBytes += b.messageBytes;
    a.droppedBytes += b.droppedBytes;
    a.badChecksums += b.badChecksums;
    a.badSizes += b.badSizes;
    return a;
}

std::int64_t lostAfter_ns(const WtsConfig& config, double nominalRate_Hz) {
    const std::int64_t configured_ns = config.times.noFrames_ms * kMs_ns;
    if (!(nominalRate_Hz > 0.0))
        return configured_ns;
    return std::max(configured_ns, static_cast<std::int64_t>(kPeriodsUntilLost * 1e9 / nominalRate_Hz));
}

/// Highest frame rate that the delay and the serial line allow; 0 (unknown) when neither limits it. The
/// sensor may be slower.
double nominalRate_Hz(const WtsConfig& config, const MatrixInfo& matrix) {
    double period_s = config.delay_ms * 1e-3;
    if (const auto* serial = std::get_if<SerialAddress>(&config.address)) {
        const auto bytes =
            static_cast<double>(kHeaderBytes + kFrameHeaderBytes + 2 * matrix.cells() + kChecksumBytes);
        period_s = std::max(period_s, bytes * kBitsPerByte / serial->baud);
    }
    return period_s > 0.0 ? 1.0 / period_s : 0.0;
}

} // namespace

core::Expected<std::unique_ptr<WtsDevice>> WtsDevice::open(WtsConfig config) {
    TELETA_TRY(auto session, WtsSession::open(config, nullptr));
    const MatrixInfo& matrix = session.matrix();
    core::SourceDescription description{.name = link::displayName(config.address),
                                        .layout = core::ArrayLayout{matrix.rows, matrix.columns,
                                                                    matrix.cellWidth_10um / 1e5,
                                                                    matrix.cellHeight_10um / 1e5},
                                        .unit = "counts",
                                        .nominalRate_Hz = nominalRate_Hz(config, matrix)};
    return std::unique_ptr<WtsDevice>(
        new WtsDevice(std::move(session), std::move(description), std::move(config)));
}

WtsDevice::WtsDevice(WtsSession session, core::SourceDescription description, WtsConfig config)
    : m_description(std::move(description))
    , m_config(std::move(config))
    , m_matrix(session.matrix())
    , m_staleAfter_ns(m_config.times.stale_ms > 0 ? m_config.times.stale_ms * kMs_ns
                                                  : core::staleAfter_ns(m_description.nominalRate_Hz))
    , m_lostAfter_ns(lostAfter_ns(m_config, m_description.nominalRate_Hz))
    , m_outlet(m_config.queueBlocks)
    , m_session(std::make_unique<WtsSession>(std::move(session)))
    , m_clock(m_config.timestampUnit_s)
    , m_values(m_matrix.cells())
    , m_retry(m_config.times.firstRetry_ms * kMs_ns, m_config.times.longestRetry_ms * kMs_ns) {
}

void WtsDevice::open(core::Wakeup& consumer) {
    m_wake.clear();
    m_begin_ns = core::steadyNow_ns();
    m_clock = link::FrameClock(m_config.timestampUnit_s);
    m_counters = {};
    m_closedLines = {};
    m_tarePending = m_config.tare;
    m_retry.reset();
    publish();
    m_outlet.open(consumer, m_begin_ns);
}

void WtsDevice::run(const std::stop_token& stop) {
    if (m_session)
        ++m_counters.connections; // made by opening the device
    while (!stop.stop_requested()) {
        core::Expected<void> begun = connect();
        if (begun)
            begun = beginFrames();
        std::string reason = begun ? stream(stop) : begun.error().message;
        if (m_session && stop.stop_requested())
            m_session->stopFrames();
        closeSession();
        if (!stop.stop_requested())
            reconnect(std::move(reason), stop);
    }
    m_outlet.setState(DeviceState::closed, core::steadyNow_ns());
    m_discontinuity = true;
}

/// Nothing to do after opening the device and after reconnect(), which leave a session.
core::Expected<void> WtsDevice::connect() {
    if (m_session)
        return {};
    TELETA_TRY(auto session, WtsSession::open(m_config, &m_wake));
    const MatrixInfo& found = session.matrix();
    if (found.rows != m_matrix.rows || found.columns != m_matrix.columns ||
        found.cellWidth_10um != m_matrix.cellWidth_10um || found.cellHeight_10um != m_matrix.cellHeight_10um)
        return core::failed(
            core::ErrorKind::refused,
            WtsText::tr(
                "Another array is connected: %1 x %2 cells of %3 mm instead of %4 x %5 cells of %6 mm.")
                .arg(found.rows)
                .arg(found.columns)
                .arg(found.cellWidth_10um / 100.0)
                .arg(m_matrix.rows)
                .arg(m_matrix.columns)
                .arg(m_matrix.cellWidth_10um / 100.0));
    m_session = std::make_unique<WtsSession>(std::move(session));
    ++m_counters.connections;
    return {};
}

core::Expected<void> WtsDevice::beginFrames() {
    m_outlet.setState(DeviceState::connecting, core::steadyNow_ns());
    if (m_tarePending) {
        TELETA_CHECK(m_session->tare(&m_wake));
        m_tarePending = false;
    }
    return m_session->startFrames(&m_wake);
}

std::string WtsDevice::stream(const std::stop_token& stop) {
    m_clock.restart();
    m_lastFrame_ns = core::steadyNow_ns();
    deliverFrames(Rest::mayCome); // what came with the answer
    while (!stop.stop_requested()) {
        const std::int64_t now_ns = core::steadyNow_ns();
        const std::int64_t lost_ns = m_lastFrame_ns + m_lostAfter_ns;
        if (now_ns >= lost_ns)
            return WtsText::tr("The sensor has sent no usable frame for %1 s.")
                .arg(static_cast<double>(m_lostAfter_ns) * 1e-9)
                .toStdString();
        std::int64_t deadline_ns = lost_ns;
        if (m_outlet.state() == DeviceState::live) {
            const std::int64_t stale_ns = m_lastFrame_ns + m_staleAfter_ns;
            if (now_ns >= stale_ns)
                m_outlet.setState(DeviceState::stale, now_ns);
            else
                deadline_ns = std::min(deadline_ns, stale_ns);
        }
        if (m_session->decoder().pendingBytes() > 0)
            deadline_ns =
                std::min(deadline_ns, m_session->readTime_ns() + m_config.times.lineSilence_ms * kMs_ns);
        switch (m_session->receive(deadline_ns, &m_wake)) {
        case link::ByteLink::Outcome::done:
            deliverFrames(Rest::mayCome);
            break;
        case link::ByteLink::Outcome::timedOut:
            if (core::steadyNow_ns() >= m_session->readTime_ns() + m_config.times.lineSilence_ms * kMs_ns)
                deliverFrames(Rest::willNotCome);
            break;
        case link::ByteLink::Outcome::woken:
            break;
        case link::ByteLink::Outcome::gone:
            deliverFrames(Rest::willNotCome);
            return m_session->goneReason();
        }
    }
    return {};
}

/// Frames that came with one read are one block; a loss between them begins a new one.
void WtsDevice::deliverFrames(Rest rest) {
    core::SampleBlock block;
    Message message;
    while (m_session->decoder().next(message, rest)) {
        if (message.id == static_cast<std::uint8_t>(Command::periodicFrame))
            appendFrame(message, block);
        else
            ++m_counters.otherMessages;
    }
    publish();
    deliver(block);
}

void WtsDevice::appendFrame(const Message& message, core::SampleBlock& block) {
    const auto timestamp = readFrame(message.payload, m_values);
    if (!timestamp) {
        ++m_counters.faultyFrames;
        return;
    }
    const std::int64_t time_ns = m_session->readTime_ns();
    const link::FrameClock::Step step =
        m_clock.advance(*timestamp, static_cast<double>(time_ns - m_begin_ns) * 1e-9);
    if (step.lost > 0 || step.restarted) {
        deliver(block);
        if (step.lost > 0)
            m_outlet.lose(step.lost);
    }
    if (step.restarted) {
        ++m_counters.sensorRestarts;
        m_discontinuity = true;
    }
    m_lastFrame_ns = time_ns;
    m_retry.reset();
    block.time_ns.push_back(time_ns);
    block.sourceTime_s.push_back(step.time_s);
    block.values.insert(block.values.end(), m_values.begin(), m_values.end());
}

void WtsDevice::deliver(core::SampleBlock& block) {
    if (block.frames() == 0)
        return;
    block.channels = m_values.size();
    block.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::exchange(block, {}), DeviceState::live);
}

void WtsDevice::reconnect(std::string reason, const std::stop_token& stop) {
    m_discontinuity = true;
    m_outlet.setState(DeviceState::lost, core::steadyNow_ns(), reason);
    while (!stop.stop_requested()) {
        m_wake.waitUntil(core::steadyNow_ns() + m_retry.next_ns());
        if (stop.stop_requested())
            return;
        m_outlet.setState(DeviceState::reconnecting, core::steadyNow_ns(), reason);
        const core::Expected<void> connected = connect();
        if (connected)
            return;
        ++m_counters.failedAttempts;
        publish();
        reason = connected.error().message;
    }
}

void WtsDevice::closeSession() {
    if (m_session)
        m_closedLines = sum(m_closedLines, m_session->decoder().counters());
    m_session.reset();
    publish();
}

void WtsDevice::publish() {
    m_counters.line = m_session ? sum(m_closedLines, m_session->decoder().counters()) : m_closedLines;
    m_published.set(m_counters);
}

} // namespace teleta::wts
