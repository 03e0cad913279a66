// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/player.h"
#include "tests/backend/playback/playback_cycle_fixture.h"

#include <cmath>

using namespace teleta;
using namespace teleta::test;
using playback::ProgramChange;

namespace {

class PlaybackChangeTest : public PlaybackCycleTest {
protected:
    void playNumbered(Program program, std::uint64_t number, bool loop = false) {
        PlayerCommands commands;
        commands.start = ProgramRequest{std::move(program), loop, 0.0, number};
        commands.newest = number;
        run(std::move(commands));
    }
    void change(Program program, double shift_s, std::uint64_t number) {
        PlayerCommands commands;
        commands.change = ProgramChange{std::move(program), shift_s, number};
        run(std::move(commands));
    }
    [[nodiscard]] double position_s() const { return m_cycle->status().position_s; }
};

/// The second tactor tells the time: 1 is 1 s.
Program otherClock(double duration_s) {
    return {[](double t_s) { return Intensities{0.0, t_s}; }, duration_s};
}

} // namespace

TEST_F(PlaybackChangeTest, goesOnWithAnotherProgramAtTheSameTimeWithoutABreak) {
    make();
    playNumbered(clockOf1s(), 1);
    runOnTime(400 * kMs_ns);
    const std::int64_t begun_ns = m_cycle->status().begun_ns;
    change(otherClock(2.0), 0.0, 1);
    runOnTime(200 * kMs_ns);
    EXPECT_NEAR(position_s(), 0.6, 1e-9);
    EXPECT_EQ(written().back().frame.drive[0], 0);
    EXPECT_NEAR(written().back().frame.drive[1], 0.6 * kFullDrive, 1.0);
    EXPECT_EQ(m_cycle->status().begun_ns, begun_ns) << "the same playing";
    EXPECT_EQ(m_cycle->counters().deadlineMisses, 0U);
    EXPECT_EQ(m_cycle->counters().framesWritten, 121U);
    runOnTime(1500 * kMs_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished) << "after 2 s, as the new one is long";
    EXPECT_EQ(m_cycle->status().ended_ns - begun_ns, 2000 * kMs_ns);
}

TEST_F(PlaybackChangeTest, movesThePositionWithTheBeginOfAProgramThatBeginsElsewhere) {
    make();
    playNumbered(otherClock(10.0), 1, true);
    runOnTime(600 * kMs_ns);
    // The stretch from 0.5 s to 0.8 s of the same pattern: 0.6 s are 0.1 s in it.
    change({[](double t_s) { return Intensities{0.0, 0.5 + t_s}; }, 0.3}, -0.5, 1);
    runOnTime(100 * kMs_ns);
    EXPECT_NEAR(position_s(), 0.2, 1e-9);
    EXPECT_NEAR(written().back().frame.drive[1], 0.7 * kFullDrive, 1.0);
    runOnTime(200 * kMs_ns);
    EXPECT_NEAR(position_s(), 0.1, 1e-9) << "begun anew at 0.3 s";
    change(otherClock(10.0), -5.0, 1);
    runOnTime(50 * kMs_ns);
    EXPECT_NEAR(position_s(), 0.05, 1e-9) << "what lies before the begin is not played";
}

TEST_F(PlaybackChangeTest, endsWhenTheOtherProgramIsOverAlready) {
    make();
    playNumbered(clockOf1s(), 1);
    runOnTime(600 * kMs_ns);
    change(steady(1.0, 0.5), 0.0, 1);
    runOnTime(10 * kMs_ns);
    EXPECT_EQ(m_cycle->status().ending, PlayerEnding::finished);
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackChangeTest, changesNothingThatIsNotTheProgramWithThatNumber) {
    make();
    change(steady(1.0), 0.0, 0);
    EXPECT_TRUE(written().empty()) << "nothing plays";
    playNumbered(clockOf1s(), 2);
    runOnTime(200 * kMs_ns);
    change(steady(1.0), 0.0, 1);
    change({{}, 1.0}, 0.0, 2);
    change(steady(1.0, -1.0), 0.0, 2);
    change(steady(1.0), std::nan(""), 2);
    runOnTime(100 * kMs_ns);
    EXPECT_NEAR(written().back().frame.drive[0], 0.3 * kFullDrive, 1.0);
    EXPECT_EQ(written().back().frame.drive[1], 0);
    startLive();
    change(steady(1.0), 0.0, 2);
    runOnTime(50 * kMs_ns);
    EXPECT_TRUE(lastIsOff());
}

TEST_F(PlaybackChangeTest, tellsWhichProgramBeganAndWhichWasDropped) {
    make();
    playNumbered(steady(1.0), 1);
    EXPECT_EQ(m_cycle->status().program, 1U);
    EXPECT_EQ(m_cycle->status().settled, 1U);
    PlayerCommands dropped;
    dropped.stop = true;
    dropped.newest = 2;
    run(std::move(dropped));
    EXPECT_EQ(m_cycle->status().program, 1U);
    EXPECT_EQ(m_cycle->status().settled, 2U);
    PlayerCommands whileIdle;
    whileIdle.newest = 3;
    run(std::move(whileIdle));
    EXPECT_EQ(m_cycle->status().settled, 3U);
    m_stop.engage();
    playNumbered(steady(1.0), 4);
    EXPECT_EQ(m_cycle->status().program, 1U) << "STOP is engaged";
    EXPECT_EQ(m_cycle->status().settled, 4U);
}

TEST(Player, changesTheProgramThatItWasAskedForBeforeItBegan) {
    const auto clock = std::make_shared<SetClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    PlayerConfig config;
    config.limits = {.rise_perS = kInfinity, .heatBudget = 1.0};
    config.clock = clock;
    playback::Player player(bracelet, stop, std::move(config));
    const std::uint64_t first = player.play(steady(1.0));
    const std::uint64_t second = player.play(steady(0.25));
    EXPECT_EQ(second, first + 1);
    player.change(first, steady(1.0));
    player.change(second, steady(0.5));
    EXPECT_TRUE(bracelet.waitFor([](const auto& frames) {
        return !frames.empty() &&
               frames.back().frame.drive == core::Drive{2047, 2047, 2047, 2047, 2047, 2047};
    }) || player.status().program == second);
    EXPECT_EQ(player.status().settled, second);
}
