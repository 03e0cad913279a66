// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/steady_time.h"

#include <atomic>
#include <initializer_list>
#include <utility>
#include <vector>

namespace teleta::test {

/// A source whose frames the test itself puts into the queue.
class ScriptedSource : public core::TactileSource {
public:
    explicit ScriptedSource(const core::ArrayLayout& layout, std::size_t capacity = 64)
        : m_blocks(capacity) {
        m_description.name = "scripted";
        m_description.layout = layout;
        m_description.unit = "counts";
    }

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override {
        m_consumer = &consumer;
        m_started = true;
    }
    void stop() override { ++m_stops; }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override { return m_blocks; }
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }

    /// Queues one frame that was read at source time time_s.
    bool push(std::vector<float> values, double time_s, bool discontinuity = false) {
        core::SampleBlock block;
        block.firstFrame = m_frames++;
        block.channels = values.size();
        block.time_ns = {core::steadyNow_ns()};
        block.sourceTime_s = {time_s};
        block.values = std::move(values);
        block.discontinuity = discontinuity;
        const bool fits = m_blocks.push(std::move(block));
        if (m_consumer != nullptr)
            m_consumer->notify();
        return fits;
    }

    [[nodiscard]] bool started() const { return m_started; }
    [[nodiscard]] int stops() const { return m_stops; }

private:
    core::SourceDescription m_description;
    core::BoundedQueue<core::SampleBlock> m_blocks;
    core::Wakeup* m_consumer = nullptr;
    std::uint64_t m_frames = 0;
    std::atomic<bool> m_started{false};
    std::atomic<int> m_stops{0};
};

} // namespace teleta::test
