// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/playback_command_box.h"
#include "tests/devices/manual_clock.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

using namespace teleta;
using replay::PlaybackCommandBox;
using replay::PlaybackCommands;

namespace {

class PlaybackCommandBoxTest : public testing::Test {
protected:
    [[nodiscard]] core::PlaybackPosition position() const {
        core::PlaybackPosition position;
        position.target_s = m_box.describe(position).value_or(-1.0);
        return position;
    }

    std::shared_ptr<test::ManualClock> m_clock = std::make_shared<test::ManualClock>();
    PlaybackCommandBox m_box{m_clock, true, false, 1.0};
};

} // namespace

TEST_F(PlaybackCommandBoxTest, handsOutSeeksAndStepsOnce) {
    m_box.seek(2.0);
    m_box.step(3);
    PlaybackCommands commands = m_box.take();
    EXPECT_EQ(commands.seek_s, 2.0);
    EXPECT_EQ(commands.steps, 3);
    EXPECT_FALSE(commands.playing) << "a step pauses";
    EXPECT_EQ(commands.at_ns, m_clock->now_ns());
    commands = m_box.take();
    EXPECT_FALSE(commands.seek_s);
    EXPECT_EQ(commands.steps, 0);
}

TEST_F(PlaybackCommandBoxTest, aSeekReplacesEarlierSeeksAndSteps) {
    m_box.seek(1.0);
    m_box.step(5);
    m_box.seek(-3.0);
    m_box.seek(std::nan(""));
    const PlaybackCommands commands = m_box.take();
    EXPECT_EQ(commands.seek_s, 0.0);
    EXPECT_EQ(commands.steps, 0);
}

TEST_F(PlaybackCommandBoxTest, tellsOfASeekUntilItIsTaken) {
    EXPECT_FALSE(m_box.isSeekWaiting());
    m_box.seek(4.0);
    EXPECT_TRUE(m_box.isSeekWaiting());
    EXPECT_EQ(position().target_s, 4.0);
    (void)m_box.take();
    EXPECT_FALSE(m_box.isSeekWaiting());
    EXPECT_EQ(position().target_s, 4.0) << "it is being carried out";
    (void)m_box.take();
    EXPECT_EQ(position().target_s, -1.0);
}

TEST_F(PlaybackCommandBoxTest, limitsTheSpeed) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::array<std::array<double, 2>, 4> cases{
        {{1000.0, 100.0}, {0.0, 0.01}, {-kInfinity, 0.01}, {kInfinity, kInfinity}}};
    for (const auto& [asked, allowed] : cases) {
        m_box.setSpeed(asked);
        m_box.setSpeed(std::nan(""));
        EXPECT_EQ(m_box.take().speed, allowed);
    }
}

TEST_F(PlaybackCommandBoxTest, startsAtTheBeginningAndStopsPlayingAtTheEnd) {
    m_box.begin(true);
    EXPECT_EQ(m_box.take().seek_s, 0.0);
    EXPECT_FALSE(position().paused);
    m_box.end();
    EXPECT_TRUE(position().paused);
}
