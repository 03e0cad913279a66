// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/player.h"
#include "devices/simulated/simulated_bracelet.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

using namespace teleta;
using core::DeviceState;
using core::Drive;
using core::isOff;
using core::kFullDrive;
using core::WriteOutcome;
using simulated::BraceletFaults;
using simulated::SimulatedBracelet;
using simulated::SimulatedBraceletConfig;
using simulated::SimulatedMotor;
using simulated::SimulatedMotors;
using test::eventually;
using test::ManualClock;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Plays on where a busy machine pauses, so that nothing but what is tested ends the playing.
const playback::PlayerConfig kPatient{.boardTimeout_ms = 10'000, .longestSilence_ns = 10'000 * kMs_ns};
constexpr Drive kFull{kFullDrive, kFullDrive, kFullDrive, kFullDrive, kFullDrive, kFullDrive};

SimulatedMotors allAlike(const SimulatedMotor& motor) {
    SimulatedMotors motors;
    motors.fill(motor);
    return motors;
}

class SimulatedBraceletTest : public testing::Test {
protected:
    void make(SimulatedBraceletConfig config = {}) {
        config.link.clock = m_clock;
        m_bracelet = std::make_unique<SimulatedBracelet>(m_stop, config);
        m_bracelet->start(m_wakeup);
        m_clock->settle();
    }
    core::WriteResult write(const Drive& drive, std::uint16_t timeout_ms = 100) {
        return m_bracelet->write({drive, timeout_ms, m_bracelet->connection()});
    }
    [[nodiscard]] DeviceState state() const { return m_bracelet->status().state; }

    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::unique_ptr<SimulatedBracelet> m_bracelet;
};

} // namespace

TEST_F(SimulatedBraceletTest, isLiveAndSaysThatItIsSimulated) {
    make();
    EXPECT_TRUE(m_bracelet->description().simulated);
    EXPECT_FALSE(m_bracelet->description().name.empty());
    EXPECT_EQ(write(kFull).outcome, WriteOutcome::written);
    EXPECT_EQ(state(), DeviceState::live);
    EXPECT_EQ(m_bracelet->drive(), kFull);
    EXPECT_EQ(m_bracelet->motors()[0], 1.0) << "without a lag at once";
    EXPECT_TRUE(m_bracelet->telemetry().board.driving);
    m_bracelet->stop();
    EXPECT_TRUE(isOff(m_bracelet->drive()));
}

// x(t) = 1 - exp(-t / rise), then x exp(-t / fall).
TEST_F(SimulatedBraceletTest, letsMotorsFollowWithALag) {
    make({.motors = allAlike({.rise_s = 0.05, .fall_s = 0.08})});
    write(kFull);
    m_clock->advance(50 * kMs_ns);
    const double risen = 1.0 - std::exp(-1.0);
    EXPECT_NEAR(m_bracelet->motors()[2], risen, 1e-12);
    write({});
    m_clock->advance(80 * kMs_ns);
    EXPECT_NEAR(m_bracelet->motors()[2], risen * std::exp(-1.0), 1e-12);
}

TEST_F(SimulatedBraceletTest, stopsItsMotorsByItselfAfterTheTimeoutOfTheLastFrame) {
    make({.motors = allAlike({.rise_s = 0.01, .fall_s = 0.02})});
    write(kFull, 40);
    m_clock->advance(39 * kMs_ns);
    EXPECT_EQ(m_bracelet->drive(), kFull);
    m_clock->advance(31 * kMs_ns);
    EXPECT_TRUE(isOff(m_bracelet->drive()));
    EXPECT_NEAR(m_bracelet->motors()[0], (1.0 - std::exp(-4.0)) * std::exp(-1.5), 1e-12)
        << "40 ms up, 30 ms down, however late somebody looks";
    write({});
    write({});
    EXPECT_FALSE(m_bracelet->telemetry().board.timedOut) << "told once";
}

