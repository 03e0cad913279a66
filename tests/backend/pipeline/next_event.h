// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch_pipeline.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace teleta::test {

/// Waits for what became of the oldest request; the test's time-out ends it. Only one event may be there.
inline pipeline::ChannelEvent nextEvent(pipeline::TouchPipeline& pipeline) {
    std::vector<pipeline::ChannelEvent> events;
    while ((events = pipeline.takeEvents()).empty())
        std::this_thread::yield();
    EXPECT_EQ(events.size(), 1U);
    return events.front();
}

} // namespace teleta::test
