// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/servo_tuning.h"

#include <gtest/gtest.h>

#include <limits>

using namespace teleta::servo;

TEST(ServoTuning, tuningAPlanToWhatItIsChangesNothing) {
    for (const ServoPlan& plan : {explorePlan(4.0, 0.003), explorePlan(5.0, 0.005, false),
                                  comanipulationPlan(), rollPlan(), pointPlan()}) {
        const ServoPlan same = tuned(plan, tuningOf(plan));
        for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
            EXPECT_LE((same.tasks[i].gains.proportional - plan.tasks[i].gains.proportional).norm(), 1e-15);
            EXPECT_EQ(same.tasks[i].gains.integral, plan.tasks[i].gains.integral);
            EXPECT_EQ(same.tasks[i].desired.force_N, plan.tasks[i].desired.force_N);
            // Only the edge control of phase III has the moment in the baseline.
            if (plan.name != "explore_baseline") {
                EXPECT_EQ(same.tasks[i].projection, plan.tasks[i].projection) << plan.name << ' ' << i;
            }
        }
    }
}

TEST(ServoTuning, forceSpeedGainAndMomentReachTheTasks) {
    const ServoPlan plan = explorePlan();
    const ServoPlan other = tuned(plan, {.force_N = 8.0, .slide_mPerS = 0.010, .gain = 0.5, .moment = false});
    for (std::size_t i = 1; i < plan.tasks.size(); ++i) {
        EXPECT_EQ(other.tasks[i].desired.force_N, 8.0);
        EXPECT_DOUBLE_EQ(other.tasks[i].gains.proportional[kZ], 0.5 * plan.tasks[i].gains.proportional[kZ]);
    }
    EXPECT_EQ(other.tasks[0].feedForward.constant_Sensor, plan.tasks[0].feedForward.constant_Sensor);
    // At a centre of pressure of 0 the sensor slides with K_x (desired - 0).
    EXPECT_DOUBLE_EQ(other.tasks[3].gains.proportional[kX] * other.tasks[3].desired.copX_m, 0.010);
    EXPECT_FALSE(other.tasks[3].projection.wy);
    EXPECT_TRUE(other.tasks[1].projection.wy) << "phase II aligns without it";
}

TEST(ServoTuning, aPlanMayGoBeyondTheUsualBoundsAndIsNotCutBackByAnotherWish) {
    const ServoPlan plan = explorePlan(25.0, 0.08);
    const TuningBounds bounds = boundsOf(plan);
    EXPECT_EQ(bounds.highestForce_N, 25.0);
    EXPECT_DOUBLE_EQ(bounds.highestSlide_mPerS, 0.08);
    EXPECT_EQ(bounds.leastForce_N, ServoTuning::kLeastForce_N);
    ServoTuning wish = tuningOf(plan);
    wish.gain = 0.5;
    const ServoPlan softer = tuned(plan, wish);
    EXPECT_EQ(softer.tasks[3].desired.force_N, 25.0);
    EXPECT_DOUBLE_EQ(softer.tasks[3].gains.proportional[kX] * softer.tasks[3].desired.copX_m, 0.08);
    wish.force_N = 28.0;
    EXPECT_EQ(tuned(plan, wish).tasks[3].desired.force_N, 25.0);
    EXPECT_EQ(boundsOf(pointPlan(0.3)).leastForce_N, 0.3);
    EXPECT_EQ(boundsOf(explorePlan()), TuningBounds{});
}

TEST(ServoTuning, whateverIsWishedStaysGood) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double wish : {-1e9, -1.0, 0.0, 1e-9, 1.0, 100.0, 1e300, nan, infinity, -infinity})
        for (const ServoPlan& plan : {explorePlan(), comanipulationPlan(), rollPlan(), pointPlan()})
            EXPECT_TRUE(check(tuned(plan, {wish, wish, wish, true})).has_value()) << wish << ' ' << plan.name;
    EXPECT_EQ(clamped({1e9, 1e9, 1e9, true}),
              (ServoTuning{ServoTuning::kHighestForce_N, ServoTuning::kHighestSlide_mPerS,
                           ServoTuning::kHighestGain, true}));
    EXPECT_EQ(clamped({nan, nan, nan, true}), ServoTuning{});
}
