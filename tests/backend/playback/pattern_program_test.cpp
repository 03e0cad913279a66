// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/overdriven.h"
#include "backend/playback/pattern_program.h"
#include "backend/playback/playback_cycle.h"
#include "tests/backend/playback/scripted_bracelet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace teleta;

// The second tactor rises from 0 to 1 within 1 s, of a pattern of 2 s; the fourth is at a half all the time.
TEST(PatternProgram, isWrittenToTheBraceletAsItWasDrawn) {
    pattern::Pattern drawn;
    drawn.duration_s = 2.0;
    drawn.tracks[1] = {{0.0, 0.0}, {1.0, 1.0}};
    drawn.tracks[3] = {{0.0, 0.5}, {2.0, 0.5}};
    const auto clock = std::make_shared<test::SetClock>();
    test::ScriptedBracelet bracelet(clock);
    core::StopSwitch stop;
    playback::PlaybackCycle cycle(
        bracelet, stop,
        {.limits = {.rise_perS = std::numeric_limits<double>::infinity(), .heatBudget = 1.0},
         .clock = clock});
    playback::PlayerCommands commands;
    commands.start = playback::ProgramRequest{playback::programOf(drawn)};
    drawn = {}; // what is played does not change any more
    for (std::int64_t next_ns = cycle.run(std::move(commands)); next_ns != core::PacingClock::kNever_ns;
         next_ns = cycle.run({}))
        clock->add(next_ns - clock->now_ns());
    const auto frames = bracelet.written();
    ASSERT_EQ(frames.size(), 401U);
    for (std::size_t k = 0; k < 200; ++k) {
        ASSERT_NEAR(frames[k].frame.drive[1], 0.005 * static_cast<double>(k) * core::kFullDrive, 1.0) << k;
        ASSERT_EQ(frames[k].frame.drive[3], 2047) << k;
        ASSERT_EQ(frames[k].frame.drive[0], 0) << k;
    }
    EXPECT_EQ(frames[300].frame.drive[1], 0) << "off from its last breakpoint on";
    EXPECT_TRUE(core::isOff(frames[400].frame.drive));
    EXPECT_EQ(cycle.status().ending, playback::PlayerEnding::finished);
}

// A prompt begin leaves out one frame, and only when it would be lost: what is silent for longer is meant so.
TEST(PatternProgram, beginsPromptlyWithTheFirstFrameThatIsFelt) {
    const auto begin_s = [](const pattern::Track& track, double rate_Hz) {
        pattern::Pattern drawn;
        drawn.duration_s = 2.0;
        drawn.tracks[4] = track;
        return playback::promptBegin_s(playback::programOf(drawn), rate_Hz);
    };
    EXPECT_EQ(begin_s({{0.0, 0.0}, {1.0, 1.0}}, 200.0), 1.0 / 200.0);
    EXPECT_EQ(begin_s({{0.0, 0.0}, {1.0, 1.0}}, 40.0), 1.0 / 40.0);
    EXPECT_EQ(begin_s({{0.0, 0.5}, {1.0, 1.0}}, 200.0), 0.0);
    EXPECT_EQ(begin_s({{0.02, 0.5}, {1.0, 1.0}}, 200.0), 0.0);
    EXPECT_EQ(begin_s({}, 200.0), 0.0);
}

TEST(PatternProgram, aProgramThatCannotSayBeginsAtItsBegin) {
    const auto half = [](double) { return core::Intensities{0.5}; };
    EXPECT_EQ(playback::promptBegin_s({}, 200.0), 0.0);
    EXPECT_EQ(playback::promptBegin_s(
                  {[](double) -> core::Intensities { throw std::runtime_error("no"); }, 1.0}, 200.0),
              0.0);
    EXPECT_EQ(playback::promptBegin_s({half, 0.004}, 200.0), 0.0) << "shorter than a frame";
    EXPECT_EQ(playback::promptBegin_s({half, 0.0}, 200.0), 0.0);
}

TEST(PatternProgram, mapsOnlyMotorsThatSomebodyHasMeasured) {
    pattern::MotorProfiles motors = pattern::assumedMotors();
    motors[2].rangeAssumed = false;
    motors[2].startDrive = 0.3;
    motors[2].fullDrive = 0.9;
    playback::DriveRanges expected{};
    expected[2] = {0.3, 0.9};
    EXPECT_EQ(playback::rangesOf(motors), expected);
}

// Help for the motors is asked above the limits like everything else.
TEST(PatternProgram, anOverdrivenOneStaysBelowTheSafetyLimits) {
    pattern::Pattern drawn;
    drawn.duration_s = 2.0;
    for (pattern::Track& track : drawn.tracks)
        track = {{0.1, 0.3}, {1.9, 0.3}};
    const auto helped = pattern::overdriven(drawn, pattern::assumedMotors());
    ASSERT_TRUE(helped);
    ASSERT_EQ(pattern::evaluate(*helped, 0.101)[0], 1.0);
    const auto clock = std::make_shared<test::SetClock>();
    test::ScriptedBracelet bracelet(clock);
    core::StopSwitch stop;
    playback::SafetyLimits limits{.rise_perS = 50.0};
    limits.userLimit.fill(0.6);
    playback::PlaybackCycle cycle(bracelet, stop, {.limits = limits, .clock = clock});
    playback::PlayerCommands commands;
    commands.start = playback::ProgramRequest{playback::programOf(*helped)};
    for (std::int64_t next_ns = cycle.run(std::move(commands)); next_ns != core::PacingClock::kNever_ns;
         next_ns = cycle.run({}))
        clock->add(next_ns - clock->now_ns());
    int before = 0;
    int most = 0;
    for (const auto& frame : bracelet.written()) {
        const int now = frame.frame.drive[0];
        EXPECT_LE(now - before, static_cast<int>(std::ceil(50.0 * 0.005 * 4095.0)));
        before = now;
        most = std::max(most, now);
    }
    EXPECT_LE(most, static_cast<int>(0.6 * 4095.0));
    EXPECT_GT(most, static_cast<int>(0.3 * 4095.0)) << "the help arrives";
    EXPECT_EQ(before, 0);
}
