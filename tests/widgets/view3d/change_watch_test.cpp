// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/change_watch.h"

#include <gtest/gtest.h>

#include <limits>

using teleta::view3d::isSeen;
using teleta::view3d::MovingState;

namespace {

constexpr double kPixelsPerMetre = 500.0;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

MovingState stateOf(const Eigen::Vector3d& point_m, std::vector<float> loads, std::vector<float> shares) {
    return {{Eigen::Vector3d::Zero(), point_m}, std::move(loads), 0.2F, std::move(shares)};
}

const MovingState kBefore = stateOf({0.3, 0.0, 0.1}, {0.0F, 0.5F, kNaN}, {0.4F});

} // namespace

TEST(ChangeWatch, whatIsTheSameIsNotSeen) {
    EXPECT_FALSE(isSeen(kBefore, kBefore, kPixelsPerMetre));
    EXPECT_FALSE(isSeen({}, {}, kPixelsPerMetre));
}

TEST(ChangeWatch, aPointIsSeenToMoveByHalfAPixel) {
    // 1 mm is half a pixel.
    const auto movedTo = [](double x_m) { return stateOf({x_m, 0.0, 0.1}, kBefore.loads, kBefore.shares); };
    EXPECT_FALSE(isSeen(kBefore, movedTo(0.3009), kPixelsPerMetre));
    EXPECT_TRUE(isSeen(kBefore, movedTo(0.3011), kPixelsPerMetre));
    EXPECT_TRUE(isSeen(kBefore, movedTo(0.3009), 2.0 * kPixelsPerMetre)) << "nearer";
}

TEST(ChangeWatch, aLoadIsSeenToChangeByMoreThanNoise) {
    const auto loaded = [](float load) {
        return stateOf(kBefore.points_m[1], {0.0F, load, kNaN}, kBefore.shares);
    };
    EXPECT_FALSE(isSeen(kBefore, loaded(0.35F), kPixelsPerMetre));
    EXPECT_TRUE(isSeen(kBefore, loaded(0.75F), kPixelsPerMetre));
    MovingState precise = loaded(0.505F);
    precise.leastLoad = 0.0F;
    EXPECT_FALSE(isSeen(kBefore, precise, kPixelsPerMetre)) << "less than a hundredth";
    precise.loads[1] = 0.52F;
    EXPECT_TRUE(isSeen(kBefore, precise, kPixelsPerMetre));
}

TEST(ChangeWatch, aTaxelIsSeenToDieAndToLive) {
    EXPECT_TRUE(
        isSeen(kBefore, stateOf(kBefore.points_m[1], {kNaN, 0.5F, kNaN}, kBefore.shares), kPixelsPerMetre));
    EXPECT_TRUE(
        isSeen(kBefore, stateOf(kBefore.points_m[1], {0.0F, 0.5F, 0.0F}, kBefore.shares), kPixelsPerMetre));
}

TEST(ChangeWatch, anArrowIsSeenToChangeByAHundredth) {
    EXPECT_FALSE(isSeen(kBefore, stateOf(kBefore.points_m[1], kBefore.loads, {0.405F}), kPixelsPerMetre));
    EXPECT_TRUE(isSeen(kBefore, stateOf(kBefore.points_m[1], kBefore.loads, {0.42F}), kPixelsPerMetre));
}

TEST(ChangeWatch, otherThingsAreSeen) {
    MovingState more = kBefore;
    more.points_m.emplace_back(Eigen::Vector3d::Zero());
    EXPECT_TRUE(isSeen(kBefore, more, kPixelsPerMetre));
    EXPECT_TRUE(isSeen(more, kBefore, kPixelsPerMetre));
    EXPECT_TRUE(isSeen(kBefore, stateOf(kBefore.points_m[1], {}, kBefore.shares), kPixelsPerMetre));
    EXPECT_TRUE(isSeen(kBefore, stateOf(kBefore.points_m[1], kBefore.loads, {}), kPixelsPerMetre));
}
