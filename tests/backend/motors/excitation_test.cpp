// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/excitation.h"
#include "backend/motors/excitation_run.h"
#include "backend/motors/motor_fit.h"
#include "devices/simulated/simulated_bracelet.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

using namespace teleta;
using motors::Excitation;
using simulated::SimulatedBracelet;

namespace {

/// Continues to play when a busy machine pauses.
const playback::PlayerConfig kPatient{.boardTimeout_ms = 10'000, .longestSilence_ns = 10'000'000'000};

class ExcitationRunTest : public testing::Test {
protected:
    void make(const std::optional<simulated::SimulatedMotors>& kinds) {
        m_bracelet =
            std::make_unique<SimulatedBracelet>(m_stop, simulated::SimulatedBraceletConfig{.motors = kinds});
        m_bracelet->start(m_wakeup);
        ASSERT_TRUE(test::eventually(m_wakeup, [&] { return m_bracelet->connection() != 0; }));
        m_player = std::make_unique<playback::Player>(*m_bracelet, m_stop, kPatient);
    }
    core::Expected<motors::MotorRecording> record(const Excitation& excitation, std::stop_token token = {}) {
        return recordExcitation(*m_player, *m_bracelet, 3, excitation, token, m_progress, m_clock);
    }

    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    core::PacingClock m_clock;
    std::unique_ptr<SimulatedBracelet> m_bracelet;
    std::unique_ptr<playback::Player> m_player;
    std::atomic<double> m_progress{0.0};
};

/// The longest time between two samples; a pause of the machine leaves a gap.
double longestHole_s(const motors::MotorRecording& recording) {
    double longest_s = 0.0;
    for (std::size_t i = 1; i < recording.size(); ++i)
        longest_s = std::max(longest_s, recording.time_s[i] - recording.time_s[i - 1]);
    return longest_s;
}

Excitation shortOne() {
    return {{{0.0, 0.0}, {0.1, 0.4}, {0.25, 1.0}, {0.4, 0.0}}, 0.5};
}

} // namespace

TEST(Excitation, holdsEachDriveAndIsOffOutside) {
    const Excitation excitation = shortOne();
    EXPECT_EQ(excitation.driveAt(-1.0), 0.0);
    EXPECT_EQ(excitation.driveAt(0.1), 0.4);
    EXPECT_EQ(excitation.driveAt(0.24), 0.4);
    EXPECT_EQ(excitation.driveAt(0.3), 1.0);
    EXPECT_EQ(excitation.driveAt(0.5), 0.0);
}

TEST(Excitation, standardOneBeginsAndEndsAtRestAndReachesTheFullDrive) {
    const Excitation excitation = motors::stairsAndPulses();
    EXPECT_EQ(excitation.steps.front().drive, 0.0);
    EXPECT_EQ(excitation.steps.back().drive, 0.0);
    EXPECT_EQ(std::ranges::max(excitation.steps, {}, &Excitation::Step::drive).drive, 1.0);
    // The heat of a motor stays below half of what it bears (limits of the player: 30 s, budget 0.5).
    double heat = 0.0;
    double highest = 0.0;
    for (double t_s = 0.0; t_s < excitation.duration_s; t_s += 0.001) {
        heat += (excitation.driveAt(t_s) * excitation.driveAt(t_s) - heat) * 0.001 / 30.0;
        highest = std::max(highest, heat);
    }
    EXPECT_LT(highest, 0.25);
}

TEST(Excitation, isWrittenForASensorOfOnesOwn) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(motors::writeExcitation(shortOne(), 10.0, folder.path("e.csv")));
    EXPECT_EQ(test::readAll(folder.path("e.csv")), "time_s,commanded\n0,0\n0.1,0.4\n0.2,0.4\n0.3,1\n0.4,0\n");
}

