// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/arm_plans.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::arm_servo {
namespace {

TEST(ArmPlans, allPassTheCheckOfTheControllerWhateverTheForce) {
    for (const ArmTask task : kArmTasks)
        for (const double force_N :
             {-1.0, 0.0, 0.5, 3.0, 15.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
            const servo::ServoPlan plan = armPlan(task, force_N);
            EXPECT_TRUE(servo::check(plan)) << plan.name << ' ' << force_N;
            EXPECT_EQ(plan.tasks.front().kind, servo::TaskKind::freeMotion);
            EXPECT_GT(plan.tasks.size(), 1U);
        }
}

TEST(ArmPlans, theForceOfEachTaskInContactIsTheOneThatIsWanted) {
    for (const ArmTask task : kArmTasks)
        for (const servo::ServoTask& each : armPlan(task, 4.0).tasks)
            if (each.needsContact) {
                EXPECT_DOUBLE_EQ(each.desired.force_N, 4.0);
            }
}

TEST(ArmPlans, theUsualForceIsEnoughForEachTaxelOfAnEdgeBetweenTwoRows) {
    // 14 taxels in each of two rows, 0.2 N each to be active.
    EXPECT_GT(usualForce_N(ArmTask::explore) / 28, 0.2);
    for (const ArmTask task : kArmTasks) {
        EXPECT_GE(usualForce_N(task), kLeastForce_N);
        EXPECT_LE(usualForce_N(task), kHighestForce_N);
    }
}

TEST(ArmPlans, aContactOfMoreTaxelsIsHarder) {
    EXPECT_DOUBLE_EQ(contactCompliance_mPerN(1), 0.5 / 1200.0);
    EXPECT_DOUBLE_EQ(contactCompliance_mPerN(14), 0.5 / 16800.0);
    EXPECT_DOUBLE_EQ(contactCompliance_mPerN(0), contactCompliance_mPerN(1));
    EXPECT_DOUBLE_EQ(contactCompliance_mPerN(-3), contactCompliance_mPerN(1));
}

} // namespace
} // namespace teleta::arm_servo
