// SPDX-License-Identifier: GPL-3.0-or-later
// What the board says of itself, and a machine that slept: reasons to end what is played.
#include "tests/backend/playback/playback_cycle_fixture.h"

using namespace teleta;
using namespace teleta::test;

TEST_F(PlaybackCycleTest, endsWhenTheBoardIsTooHotAndDoesNotGoOnByItself) {
    for (const bool live : {false, true}) {
        make();
        const auto post = [&] { m_cycle->setpoints().post({all(1.0), m_clock->now_ns()}); };
        if (live)
            startLive();
        else
            play(steady(1.0));
        m_clock->add(kPeriod_ns);
        post();
        (void)run();
        ASSERT_FALSE(lastIsOff());
        m_bracelet.setTooHot(true);
        m_clock->add(kPeriod_ns);
        post();
        EXPECT_EQ(run(), PacingClock::kNever_ns);
        EXPECT_TRUE(lastIsOff());
        EXPECT_EQ(m_cycle->status().mode, PlayerMode::idle);
        EXPECT_EQ(m_cycle->status().ending, PlayerEnding::tooHot);
        m_bracelet.setTooHot(false);
        m_bracelet.forget();
        m_clock->add(1000 * kMs_ns);
        EXPECT_EQ(run(), PacingClock::kNever_ns);
        EXPECT_TRUE(written().empty()) << "only when asked";
    }
}

TEST_F(PlaybackCycleTest, doesNotBeginOnABoardThatIsTooHot) {
    make();
    m_bracelet.setTooHot(true);
    EXPECT_EQ(play(steady(1.0)), PacingClock::kNever_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::tooHot);
    for (const auto& frame : written())
        EXPECT_TRUE(isOff(frame.frame.drive));
    m_bracelet.setTooHot(false);
    play(steady(1.0));
    EXPECT_FALSE(lastIsOff());
}

TEST_F(PlaybackCycleTest, isNotConfirmedByABoardThatRefusesAFrame) {
    make();
    m_bracelet.setFramesRefused(3);
    m_bracelet.setNumbers(10, 10);
    play(steady(1.0));
    m_bracelet.setNumbers(12, 11);
    EXPECT_TRUE(m_cycle->counters().confirmed) << "what was refused before is of something else";
    EXPECT_EQ(m_cycle->counters().framesRefused, 0U);
    m_bracelet.setFramesRefused(5);
    // The zero frame at the end is understood.
    m_bracelet.setNumbers(14, 14);
    EXPECT_EQ(m_cycle->counters().framesRefused, 2U);
    EXPECT_FALSE(m_cycle->counters().confirmed);
}

TEST_F(PlaybackCycleTest, endsAfterTheMachineHasSleptAlthoughTheClockStoodStill) {
    for (const bool live : {false, true}) {
        make();
        const auto post = [&] { m_cycle->setpoints().post({all(1.0), m_clock->now_ns()}); };
        m_clock->suspend(3'600'000 * kMs_ns); // before the begin it says nothing
        if (live)
            startLive();
        else
            play(steady(1.0));
        m_clock->add(kPeriod_ns);
        post();
        (void)run();
        ASSERT_FALSE(lastIsOff());
        m_clock->suspend(100 * kMs_ns);
        m_clock->add(kPeriod_ns);
        post();
        (void)run();
        EXPECT_FALSE(lastIsOff()) << "a sleep that the board did not notice";
        m_clock->suspend(1);
        m_clock->add(kPeriod_ns);
        post();
        EXPECT_EQ(run(), PacingClock::kNever_ns);
        EXPECT_TRUE(lastIsOff());
        EXPECT_EQ(m_cycle->status().ending, PlayerEnding::stalled);
    }
}

TEST_F(PlaybackCycleTest, goesOnFromTheHeatOfTheSameBraceletWithAnotherPlayer) {
    const PlayerConfig config;
    const SafetyLimits limits{.rise_perS = kInfinity, .heatTime_s = 1.0, .heatBudget = 0.25};
    const auto firstDrive = [&] {
        make(config, limits);
        play(steady(1.0));
        m_clock->add(kPeriod_ns);
        (void)run();
        const auto frames = written();
        const std::uint16_t drive = frames.empty() ? std::uint16_t(0) : frames.back().frame.drive[0];
        m_cycle->close();
        return drive;
    };
    m_bracelet.setSerial("A1");
    make(config, limits);
    play(steady(1.0));
    runOnTime(2000 * kMs_ns);
    EXPECT_NEAR(written().back().frame.drive[0], 0.5 * kFullDrive, 1.0);
    m_cycle->close();
    EXPECT_LT(firstDrive(), 0.6 * kFullDrive) << "a new player does not cool a motor";
    m_bracelet.setSerial("B2");
    EXPECT_EQ(firstDrive(), kFullDrive) << "another bracelet";
    m_bracelet.setSerial("A1");
    EXPECT_LT(firstDrive(), 0.6 * kFullDrive);
    m_clock->add(10'000 * kMs_ns);
    EXPECT_EQ(firstDrive(), kFullDrive) << "it has cooled down since";
}
