// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/simulated_player.h"

#include <gtest/gtest.h>

namespace teleta::scene_run {

namespace {

playback::Program full(double duration_s) {
    return {[](double) { return core::Intensities{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }, duration_s};
}

} // namespace

TEST(SimulatedPlayer, beginsWithTheNextFrameAndEndsWithTheProgram) {
    auto player = SimulatedPlayer::open({});
    ASSERT_TRUE(player);
    player->advance(0.1, 0.1);
    player->play(full(0.05));
    EXPECT_FALSE(player->onset_s());
    player->advance(0.101, 0.101);
    EXPECT_FALSE(player->onset_s()); // the next frame is due at 105 ms
    player->advance(0.105, 0.105);
    ASSERT_TRUE(player->onset_s());
    EXPECT_NEAR(*player->onset_s(), 0.105, 1e-9);
    player->advance(0.15, 0.15);
    EXPECT_GT(player->given()[0], 0.0);
    player->advance(0.155, 0.155);
    EXPECT_EQ(player->given()[0], 0.0);
    EXPECT_FALSE(player->isPlaying());
}

TEST(SimulatedPlayer, isOffATenthOfASecondAfterTheArmFellSilentAndStaysOff) {
    auto player = SimulatedPlayer::open({});
    ASSERT_TRUE(player);
    player->play(full(10.0));
    for (int ms = 0; ms <= 600; ms += 5) {
        player->advance(0.001 * ms, 0.2);
        if (ms > 100 && ms <= 300) {
            EXPECT_GT(player->given()[0], 0.0) << ms;
        } else if (ms > 301) {
            EXPECT_EQ(player->given()[0], 0.0) << ms;
        }
    }
    player->advance(0.605, 0.605); // it is back: nothing goes on by itself
    EXPECT_EQ(player->given()[0], 0.0);
}

} // namespace teleta::scene_run
