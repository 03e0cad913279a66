// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/taxels_device.h"

#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "devices/taxels/taxels_link.h"
#include "devices/taxels/taxels_text.h"

#include <QString>

#include <algorithm>
#include <utility>

namespace teleta::taxels {

namespace {

using core::DeviceState;
using link::ByteLink;
using Rest = FrameDecoder::Rest;

constexpr std::int64_t kNoRoom_ns = 2 * kMs_ns; ///< until a full queue is looked at again
constexpr double kPeriodsUntilLost = 5.0;
constexpr std::size_t kQueueBlocks = 1024;       ///< of datagrams, each is one block
constexpr std::size_t kQueueTemperatures = 4096; ///< 10 s at 400 frames/s

FrameDecoder::Counters sum(FrameDecoder::Counters a, const FrameDecoder::Counters& b) {
    a.frames += b.frames;
    a.frameBytes += b.frameBytes;
    a.otherFrames += b.otherFrames;
    a.droppedBytes += b.droppedBytes;
    a.badChecksums += b.badChecksums;
    a.badSizes += b.badSizes;
    a.badEnds += b.badEnds;
    a.badValues += b.badValues;
    return a;
}

/// Why a sensor is lost of which no good frame came for so long.
std::string lostReason(const FrameDecoder::Problem& problem, std::int64_t after_ns) {
    using Kind = FrameDecoder::Problem::Kind;
    const double after_s = static_cast<double>(after_ns) * 1e-9;
    const QString found = QString::fromStdString(problem.found).left(40);
    const QString expected = QString::fromStdString(problem.expected).left(40);
    switch (problem.kind) {
    case Kind::noValues:
        return TaxelsText::tr("The sensor has told no values for %1 s: it has none, or they are switched "
                              "off.")
            .arg(after_s)
            .toStdString();
    case Kind::model:
        return TaxelsText::tr("The sensor is another model: %1 instead of %2.")
            .arg(found, expected)
            .toStdString();
    case Kind::taxels:
        return TaxelsText::tr("The sensor has %1 taxels instead of %2.").arg(found, expected).toStdString();
    case Kind::none:
    case Kind::other:
        break;
    }
    return TaxelsText::tr("The sensor has sent no usable frame for %1 s.").arg(after_s).toStdString();
}

std::int64_t lostAfter_ns(const TaxelsTimes& times, double rate_Hz) {
    const std::int64_t configured_ns = times.noFrames_ms * kMs_ns;
    if (!(rate_Hz > 0.0))
        return configured_ns;
    return std::max(configured_ns, static_cast<std::int64_t>(kPeriodsUntilLost * 1e9 / rate_Hz));
}

} // namespace

core::Expected<std::unique_ptr<TaxelsDevice>> TaxelsDevice::open(TaxelsFile file) {
    TELETA_TRY(auto link, openLink(file, nullptr));
    auto device = std::unique_ptr<TaxelsDevice>(new TaxelsDevice(std::move(file), link.isFile()));
    // The worker connects again by itself where this thread's link is of no use to it.
    if (!link.staysInThread())
        device->adopt(std::move(link));
    return device;
}

TaxelsDevice::TaxelsDevice(TaxelsFile file, bool isFile)
    : m_file(std::move(file))
    , m_description{.name = m_file.name,
                    .layout = m_file.grid.layout(),
                    .unit = m_file.grid.unit(),
                    .nominalRate_Hz = m_file.rate_Hz,
                    .recorded = isFile}
    , m_staleAfter_ns(m_file.times.stale_ms > 0 ? m_file.times.stale_ms * kMs_ns
                                                : core::staleAfter_ns(m_file.rate_Hz))
    , m_lostAfter_ns(lostAfter_ns(m_file.times, m_file.rate_Hz))
    , m_outlet(kQueueBlocks)
    , m_temperatures(kQueueTemperatures)
    , m_time(m_file.format)
    , m_values(m_file.grid.layout().values())
    , m_read(ByteLink::kLongestDatagram)
    , m_retry(m_file.times.firstRetry_ms * kMs_ns, m_file.times.longestRetry_ms * kMs_ns) {
}

void TaxelsDevice::open(core::Wakeup& consumer) {
    m_wake.clear();
    m_begin_ns = core::steadyNow_ns();
    m_due_ns = m_begin_ns;
    m_time = StreamTime(m_file.format);
    m_counters = {};
    m_closedLines = {};
    m_closedBinary = 0;
    m_retry.reset();
    m_ended = false;
    publish();
    m_outlet.open(consumer, m_begin_ns);
}

void TaxelsDevice::adopt(ByteLink link) {
    // What a sensor was holds beyond its connection: layout, tare and calibration are its own.
    const std::string model = m_decoder ? m_decoder->model() : std::string();
    m_decoder = makeDecoder(m_file.format, link);
    if (!model.empty())
        m_decoder->expectModel(model);
    m_link = std::make_unique<ByteLink>(std::move(link));
}

void TaxelsDevice::run(const std::stop_token& stop) {
    if (m_link)
        ++m_counters.connections; // made by opening the device
    while (!stop.stop_requested() && !m_ended) {
        const core::Expected<void> begun = connect();
        std::string reason = begun ? stream(stop) : begun.error().message;
        if (m_link && stop.stop_requested())
            m_link->tell(m_file.goodbye, nullptr);
        closeLink();
        if (!stop.stop_requested() && !m_ended)
            reconnect(std::move(reason), stop);
    }
    m_outlet.setState(stop.stop_requested() ? DeviceState::closed : DeviceState::finished,
                      core::steadyNow_ns());
    m_discontinuity = true;
}

/// Nothing to do after opening the device and after reconnect(), which leave a link.
core::Expected<void> TaxelsDevice::connect() {
    if (m_link)
        return {};
    TELETA_TRY(auto link, openLink(m_file, &m_wake));
    adopt(std::move(link));
    ++m_counters.connections;
    publish();
    return {};
}

std::string TaxelsDevice::stream(const std::stop_token& stop) {
    m_outlet.setState(DeviceState::connecting, core::steadyNow_ns());
    m_time.beginConnection();
    m_lastFrame_ns = core::steadyNow_ns();
    m_read_ns = m_lastFrame_ns;
    while (!stop.stop_requested()) {
        const std::int64_t now_ns = core::steadyNow_ns();
        if (now_ns >= lostAt_ns())
            return lostReason(m_decoder->problem(), lostAt_ns() - m_lastFrame_ns);
        std::size_t count = 0;
        switch (m_link->read(m_read, count, deadline_ns(now_ns), &m_wake)) {
        case ByteLink::Outcome::done:
            m_read_ns = core::steadyNow_ns();
            m_decoder->feed(std::span(m_read).first(count));
            deliverFrames(Rest::mayCome, stop);
            break;
        case ByteLink::Outcome::timedOut:
            if (core::steadyNow_ns() >= m_read_ns + m_file.times.lineSilence_ms * kMs_ns)
                deliverFrames(Rest::willNotCome, stop);
            break;
        case ByteLink::Outcome::woken:
            break;
        case ByteLink::Outcome::gone:
            deliverFrames(restOf(*m_link), stop);
            m_ended = m_link->ended();
            return m_link->goneReason();
        }
    }
    return {};
}

std::int64_t TaxelsDevice::lostAt_ns() const {
    const bool isUnusable = m_decoder->problem().kind != FrameDecoder::Problem::Kind::none;
    return m_lastFrame_ns + (isUnusable && m_file.times.unusable_ms > 0
                                 ? std::min(m_lostAfter_ns, m_file.times.unusable_ms * kMs_ns)
                                 : m_lostAfter_ns);
}

std::int64_t TaxelsDevice::deadline_ns(std::int64_t now_ns) {
    std::int64_t deadline_ns = lostAt_ns();
    if (m_outlet.state() == DeviceState::live) {
        const std::int64_t stale_ns = m_lastFrame_ns + m_staleAfter_ns;
        if (now_ns >= stale_ns)
            m_outlet.setState(DeviceState::stale, now_ns);
        else
            deadline_ns = std::min(deadline_ns, stale_ns);
    }
    if (m_decoder->pendingBytes() > 0)
        deadline_ns = std::min(deadline_ns, m_read_ns + m_file.times.lineSilence_ms * kMs_ns);
    return deadline_ns;
}

/// Frames that came with one read are one block; a loss between them begins a new one.
void TaxelsDevice::deliverFrames(Rest rest, const std::stop_token& stop) {
    core::SampleBlock block;
    DecodedFrame frame;
    while (m_decoder->next(frame, rest)) {
        appendFrame(frame, block);
        if (m_link->isFile())
            deliverPaced(block, stop);
        if (stop.stop_requested())
            return;
    }
    publish();
    deliver(block);
}

void TaxelsDevice::deliverPaced(core::SampleBlock& block, const std::stop_token& stop) {
    if (block.frames() == 0)
        return;
    if (m_file.rate_Hz > 0.0) {
        m_wake.waitUntil(m_due_ns);
        m_due_ns += static_cast<std::int64_t>(1e9 / m_file.rate_Hz);
    }
    prepare(block);
    m_lastFrame_ns = core::steadyNow_ns();
    block.time_ns.back() = m_lastFrame_ns;
    while (!stop.stop_requested() && !m_outlet.tryDeliver(block, DeviceState::live))
        m_wake.waitUntil(core::steadyNow_ns() + kNoRoom_ns);
    block = {};
    m_lastFrame_ns = core::steadyNow_ns();
}

void TaxelsDevice::appendFrame(const DecodedFrame& frame, core::SampleBlock& block) {
    // A file is read in large pieces, so that its frames differ only in when they are due.
    const std::int64_t time_ns = m_link->isFile() && m_file.rate_Hz > 0.0 ? m_due_ns : m_read_ns;
    const StreamTime::Step step = m_time.advance(frame, static_cast<double>(time_ns - m_begin_ns) * 1e-9);
    if (step.repeated) {
        ++m_counters.repeatedFrames;
        return; // a frozen sensor becomes stale and is lost
    }
    m_lastFrame_ns = m_read_ns;
    m_retry.reset();
    if (step.lost > 0 || step.restarted)
        deliver(block);
    if (step.lost > 0)
        m_outlet.lose(step.lost);
    if (step.restarted) {
        ++m_counters.sensorRestarts;
        m_discontinuity = true;
    }
    m_file.grid.place(frame.values, m_values);
    block.time_ns.push_back(m_read_ns);
    block.sourceTime_s.push_back(step.time_s);
    block.values.insert(block.values.end(), m_values.begin(), m_values.end());
    if (m_file.temperatures == 0)
        return;
    // The frame after an outage is the first of its block.
    const bool isAfterOutage = m_discontinuity && block.frames() == 1;
    m_temperatureDropped = !m_temperatures.push(
        {.time_ns = m_read_ns,
         .sourceTime_s = step.time_s,
         .values_degC = {frame.values.end() - static_cast<std::ptrdiff_t>(m_file.temperatures),
                         frame.values.end()},
         .discontinuity = isAfterOutage || m_temperatureDropped});
}

void TaxelsDevice::prepare(core::SampleBlock& block) {
    block.channels = m_values.size();
    block.discontinuity = std::exchange(m_discontinuity, false);
}

void TaxelsDevice::deliver(core::SampleBlock& block) {
    if (block.frames() == 0)
        return;
    prepare(block);
    m_outlet.deliver(std::exchange(block, {}), DeviceState::live);
}

void TaxelsDevice::reconnect(std::string reason, const std::stop_token& stop) {
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

void TaxelsDevice::closeLink() {
    if (m_link) {
        m_closedLines = sum(m_closedLines, m_decoder->counters());
        m_closedBinary += m_link->leftOut();
    }
    m_link.reset();
    publish();
}

void TaxelsDevice::publish() {
    m_counters.line = m_link ? sum(m_closedLines, m_decoder->counters()) : m_closedLines;
    m_counters.binaryMessages = m_closedBinary + (m_link ? m_link->leftOut() : 0);
    m_published.set(m_counters);
}

} // namespace teleta::taxels
