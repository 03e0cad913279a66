// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/comparison.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace teleta::pattern;

namespace {

Pattern with(double duration_s, std::size_t tactor, Track track) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    pattern.tracks[tactor] = std::move(track);
    return pattern;
}

} // namespace

TEST(Comparison, ofAPatternWithItselfIsZero) {
    for (const Pattern& pattern : builtInPatterns()) {
        const auto same = compared(pattern, pattern);
        ASSERT_TRUE(same);
        EXPECT_EQ(same->rms, 0.0) << pattern.id;
        for (const TactorDifference& tactor : same->tactors)
            EXPECT_EQ(tactor.largest, 0.0) << pattern.id;
    }
}

TEST(Comparison, ofARampWithSilenceIsTheIntegralOfItsSquare) {
    // Integral of t^2 over [0, 1] is 1/3, over a length of 2 s: rms sqrt(1/6).
    const Pattern ramp = with(2.0, 2, {{0.0, 0.0}, {1.0, 1.0}});
    const auto difference = compared(ramp, with(1.0, 2, {}));
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->duration_s, 2.0);
    EXPECT_EQ(difference->largestTactor, 2);
    EXPECT_DOUBLE_EQ(difference->tactors[2].largest, 1.0);
    EXPECT_DOUBLE_EQ(difference->tactors[2].largestAt_s, 1.0);
    EXPECT_NEAR(difference->tactors[2].rms, std::sqrt(1.0 / 6.0), 1e-12);
    EXPECT_NEAR(difference->rms, std::sqrt(1.0 / 36.0), 1e-12);
    EXPECT_EQ(difference->tactors[1].largest, 0.0);
}

TEST(Comparison, isTheSameTheOtherWayRound) {
    const Pattern& a = *findBuiltIn("shape.A.dynamic");
    const Pattern& b = *findBuiltIn("stiffness.E.dynamic");
    const auto forward = compared(a, b);
    const auto back = compared(b, a);
    ASSERT_TRUE(forward && back);
    EXPECT_DOUBLE_EQ(forward->rms, back->rms);
    EXPECT_DOUBLE_EQ(forward->tactors[0].largest, back->tactors[0].largest);
    EXPECT_GT(forward->rms, 0.0);
}

TEST(Comparison, seesBothSidesOfAStep) {
    // A step up at 0.5 s against a constant: 0.6 apart before it, 0.4 after it.
    const Pattern step = with(1.0, 0, {{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {1.0, 1.0}});
    const Pattern level = with(1.0, 0, {{0.0, 0.6}, {1.0, 0.6}});
    const auto difference = compared(step, level);
    ASSERT_TRUE(difference);
    EXPECT_DOUBLE_EQ(difference->tactors[0].largest, 0.6);
    EXPECT_NEAR(difference->tactors[0].rms, std::sqrt(0.5 * 0.36 + 0.5 * 0.16), 1e-12);
}

TEST(Comparison, ofHoldsAndEasedSegmentsKeepsTheToleranceOfBaking) {
    // (1 - cos(pi t)) / 2 has a mean square of 3/8.
    const Pattern eased = with(1.0, 4, {{0.0, 0.0, Easing::easeInOut}, {1.0, 1.0}});
    const Pattern held = with(1.0, 4, {{0.0, 0.5, Easing::hold}, {1.0, 0.9}});
    const Pattern silent = with(1.0, 4, {});
    const auto sine = compared(eased, silent);
    ASSERT_TRUE(sine);
    EXPECT_NEAR(sine->tactors[4].rms, std::sqrt(3.0 / 8.0), 1e-3);
    const auto level = compared(held, silent);
    ASSERT_TRUE(level);
    EXPECT_NEAR(level->tactors[4].rms, 0.5, 1e-12);
}

TEST(Comparison, ofPatternsWithoutLengthIsZero) {
    const auto nothing = compared(Pattern{}, Pattern{});
    ASSERT_TRUE(nothing);
    EXPECT_EQ(nothing->rms, 0.0);
    EXPECT_EQ(nothing->duration_s, 0.0);
}
