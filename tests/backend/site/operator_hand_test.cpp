// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site/operator_hand.h"

#include <gtest/gtest.h>

namespace teleta::site {
namespace {

using Send = OperatorHand::Send;

constexpr std::int64_t kMs = 1'000'000;

TEST(OperatorHand, saysNothingBeforeTheFirstPress) {
    OperatorHand hand;
    hand.post(false, 0);
    EXPECT_EQ(hand.step(0), Send::nothing);
    EXPECT_EQ(hand.press(), 0U);
}

TEST(OperatorHand, aSwitchThatIsLetGoIsSaidFiveTimes) {
    OperatorHand hand;
    hand.post(true, 0);
    EXPECT_EQ(hand.step(0), Send::move);
    hand.post(false, 20 * kMs);
    for (int i = 0; i < OperatorHand::kHolds; ++i)
        EXPECT_EQ(hand.step((20 + 20 * i) * kMs), Send::hold);
    EXPECT_EQ(hand.step(200 * kMs), Send::nothing);
}

TEST(OperatorHand, aViewThatHangsLetsGo) {
    OperatorHand hand;
    hand.post(true, 0);
    EXPECT_EQ(hand.step(OperatorHand::kLifetime_ns), Send::move);
    EXPECT_EQ(hand.step(OperatorHand::kLifetime_ns + 1), Send::hold);
    // The switch is still held when the view goes on: that is no other press.
    hand.post(true, 150 * kMs);
    EXPECT_EQ(hand.press(), 1U);
    EXPECT_EQ(hand.step(150 * kMs), Send::move);
    hand.post(false, 160 * kMs);
    hand.post(true, 170 * kMs);
    EXPECT_EQ(hand.press(), 2U);
}

TEST(OperatorHand, aSilenceThatNobodySawIsNoPressEither) {
    OperatorHand hand;
    hand.post(true, 0);
    hand.post(true, 50 * kMs + OperatorHand::kLifetime_ns + 1);
    EXPECT_EQ(hand.press(), 1U);
}

TEST(OperatorHand, aSwitchThatIsHeldThroughStopMovesNothingUntilItIsLetGo) {
    OperatorHand hand;
    hand.post(true, 0);
    EXPECT_EQ(hand.step(kMs), Send::move);
    hand.stop();
    EXPECT_EQ(hand.step(20 * kMs), Send::hold);
    // The view has not seen the STOP and goes on.
    hand.post(true, 40 * kMs);
    EXPECT_EQ(hand.step(40 * kMs), Send::hold);
    for (int i = 0; i < OperatorHand::kHolds; ++i)
        (void)hand.step(60 * kMs);
    hand.post(true, 80 * kMs);
    EXPECT_EQ(hand.step(80 * kMs), Send::nothing);
    EXPECT_EQ(hand.press(), 1U);
    hand.post(false, 100 * kMs);
    hand.post(true, 120 * kMs);
    EXPECT_EQ(hand.step(120 * kMs), Send::move);
    EXPECT_EQ(hand.press(), 2U);
}

TEST(OperatorHand, aSwitchThatIsPressedDuringStopMovesNothingAfterIt) {
    OperatorHand hand;
    hand.stop();
    hand.post(true, kMs);
    hand.stop();
    hand.post(true, 20 * kMs);
    EXPECT_EQ(hand.step(20 * kMs), Send::hold);
    hand.post(false, 40 * kMs);
    hand.post(true, 60 * kMs);
    EXPECT_EQ(hand.step(60 * kMs), Send::move);
}

TEST(OperatorHand, theFirstPressAfterAStopThatFoundNothingHeldCounts) {
    OperatorHand hand;
    hand.post(true, 0);
    hand.post(false, kMs);
    hand.stop();
    hand.post(true, 20 * kMs);
    EXPECT_EQ(hand.step(20 * kMs), Send::move);
    EXPECT_EQ(hand.press(), 2U);
}

TEST(OperatorHand, aPressEndsTheHolds) {
    OperatorHand hand;
    hand.post(true, 0);
    hand.post(false, kMs);
    EXPECT_EQ(hand.step(2 * kMs), Send::hold);
    hand.post(true, 3 * kMs);
    EXPECT_EQ(hand.step(20 * kMs), Send::move);
    EXPECT_EQ(hand.press(), 2U);
}

} // namespace
} // namespace teleta::site
