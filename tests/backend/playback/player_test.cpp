// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/player.h"
#include "tests/backend/playback/scripted_bracelet.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>

using namespace teleta;
using core::isOff;
using playback::Player;
using playback::PlayerConfig;
using playback::PlayerEnding;
using playback::PlayerMode;
using test::all;
using test::ManualClock;
using test::ScriptedBracelet;

namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Frames = std::vector<ScriptedBracelet::Written>;

bool lastIsOff(const Frames& frames) {
    return !frames.empty() && isOff(frames.back().frame.drive);
}
bool lastDrives(const Frames& frames) {
    return !frames.empty() && !isOff(frames.back().frame.drive);
}

PlayerConfig freeConfig(std::shared_ptr<core::PacingClock> clock) {
    return {.limits = {.rise_perS = kInfinity, .heatBudget = 1.0}, .clock = std::move(clock)};
}

} // namespace

TEST(Player, playsOnItsThreadWhenTheClockSaysSo) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    player.play({[](double) { return all(0.5); }, 0.05});
    ASSERT_TRUE(bracelet.waitFor(lastDrives));
    for (int i = 0; i < 9; ++i)
        clock->advance(5 * kMs_ns);
    EXPECT_EQ(bracelet.written().size(), 10U);
    clock->advance(5 * kMs_ns);
    EXPECT_EQ(bracelet.written().size(), 11U);
    EXPECT_TRUE(lastIsOff(bracelet.written()));
    EXPECT_EQ(player.status().ending, PlayerEnding::finished);
    EXPECT_EQ(player.counters().framesWritten, 10U);
    EXPECT_EQ(player.counters().deadlineMisses, 0U);
}

TEST(Player, zeroesOneCycleAfterSTOP) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    player.play({[](double) { return all(0.5); }, kInfinity});
    ASSERT_TRUE(bracelet.waitFor(lastDrives));
    clock->settle();
    stop.engage();
    const std::size_t before = bracelet.written().size();
    clock->advance(5 * kMs_ns);
    const Frames frames = bracelet.written();
    ASSERT_EQ(frames.size(), before + 1);
    EXPECT_TRUE(lastIsOff(frames));
    EXPECT_EQ(player.status().ending, PlayerEnding::stopSwitch);
}

TEST(Player, zeroesWithoutWaitingWhenStopped) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    player.play({[](double) { return all(0.5); }, kInfinity});
    ASSERT_TRUE(bracelet.waitFor(lastDrives));
    player.stop();
    EXPECT_TRUE(bracelet.waitFor(lastIsOff)) << "although the clock stands still";
}

TEST(Player, zeroesWhenItIsDestroyed) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    {
        Player player(bracelet, stop, freeConfig(clock));
        player.play({[](double) { return all(0.5); }, kInfinity});
        ASSERT_TRUE(bracelet.waitFor(lastDrives));
    }
    EXPECT_TRUE(lastIsOff(bracelet.written()));
}

TEST(Player, followsASetpointThatIsPostedJustAfterLiveWasAsked) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    player.post(all(1.0), clock->now_ns());
    player.startLive();
    ASSERT_TRUE(bracelet.waitFor([](const Frames& frames) { return !frames.empty(); }));
    EXPECT_TRUE(lastIsOff(bracelet.written())) << "what was posted before does not count";
    player.post(all(0.5), clock->now_ns());
    EXPECT_TRUE(bracelet.waitFor(lastDrives)) << "without waiting for the next deadline";
    EXPECT_EQ(bracelet.written().back().frame.drive[0], 2047);
}

TEST(Player, stopsForGoodWhenCommandsComeInARow) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    player.play({[](double) { return all(0.5); }, kInfinity});
    ASSERT_TRUE(bracelet.waitFor(lastDrives));
    player.play({[](double) { return all(1.0); }, kInfinity});
    player.seek(0.5);
    player.setLoop(true);
    player.stop();
    ASSERT_TRUE(bracelet.waitFor(lastIsOff));
    clock->settle();
    clock->advance(100 * kMs_ns);
    EXPECT_TRUE(lastIsOff(bracelet.written()));
    EXPECT_EQ(player.status().mode, PlayerMode::idle);
}

TEST(Player, stopsAProgramByItsNumberAndNothingElse) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    const std::uint64_t first = player.play({[](double) { return all(0.5); }, kInfinity});
    ASSERT_TRUE(bracelet.waitFor(lastDrives));
    const std::uint64_t second = player.play({[](double) { return all(1.0); }, kInfinity});
    const auto drivesFully = [](const Frames& frames) {
        return !frames.empty() && frames.back().frame.drive[0] == core::kFullDrive;
    };
    ASSERT_TRUE(bracelet.waitFor(drivesFully));
    player.stop(first);
    clock->settle();
    clock->advance(5 * kMs_ns);
    EXPECT_TRUE(drivesFully(bracelet.written())) << "another one is played by now";
    EXPECT_EQ(player.status().mode, PlayerMode::program);
    player.stop(second);
    ASSERT_TRUE(bracelet.waitFor(lastIsOff));
    clock->settle();
    EXPECT_EQ(player.status().ending, PlayerEnding::stopped);
    EXPECT_EQ(player.status().program, second);

    player.stop(player.play({[](double) { return all(1.0); }, kInfinity}));
    clock->settle();
    clock->advance(100 * kMs_ns);
    EXPECT_TRUE(lastIsOff(bracelet.written()));
    EXPECT_EQ(player.status().mode, PlayerMode::idle);
}

TEST(Player, appliesLimitsWhilePlaying) {
    const auto clock = std::make_shared<ManualClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    Player player(bracelet, stop, freeConfig(clock));
    player.play({[](double) { return all(1.0); }, kInfinity});
    ASSERT_TRUE(bracelet.waitFor(lastDrives));
    player.setLimits({.userLimit = all(0.25), .rise_perS = kInfinity, .heatBudget = 1.0});
    clock->settle();
    for (int i = 0; i < 3; ++i)
        clock->advance(5 * kMs_ns);
    ASSERT_TRUE(bracelet.waitFor([](const Frames& frames) { return frames.back().frame.drive[0] == 1023; }));
}

// The real clock: many threads post, one commands, frames go on.
TEST(Player, survivesPostsAndCommandsFromManyThreads) {
    const auto clock = std::make_shared<core::PacingClock>();
    core::StopSwitch stop;
    ScriptedBracelet bracelet(clock);
    {
        Player player(bracelet, stop, freeConfig(clock));
        player.startLive();
        std::vector<std::jthread> posters;
        for (int thread = 0; thread < 3; ++thread)
            posters.emplace_back([&] {
                for (int i = 0; i < 5000; ++i)
                    player.post(all(0.5), core::steadyNow_ns());
            });
        for (int i = 0; i < 200; ++i) {
            if (i % 3 == 0)
                player.play({[](double) { return all(0.25); }, 0.01}, i % 2 == 0);
            else
                player.startLive();
            (void)player.status();
            (void)player.counters();
        }
        posters.clear();
        player.startLive();
        bracelet.forget();
        ASSERT_TRUE(bracelet.waitFor([&](const Frames& frames) {
            player.post(all(0.5), core::steadyNow_ns());
            return lastDrives(frames);
        }));
    }
    EXPECT_TRUE(lastIsOff(bracelet.written()));
}
