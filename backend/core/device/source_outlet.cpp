// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/source_outlet.h"

#include <algorithm>
#include <utility>

namespace teleta::core {

void SourceOutlet::open(Wakeup& consumer, std::int64_t now_ns) {
    m_nextFrame = 0;
    m_status.open(consumer, now_ns);
}

void SourceOutlet::deliver(SampleBlock&& block, DeviceState state, std::optional<std::int64_t> arrived_ns) {
    begin(block);
    if (arrived_ns)
        std::ranges::fill(m_time_ns, *arrived_ns);
    if (!m_blocks.push(std::move(block), m_time_ns.size()))
        m_status.lose(m_time_ns.size());
    finish(state);
}

bool SourceOutlet::tryDeliver(SampleBlock& block, DeviceState state) {
    begin(block);
    if (!m_blocks.tryPush(block))
        return false;
    finish(state);
    return true;
}

void SourceOutlet::begin(SampleBlock& block) {
    block.firstFrame = m_nextFrame;
    m_time_ns.assign(block.time_ns.begin(), block.time_ns.end());
}

void SourceOutlet::finish(DeviceState state) {
    m_nextFrame += m_time_ns.size();
    m_status.receive(state, m_time_ns);
    m_status.publishAndWake();
}

void SourceOutlet::lose(std::uint64_t frames) {
    m_nextFrame += frames;
    m_status.lose(frames);
    m_status.publishAndWake();
}

} // namespace teleta::core