TEST_F(SimulatedBraceletTest, countsTheFramesThatTheLinkDrops) {
    make({.faults = {.dropShare = 0.25}});
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(write(kFull).outcome, WriteOutcome::written) << "as the kernel says";
    m_bracelet->setFaults({});
    write({});
    const core::BraceletTelemetry telemetry = m_bracelet->telemetry();
    EXPECT_EQ(telemetry.framesEchoed + telemetry.framesLost, telemetry.framesWritten);
    // Five standard deviations of a binomial with n = 1000, p = 1/4.
    EXPECT_NEAR(static_cast<double>(telemetry.framesLost), 250.0, 5.0 * std::sqrt(1000.0 * 0.25 * 0.75));
}

TEST_F(SimulatedBraceletTest, losesItsConnectionWhenWritingFailsAndComesBack) {
    make();
    write(kFull);
    m_bracelet->setFaults({.failWrites = true});
    EXPECT_EQ(write(kFull).outcome, WriteOutcome::lost);
    EXPECT_EQ(m_bracelet->connection(), 0U);
    m_bracelet->setFaults({});
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        m_clock->advance(100 * kMs_ns);
        return state() == DeviceState::live;
    }));
    EXPECT_TRUE(isOff(m_bracelet->drive()));
    EXPECT_EQ(m_bracelet->connection(), 2U);
}

TEST_F(SimulatedBraceletTest, isStaleWhenItAnswersNothing) {
    make();
    write({});
    m_bracelet->setFaults({.mute = true});
    for (int i = 0; i < 60; ++i)
        m_clock->advance(10 * kMs_ns);
    EXPECT_EQ(state(), DeviceState::stale);
}

TEST_F(SimulatedBraceletTest, saysThatItIsTooHotThatItsSupplyIsLowAndThatItRefusesAFrame) {
    make();
    write(kFull);
    EXPECT_FALSE(m_bracelet->telemetry().board.tooHot);
    m_bracelet->setFaults({.tooHot = true, .supplyLow = true});
    write(kFull);
    core::BoardReport board = m_bracelet->telemetry().board;
    EXPECT_TRUE(board.tooHot && board.supplyLow && !board.frameRefused);
    EXPECT_GT(board.temperature_degC, 60.0);
    EXPECT_LT(board.supply_V, 4.5);
    write({});
    m_bracelet->setFaults({.refuse = true});
    write(kFull);
    EXPECT_TRUE(m_bracelet->telemetry().board.frameRefused);
    EXPECT_TRUE(isOff(m_bracelet->drive()));
    EXPECT_EQ(m_bracelet->telemetry().framesRefused, 1U);
    write({});
    EXPECT_FALSE(m_bracelet->telemetry().board.frameRefused) << "a zero frame is understood";
}

// The real clock from here on: player and bracelet on their own threads.
TEST(SimulatedBracelet, takesItsTimeWhenWritesAreSlow) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedBracelet bracelet(stop, {.faults = {.slowWrite_s = 0.002}});
    bracelet.start(wakeup);
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() != 0; }));
    const std::int64_t begin_ns = core::steadyNow_ns();
    const auto result = bracelet.write({kFull, 1000, bracelet.connection()});
    EXPECT_EQ(result.outcome, WriteOutcome::written);
    EXPECT_GE(result.time_ns - begin_ns, 2 * kMs_ns);
}

TEST(SimulatedBracelet, isPlayedOnAndZeroedWhenThePlayerGoes) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedBracelet bracelet(stop);
    bracelet.start(wakeup);
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() != 0; }));
    {
        playback::Player player(bracelet, stop, kPatient);
        player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, kInfinity});
        ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.drive() == kFull; }));
        ASSERT_TRUE(eventually(wakeup, [&] { return player.counters().framesWritten >= 50; }));
        EXPECT_NE(player.counters().onset_ns, 0);
    }
    EXPECT_TRUE(isOff(bracelet.drive()));
    EXPECT_TRUE(isOff(bracelet.telemetry().written));
}

