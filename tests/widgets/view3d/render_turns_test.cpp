// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/render_turns.h"

#include <gtest/gtest.h>

#include <algorithm>

using teleta::view3d::RenderTurns;

namespace {

constexpr std::int64_t kMs = 1'000'000;

/// A view that says how long its drawing takes.
struct FakeView {
    std::int64_t drawing_ns = 0;
    int drawn = 0;
    std::int64_t last_ns = 0;
};

/// Runs both views for a second of a clock of its own, each asking every tick of 33 ms; returns the time
/// spent in drawing.
std::int64_t runASecond(RenderTurns& turns, FakeView& one, FakeView& other) {
    std::int64_t now = 0;
    std::int64_t drawing = 0;
    std::int64_t tick = 0;
    while (now < 1000 * kMs) {
        while (tick <= now) {
            turns.ask(&one);
            turns.ask(&other);
            tick += 33 * kMs;
        }
        if (auto* view = static_cast<FakeView*>(turns.next(now))) {
            const std::int64_t begun = now;
            now += view->drawing_ns;
            drawing += view->drawing_ns;
            view->last_ns = begun;
            ++view->drawn;
            turns.drawn(view, begun, now);
        } else {
            const auto turn = turns.nextTurn_ns();
            now = turn ? std::min(*turn, tick) : tick;
        }
    }
    return drawing;
}

} // namespace

TEST(RenderTurns, ViewsThatDrawFastDrawInEveryTick) {
    RenderTurns turns;
    FakeView one{2 * kMs};
    FakeView other{3 * kMs};
    runASecond(turns, one, other);
    EXPECT_EQ(one.drawn, 31); // ticks at 0, 33, ..., 990 ms
    EXPECT_EQ(other.drawn, 31);
}

TEST(RenderTurns, ViewsThatDrawSlowlyShareAThirdOfTheTimeAndNeitherStarves) {
    RenderTurns turns;
    FakeView one{40 * kMs};
    FakeView other{20 * kMs};
    const std::int64_t drawing = runASecond(turns, one, other);
    // (40 + 80) + (20 + 40) ms a round.
    EXPECT_LE(drawing, 1000 * kMs / 3 + 40 * kMs);
    EXPECT_GE(drawing, 1000 * kMs / 3 - 40 * kMs);
    EXPECT_NEAR(one.drawn, other.drawn, 1);
    EXPECT_GE(other.drawn, 5);
}

TEST(RenderTurns, TwoSlowViewsThatAskTogetherDoNotDrawTogether) {
    RenderTurns turns;
    FakeView one;
    FakeView other;
    turns.drawn(&one, 0, 40 * kMs);
    turns.ask(&one);
    turns.ask(&other);
    turns.ask(&one);
    EXPECT_EQ(turns.nextTurn_ns(), 120 * kMs);
    EXPECT_EQ(turns.next(120 * kMs - 1), nullptr);
    EXPECT_EQ(turns.next(120 * kMs), &one);
    EXPECT_EQ(turns.next(120 * kMs), nullptr);
    turns.drawn(&one, 121 * kMs, 161 * kMs);
    EXPECT_EQ(turns.next(240 * kMs), nullptr);
    EXPECT_EQ(turns.next(241 * kMs), &other);
    EXPECT_EQ(turns.nextTurn_ns(), std::nullopt);
}

TEST(RenderTurns, AViewThatDoesNotDrawInItsTurnHoldsNobodyUp) {
    RenderTurns turns;
    FakeView one;
    FakeView other;
    turns.drawn(&one, 0, 10 * kMs);
    turns.ask(&one);
    turns.ask(&other);
    EXPECT_EQ(turns.next(30 * kMs), &one);
    EXPECT_EQ(turns.nextTurn_ns(), 60 * kMs);
    EXPECT_EQ(turns.next(60 * kMs), &other);
}

TEST(RenderTurns, AViewThatIsGoneOrHasDrawnOtherwiseHasNoTurn) {
    RenderTurns turns;
    FakeView one;
    FakeView other;
    turns.ask(&one);
    turns.ask(&other);
    turns.leave(&one);
    turns.drawn(&other, 0, kMs);
    EXPECT_EQ(turns.next(1000 * kMs), nullptr);
}

TEST(RenderTurns, AfterAMachineThatStoodStillTheViewIsBackWithinTheLongestPause) {
    RenderTurns turns;
    FakeView one;
    turns.drawn(&one, 0, 3000 * kMs);
    turns.ask(&one);
    EXPECT_EQ(turns.nextTurn_ns(), 3000 * kMs + RenderTurns::kLongestPause_ns);
}