// In real time, half a second: the player's thread, the device's and the recorder's work together.
TEST_F(ExcitationRunTest, recordsTheDriveThatWasWrittenAndTheSpeedOfThatMotor) {
    make(simulated::unequalMotors());
    m_player->setRanges({{{0.5, 1}, {0.5, 1}, {0.5, 1}, {0.5, 1}, {0.5, 1}, {0.5, 1}}});
    auto recording = record(shortOne());
    // The shortest step lasts 0.15 s and may be missing if there is a gap of that length; then the
    // measurement is repeated.
    for (int more = 0; more < 50 && recording && longestHole_s(*recording) > 0.05; ++more)
        recording = record(shortOne());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_GT(recording->size(), 20U);
    EXPECT_TRUE(motors::checkMotorRecording(*recording));
    EXPECT_EQ(*std::ranges::max_element(recording->drive), 1.0);
    const bool hasStair = std::ranges::any_of(
        recording->drive, [](double drive) { return std::abs(drive - 0.4) < 1.0 / core::kFullDrive; });
    EXPECT_TRUE(hasStair) << "raw: not mapped by the range of the motor";
    EXPECT_GT(*std::ranges::max_element(recording->speed_Hz), 150.0);
    EXPECT_GT(m_progress, 0.5);
}

TEST_F(ExcitationRunTest, isRefusedWithoutASensor) {
    make(std::nullopt);
    const auto recording = record(shortOne());
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().kind, core::ErrorKind::unavailable);
}

TEST_F(ExcitationRunTest, endsWithStopAndSaysSo) {
    make(simulated::unequalMotors());
    m_stop.engage();
    const auto recording = record(motors::stairsAndPulses());
    ASSERT_FALSE(recording);
    EXPECT_NE(recording.error().message.find("STOP"), std::string::npos) << recording.error().message;
}

TEST_F(ExcitationRunTest, endsWhenItIsAskedToAndStopsTheMotor) {
    make(simulated::unequalMotors());
    std::stop_source source;
    source.request_stop();
    const auto recording = record(motors::stairsAndPulses(), source.get_token());
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().kind, core::ErrorKind::cancelled);
    ASSERT_TRUE(
        test::eventually(m_wakeup, [&] { return m_player->status().mode == playback::PlayerMode::idle; }));
    EXPECT_TRUE(core::isOff(m_bracelet->drive()));
    EXPECT_EQ(m_player->play({}), 1U) << "it was asked before it began: nothing was played";
}

TEST_F(ExcitationRunTest, endsItsOwnProgramWhenItIsAskedTo) {
    make(simulated::unequalMotors());
    std::stop_source source;
    std::jthread asking([&](const std::stop_token& end) {
        while (m_player->status().mode != playback::PlayerMode::program && !end.stop_requested())
            std::this_thread::yield();
        source.request_stop();
    });
    const auto recording = record(motors::stairsAndPulses(), source.get_token());
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().kind, core::ErrorKind::cancelled);
    EXPECT_TRUE(
        test::eventually(m_wakeup, [&] { return m_player->status().mode == playback::PlayerMode::idle; }));
    EXPECT_EQ(m_player->status().ending, playback::PlayerEnding::stopped);
}

TEST_F(ExcitationRunTest, isRefusedWhenSomethingElseIsPlayedInItsPlace) {
    make(simulated::unequalMotors());
    std::jthread other([this](const std::stop_token& end) {
        while (m_player->status().mode != playback::PlayerMode::program && !end.stop_requested())
            std::this_thread::yield();
        m_player->play(motors::programOf(shortOne(), 0));
    });
    const auto recording = record(motors::stairsAndPulses());
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().kind, core::ErrorKind::refused);
    EXPECT_LT(m_progress, 0.5);
}

TEST_F(ExcitationRunTest, endsWhenTheBraceletIsUnplugged) {
    make(simulated::unequalMotors());
    m_bracelet->setFaults({.unplugged = true});
    const auto recording = record(motors::stairsAndPulses());
    ASSERT_FALSE(recording);
    EXPECT_EQ(recording.error().kind, core::ErrorKind::refused);
}
