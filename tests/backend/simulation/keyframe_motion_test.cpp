// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/keyframe_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using teleta::scene::Keyframe;
using teleta::simulation::KeyframeMotion;

namespace {

const std::vector<Keyframe> kWander{{1.0, 0.0, 0.0, -0.1, 0.0}, {2.0, 1.0, 0.0, 0.2, 0.5},
                                    {2.5, 3.0, -1.0, 0.2, 1.0}, {4.0, 3.5, -1.5, 0.1, 2.0},
                                    {5.0, 1.0, 2.0, 0.3, 2.5},  {7.0, 0.0, 0.0, -0.1, 3.0}};

} // namespace

TEST(KeyframeMotion, passesThroughEveryKeyframeAndNeverBeyondTwoNeighbours) {
    for (const bool loop : {false, true}) {
        const KeyframeMotion motion(kWander, loop);
        for (std::size_t i = 0; i + 1 < kWander.size(); ++i) {
            const Keyframe& a = kWander[i];
            const Keyframe& b = kWander[i + 1];
            EXPECT_DOUBLE_EQ(motion.at(a.time_s).x_m, a.x_m);
            EXPECT_DOUBLE_EQ(motion.at(a.time_s).angle_rad, a.angle_rad);
            double last = a.x_m;
            for (int k = 0; k <= 100; ++k) {
                const auto pose = motion.at(a.time_s + (b.time_s - a.time_s) * k / 100.0 * (1.0 - 1e-12));
                EXPECT_GE(pose.depth_m, std::min(a.depth_m, b.depth_m) - 1e-12);
                EXPECT_LE(pose.depth_m, std::max(a.depth_m, b.depth_m) + 1e-12);
                // monotone between keyframes
                EXPECT_GE((pose.x_m - last) * (b.x_m - a.x_m), -1e-12);
                last = pose.x_m;
            }
        }
    }
}

TEST(KeyframeMotion, risesFromRestToRestBetweenTwoKeyframes) {
    const KeyframeMotion motion({{1.0, 2.0, 0, 0, 0}, {3.0, 6.0, 0, 0, 0}}, false);
    for (const double s : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0})
        EXPECT_NEAR(motion.at(1.0 + 2.0 * s).x_m, 2.0 + 4.0 * s * s * (3.0 - 2.0 * s), 1e-12);
    EXPECT_EQ(motion.at(-5.0).x_m, 2.0);
    EXPECT_EQ(motion.at(3.0).x_m, 6.0);
    EXPECT_EQ(motion.at(1e9).x_m, 6.0);
}

TEST(KeyframeMotion, isStraightWhereTheKeyframesAre) {
    std::vector<Keyframe> keyframes;
    for (const double t : {0.0, 1.0, 1.5, 3.0, 4.0})
        keyframes.push_back({t, 2.0 * t, 0, 0, 0});
    const KeyframeMotion motion(keyframes, false);
    for (double t = 1.0; t <= 3.0; t += 0.01)
        EXPECT_NEAR(motion.at(t).x_m, 2.0 * t, 1e-12);
}

TEST(KeyframeMotion, hasNoJumpInPositionOrVelocity) {
    const KeyframeMotion motion(kWander, true);
    constexpr double kStep_s = 1e-6;
    // Two neighbouring pieces have the slope of the keyframe in common; it is at most three times a secant.
    for (const double t : {2.0, 2.5, 4.0, 5.0, 7.0}) {
        const double before = (motion.at(t).x_m - motion.at(t - kStep_s).x_m) / kStep_s;
        const double after = (motion.at(t + kStep_s).x_m - motion.at(t).x_m) / kStep_s;
        EXPECT_NEAR(before, after, 1e-3) << t;
    }
}

TEST(KeyframeMotion, repeatsALoopWithThePeriodOfItsKeyframes) {
    const KeyframeMotion motion(kWander, true);
    for (double t = 1.0; t < 7.0; t += 0.07) {
        EXPECT_NEAR(motion.at(t + 6.0).x_m, motion.at(t).x_m, 1e-9);
        EXPECT_NEAR(motion.at(t + 6000.0).depth_m, motion.at(t).depth_m, 1e-9);
    }
    EXPECT_EQ(motion.at(0.0).x_m, 0.0) << "it waits for the first keyframe";
}

TEST(KeyframeMotion, staysAtASingleKeyframe) {
    const KeyframeMotion motion({{2.0, 1.0, 2.0, 3.0, 4.0}}, true);
    for (const double t : {0.0, 2.0, 9.0}) {
        EXPECT_EQ(motion.at(t).y_m, 2.0);
        EXPECT_EQ(motion.at(t).depth_m, 3.0);
    }
}