TEST(SimulatedBracelet, isZeroedAfterItWasUnpluggedWhilePlayingAndPlaysOnlyWhenAsked) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedBracelet bracelet(stop, {.link = {.firstRetry_ns = 1 * kMs_ns, .longestRetry_ns = 2 * kMs_ns}});
    bracelet.start(wakeup);
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() != 0; }));
    playback::Player player(bracelet, stop, kPatient);
    player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, kInfinity});
    ASSERT_TRUE(eventually(wakeup, [&] { return !isOff(bracelet.drive()); }));
    bracelet.setFaults({.unplugged = true});
    ASSERT_TRUE(
        eventually(wakeup, [&] { return player.status().ending == playback::PlayerEnding::deviceLost; }));
    bracelet.setFaults({});
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() > 1; }));
    EXPECT_TRUE(isOff(bracelet.drive()));
    EXPECT_TRUE(isOff(bracelet.telemetry().written));
    EXPECT_EQ(player.status().mode, playback::PlayerMode::idle);
    player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, kInfinity});
    EXPECT_TRUE(eventually(wakeup, [&] { return !isOff(bracelet.drive()); }));
}

TEST(SimulatedBracelet, endsThePlayingWhenItAnswersNoMoreAndPlaysOnlyWhenAskedAfterItWoke) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedBracelet bracelet(stop);
    bracelet.start(wakeup);
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() != 0; }));
    // A pause of the machine is a silence too: the shortest one that this does not mistake for the fault.
    playback::Player player(bracelet, stop, {.boardTimeout_ms = 10'000, .longestSilence_ns = 3000 * kMs_ns});
    player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, kInfinity});
    ASSERT_TRUE(eventually(wakeup, [&] { return !isOff(bracelet.drive()); }));
    bracelet.setFaults({.mute = true});
    ASSERT_TRUE(
        eventually(wakeup, [&] { return player.status().ending == playback::PlayerEnding::deviceLost; }));
    EXPECT_TRUE(isOff(bracelet.drive()));
    bracelet.setFaults({});
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.status().state == DeviceState::live; }));
    EXPECT_EQ(bracelet.connection(), 1U) << "it was there all the time";
    EXPECT_TRUE(isOff(bracelet.drive()));
    EXPECT_EQ(player.status().mode, playback::PlayerMode::idle);
    player.play({[](double) { return core::Intensities{1, 1, 1, 1, 1, 1}; }, kInfinity});
    EXPECT_TRUE(eventually(wakeup, [&] { return !isOff(bracelet.drive()); }));
}

TEST(SimulatedBracelet, isZeroedWhileAProgramHangs) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedBracelet bracelet(stop);
    bracelet.start(wakeup);
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() != 0; }));
    std::atomic<bool> hangs{true};
    std::atomic<bool> entered{false};
    // The board alone would go on for 10 s.
    playback::Player player(bracelet, stop, kPatient);
    player.play({[&](double t_s) {
                     if (t_s > 0.02) {
                         entered = true;
                         hangs.wait(true);
                     }
                     return core::Intensities{1, 1, 1, 1, 1, 1};
                 },
                 kInfinity});
    EXPECT_TRUE(eventually(wakeup, [&] { return entered && bracelet.telemetry().zeroedByDevice >= 1; }));
    EXPECT_TRUE(isOff(bracelet.drive()));
    hangs = false;
    hangs.notify_all();
}

TEST(SimulatedBracelet, isZeroedBySTOPWhilePlaying) {
    core::StopSwitch stop;
    core::Wakeup wakeup;
    SimulatedBracelet bracelet(stop);
    bracelet.start(wakeup);
    ASSERT_TRUE(eventually(wakeup, [&] { return bracelet.connection() != 0; }));
    playback::Player player(bracelet, stop, kPatient);
    player.startLive();
    ASSERT_TRUE(eventually(wakeup, [&] {
        player.post({1, 1, 1, 1, 1, 1}, core::steadyNow_ns());
        return !isOff(bracelet.drive());
    }));
    stop.engage();
    EXPECT_TRUE(eventually(wakeup, [&] {
        player.post({1, 1, 1, 1, 1, 1}, core::steadyNow_ns());
        return isOff(bracelet.drive()) && player.status().ending == playback::PlayerEnding::stopSwitch;
    }));
}
