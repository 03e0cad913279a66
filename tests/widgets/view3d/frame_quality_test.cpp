// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/frame_quality.h"

#include <gtest/gtest.h>

using teleta::view3d::FrameQuality;
using Level = FrameQuality::Level;

namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Draws until the level changes, or a few decisions long; each frame takes what its level costs.
Level settled(FrameQuality& quality, std::int64_t plain_ns, std::int64_t smooth_ns, std::int64_t shaded_ns) {
    for (int frame = 0; frame < 10 * FrameQuality::kFrames; ++frame)
        quality.drawn(quality.level() == Level::plain    ? plain_ns
                      : quality.level() == Level::smooth ? smooth_ns
                                                         : shaded_ns);
    return quality.level();
}

} // namespace

TEST(FrameQuality, AQuickDriverDrawsEverything) {
    FrameQuality quality;
    EXPECT_EQ(quality.level(), Level::plain);
    EXPECT_EQ(settled(quality, 1 * kMs, 1 * kMs, 3 * kMs), Level::shaded);
}

TEST(FrameQuality, ASlowDriverStaysPlain) {
    FrameQuality quality;
    EXPECT_EQ(settled(quality, 9 * kMs, 1 * kMs, 1 * kMs), Level::plain)
        << "no trial: there is no room for more";
}

TEST(FrameQuality, ALevelThatTakesTooLongIsLeftForGood) {
    FrameQuality quality;
    EXPECT_EQ(settled(quality, 1 * kMs, 2 * kMs, 13 * kMs), Level::smooth);
    for (int frame = 0; frame < 100 * FrameQuality::kFrames; ++frame) {
        quality.drawn(1 * kMs);
        ASSERT_EQ(quality.level(), Level::smooth);
    }
}

TEST(FrameQuality, AnotherSizeMayBeDrawnFinely) {
    FrameQuality quality;
    EXPECT_EQ(settled(quality, 2 * kMs, 20 * kMs, 40 * kMs), Level::plain);
    quality.restart();
    EXPECT_EQ(settled(quality, 1 * kMs, 2 * kMs, 20 * kMs), Level::smooth);
}

/// Up to one slow frame of twenty is no reason: another program wanted the processor.
TEST(FrameQuality, AFewSlowFramesChangeNothing) {
    FrameQuality quality;
    settled(quality, 1 * kMs, 1 * kMs, 1 * kMs);
    for (int frame = 0; frame < 10 * FrameQuality::kFrames; ++frame) {
        quality.drawn(frame % 40 == 0 ? 200 * kMs : 5 * kMs);
        ASSERT_EQ(quality.level(), Level::shaded);
    }
}

TEST(FrameQuality, AFrameAtTheBudgetIsWithinIt) {
    FrameQuality quality;
    EXPECT_EQ(settled(quality, 1 * kMs, 1 * kMs, FrameQuality::kBudget_ns), Level::shaded);
}
