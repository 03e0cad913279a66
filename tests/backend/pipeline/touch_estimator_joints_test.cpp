// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/touch_estimator.h"
#include "tests/backend/pipeline/scripted_arm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

using namespace teleta;
using pipeline::TouchEstimator;
using pipeline::TouchRecord;
using test::paperArm;
using test::ScriptedArm;

TEST(TouchEstimator, watchesAnArmOfSevenJointsButDoesNotLocateItsTouches) {
    core::ArmDescription description = paperArm();
    description.lowest_rad = description.highest_rad = description.fastest_radPerS =
        core::JointVector::zeros(7);
    TouchEstimator estimator(description);
    std::optional<TouchRecord> record;
    for (int i = 1; i <= 1900; ++i) {
        core::JointSample sample;
        sample.time_ns = i * 1'000'000;
        sample.sourceTime_s = 1e-3 * i;
        sample.angle_rad = sample.torque_Nm = sample.reference_rad = core::JointVector::zeros(7);
        sample.torque_Nm[5] = std::clamp(1e-3 * (i - 100), 0.0, 0.5);
        if (auto made = estimator.update(sample))
            record = made;
    }
    ASSERT_TRUE(record);
    EXPECT_EQ(record->joint, 5U);
    EXPECT_EQ(record->joints, 7U);
    EXPECT_NEAR(record->torque_Nm, 0.5, 1e-3);
    EXPECT_FALSE(record->located || record->force || record->stiffness);
    EXPECT_EQ(estimator.phases()[5], stiffness::ContactPhase::contact);
    EXPECT_EQ(estimator.phases()[3], stiffness::ContactPhase::free);
    EXPECT_FALSE(estimator.update(ScriptedArm().next(0.0)));
    EXPECT_EQ(estimator.samplesLeftOut(), 1U) << "a sample of four joints";
}
