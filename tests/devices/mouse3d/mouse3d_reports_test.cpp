// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d_motion.h"
#include "devices/mouse3d/mouse3d_reports.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace teleta::mouse3d;

namespace {

ReportKind decode(const std::vector<std::uint8_t>& report, RawAxes& state) {
    return decodeReport(report, state);
}

} // namespace

// The first three as a SpaceNavigator sends them: at rest, turned about its second axis, a button pressed.
TEST(Mouse3dReports, decodesTheSeparateForm) {
    RawAxes state;
    EXPECT_EQ(decode({0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00}, state), ReportKind::axes);
    EXPECT_EQ(state, RawAxes{});
    EXPECT_EQ(decode({0x02, 0x00, 0x00, 0xE2, 0xFF, 0x00, 0x00}, state), ReportKind::axes);
    EXPECT_EQ(state.rotation, (std::array<std::int16_t, 3>{0, -30, 0}));
    EXPECT_EQ(decode({0x03, 0x01, 0x00}, state), ReportKind::buttons);
    EXPECT_EQ(state.buttons, 1U);
    EXPECT_EQ(decode({0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x01, 0x00}, state), ReportKind::axes);
    EXPECT_EQ(state.translation, (std::array<std::int16_t, 3>{350, -350, 1}));
    EXPECT_EQ(state.rotation[1], -30) << "the other half keeps its value";
    EXPECT_EQ(state.buttons, 1U);
}

TEST(Mouse3dReports, decodesTheMergedForm) {
    RawAxes state;
    EXPECT_EQ(decode({0x01, 0x01, 0x00, 0x02, 0x00, 0x03, 0x00, 0xFF, 0xFF, 0x00, 0x80, 0xFF, 0x7F}, state),
              ReportKind::axes);
    EXPECT_EQ(state.translation, (std::array<std::int16_t, 3>{1, 2, 3}));
    EXPECT_EQ(state.rotation, (std::array<std::int16_t, 3>{-1, -32768, 32767}));
}

TEST(Mouse3dReports, decodesUpTo32Buttons) {
    RawAxes state;
    EXPECT_EQ(decode({0x03, 0x03, 0x00}, state), ReportKind::buttons);
    EXPECT_EQ(state.buttons, 3U);
    EXPECT_EQ(decode({0x03, 0x00, 0x00, 0x00, 0x80}, state), ReportKind::buttons);
    EXPECT_EQ(state.buttons, 0x80000000U);
    EXPECT_EQ(decode({0x03, 0x02, 0x00, 0x00, 0x00, 0xFF, 0xFF}, state), ReportKind::buttons);
    EXPECT_EQ(state.buttons, 2U);
    EXPECT_EQ(decode({0x03, 0x00}, state), ReportKind::buttons);
    EXPECT_EQ(state.buttons, 0U);
}

TEST(Mouse3dReports, areLeftAloneWhenDamagedOrAboutSomethingElse) {
    const RawAxes before{.translation = {1, 2, 3}, .rotation = {4, 5, 6}, .buttons = 7};
    RawAxes state = before;
    const std::vector<std::vector<std::uint8_t>> damaged = {
        {},
        {0x01},
        {0x01, 1, 0, 2, 0, 3},
        {0x01, 1, 0, 2, 0, 3, 0, 4},
        {0x01, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6},
        {0x01, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7},
        {0x02, 1, 0, 2, 0, 3},
        {0x02, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0},
        {0x03},
    };
    for (const auto& report : damaged) {
        EXPECT_EQ(decode(report, state), ReportKind::damaged);
        EXPECT_EQ(state, before);
    }
    EXPECT_EQ(decode({0x17, 0x64}, state), ReportKind::other) << "the battery";
    EXPECT_EQ(decode({0x00}, state), ReportKind::other);
    EXPECT_EQ(state, before);
}

TEST(Mouse3dMotion, isZeroInTheDeadZoneAndBeginsAtZeroBeyondIt) {
    const MotionLimits limits{.fullScale_counts = 400.0, .deadZone = 0.1};
    EXPECT_EQ(scaleAxis(0, limits), 0.0);
    EXPECT_EQ(scaleAxis(40, limits), 0.0);
    EXPECT_EQ(scaleAxis(-40, limits), 0.0);
    // (41/400 - 0.1) / 0.9
    EXPECT_NEAR(scaleAxis(41, limits), 0.0025 / 0.9, 1e-15);
    EXPECT_NEAR(scaleAxis(220, limits), 0.5, 1e-15);
    EXPECT_NEAR(scaleAxis(-220, limits), -0.5, 1e-15);
    EXPECT_EQ(scaleAxis(400, limits), 1.0);
}

TEST(Mouse3dMotion, neverLeavesItsRangeAndNeverTurnsBack) {
    const MotionLimits limits;
    EXPECT_EQ(scaleAxis(32767, limits), 1.0);
    EXPECT_EQ(scaleAxis(-32768, limits), -1.0);
    double last = -1.0;
    for (int counts = -500; counts <= 500; ++counts) {
        const double value = scaleAxis(static_cast<std::int16_t>(counts), limits);
        ASSERT_GE(value, last);
        ASSERT_EQ(value, -scaleAxis(static_cast<std::int16_t>(-counts), limits));
        last = value;
    }
}

TEST(Mouse3dMotion, turnsTheMousesFrameIntoTheOperators) {
    const RawAxes raw{.translation = {350, 350, 350}, .rotation = {-350, 350, 0}};
    const SixAxes axes = scaleAxes(raw, {});
    EXPECT_EQ(axes.translation, (std::array<double, 3>{1.0, -1.0, -1.0})) << "towards the operator, and down";
    EXPECT_EQ(axes.rotation, (std::array<double, 3>{-1.0, -1.0, 0.0}));
    EXPECT_FALSE(std::signbit(axes.rotation[2]));
}
