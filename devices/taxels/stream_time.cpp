// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/stream_time.h"

#include <algorithm>

namespace teleta::taxels {

namespace {

int bitsOf(NumberType type) {
    return static_cast<int>(8 * sizeOf(type));
}

std::uint32_t maskOf(NumberType type) {
    return 0xFFFF'FFFFU >> (32 - bitsOf(type));
}

link::FrameClock clockOf(const FrameFormat& format) {
    const auto* binary = std::get_if<BinaryFormat>(&format);
    if (binary == nullptr || !binary->time || isFloat(binary->time->field.type))
        return link::FrameClock(1.0);
    return link::FrameClock(binary->time->unit_s, bitsOf(binary->time->field.type));
}

} // namespace

bool countsLosses(const FrameFormat& format) {
    if (const auto* binary = std::get_if<BinaryFormat>(&format))
        return binary->counter || (binary->time && !isFloat(binary->time->field.type));
    const auto* json = std::get_if<JsonFormat>(&format);
    return json != nullptr && !json->counter.empty();
}

StreamTime::StreamTime(const FrameFormat& format)
    : m_clock(clockOf(format)) {
    if (const auto* binary = std::get_if<BinaryFormat>(&format); binary != nullptr && binary->counter) {
        m_hasCounter = true;
        m_counterMask = maskOf(binary->counter->type);
    }
    if (const auto* json = std::get_if<JsonFormat>(&format); json != nullptr && !json->counter.empty()) {
        m_hasCounter = true;
        m_counterMask = 0xFFFF'FFFFU;
    }
}

StreamTime::Step StreamTime::advance(const DecodedFrame& frame, double hostTime_s) {
    Step step;
    if (frame.counter) {
        if (m_lastCounter) {
            const std::uint32_t ahead = (*frame.counter - *m_lastCounter) & m_counterMask;
            step.repeated = ahead == 0;
            step.restarted = ahead > m_counterMask / 2;
            step.lost = step.repeated || step.restarted ? 0 : ahead - 1;
        }
        m_lastCounter = frame.counter;
    }
    if (step.repeated) {
        step.time_s = m_time_s;
        return step;
    }
    if (frame.ticks) {
        const link::FrameClock::Step clock = m_clock.advance(*frame.ticks, hostTime_s);
        step.restarted = step.restarted || clock.restarted;
        if (!m_hasCounter)
            step.lost = clock.lost;
        m_time_s = clock.time_s;
    } else if (frame.time_s) {
        m_time_s = timeOf(*frame.time_s, hostTime_s, step);
    } else {
        m_time_s = std::max(m_time_s, hostTime_s);
        m_lastTime_s.reset(); // what passed since then is in the host's time already
    }
    if (step.restarted)
        step.lost = 0;
    step.time_s = m_time_s;
    return step;
}

void StreamTime::beginConnection() {
    m_clock.restart();
    m_lastCounter.reset();
    m_lastTime_s.reset();
}

double StreamTime::timeOf(double time_s, double hostTime_s, Step& step) {
    const bool wentBack = m_lastTime_s && time_s < *m_lastTime_s;
    step.restarted = step.restarted || wentBack;
    const double before_s = m_lastTime_s.value_or(0.0);
    const bool isFirst = !m_lastTime_s || wentBack;
    m_lastTime_s = time_s;
    return isFirst ? std::max(m_time_s, hostTime_s) : m_time_s + (time_s - before_s);
}

} // namespace teleta::taxels
