// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/playback/playback_cycle_fixture.h"

using namespace teleta;
using namespace teleta::test;

TEST_F(PlaybackCycleTest, evaluatesALateCycleAtTheTrueTimeAndCatchesNothingUp) {
    make();
    const std::int64_t begin_ns = m_clock->now_ns();
    play(clockOf1s());
    m_clock->add(kPeriod_ns + 13 * kMs_ns); // deadlines 1, 2 and 3 have passed
    EXPECT_EQ(run(), begin_ns + 4 * kPeriod_ns) << "the grid stays";
    const auto frames = written();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_NEAR(frames[1].frame.drive[0], 0.018 * kFullDrive, 1.0);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 2U);
    m_clock->add(2 * kMs_ns);
    EXPECT_EQ(run(), begin_ns + 5 * kPeriod_ns);
    EXPECT_EQ(written().size(), 3U);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 2U);
}

TEST_F(PlaybackCycleTest, aProgramMissesNoDeadlineAtOrAfterItsEndAndAllBefore) {
    make();
    play(steady(1.0, 0.1));
    runOnTime(94 * kMs_ns);
    m_clock->add(1 * kMs_ns);
    m_bracelet.whileWriting([this] { m_clock->add(8 * kMs_ns); });
    run();
    m_clock->add(2 * kMs_ns);
    run();
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished);
    EXPECT_EQ(m_cycle->counters().framesWritten, 20U);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U) << "the next deadline would be the end";
    m_bracelet.whileWriting({});
    play(steady(1.0, 0.05));
    m_clock->add(60 * kMs_ns);
    run();
    EXPECT_EQ(m_cycle->counters().framesWritten, 1U);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 9U) << "all others";
}

TEST_F(PlaybackCycleTest, countsSlowWritesAndTheDeadlinesTheyCost) {
    make();
    const std::int64_t begin_ns = m_clock->now_ns();
    m_bracelet.whileWriting([this] { m_clock->add(8 * kMs_ns); });
    EXPECT_EQ(play(steady(1.0)), begin_ns + 2 * kPeriod_ns);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 1U);
    EXPECT_EQ(m_cycle->counters().writeMedian_ns, 8 * kMs_ns);
    m_bracelet.whileWriting([this] { m_clock->add(1 * kMs_ns); });
    runOnTime(100 * kMs_ns);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 1U);
    EXPECT_NEAR(static_cast<double>(m_cycle->counters().writeMedian_ns), 1e6, 0.032e6) << "a bucket";
    EXPECT_EQ(m_cycle->counters().writeLongest_ns, 8 * kMs_ns);
    EXPECT_EQ(m_cycle->counters().onset_ns, begin_ns + 8 * kMs_ns) << "when the write returned";
}

TEST_F(PlaybackCycleTest, aProgramHasAFrameForEachOfItsCyclesWhateverTheClockDoesAtItsStart) {
    // Every look at the clock takes 3 us.
    m_clock->addAtEachLook(3'000);
    make();
    play(steady(1.0, 0.1));
    runOnTime(500 * kMs_ns);
    EXPECT_EQ(m_cycle->counters().framesWritten, 20U);
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U);
}

TEST_F(PlaybackCycleTest, aPlaceThatIsNoTimeOfTheProgramIsIgnored) {
    make();
    play(steady(1.0, 0.1), false, 0.05);
    play(steady(1.0, 0.1), false, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(m_cycle->status().position_s, 0.0) << "not where the program before began";
    play(steady(0.5), true, kInfinity);
    EXPECT_EQ(m_cycle->status().position_s, 0.0);
    m_clock->add(kPeriod_ns);
    PlayerCommands commands;
    commands.seek_s = kInfinity;
    run(std::move(commands));
    EXPECT_NEAR(m_cycle->status().position_s, 0.005, 1e-12);
    EXPECT_EQ(m_cycle->status().mode, PlayerMode::program);
}
