// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/pad_arm.h"
#include "tests/backend/arm_servo/servo_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace teleta::arm_servo {
namespace {

using core::JointVector;
using servo::Twist;
using test::kLookingDown_rad;

class PadArmTest : public ::testing::Test {
protected:
    std::shared_ptr<const arm_model::SerialChain> chain =
        teleta::test::chainOf("resources/arms/seven-joints.urdf");
    core::ArmDescription description = test::armWithPad(*chain);
    std::shared_ptr<const PadArm> arm = *PadArm::create(chain, description, *description.pad);

    static JointVector moved(const JointVector& q_rad, const JointVector& rate, double dt_s) {
        JointVector there_rad = q_rad;
        for (std::size_t i = 0; i < there_rad.size(); ++i)
            there_rad[i] += dt_s * rate[i];
        return there_rad;
    }
};

TEST_F(PadArmTest, theRatesMoveThePadAsTheTwistSays) {
    Twist wanted;
    wanted << 0.01, -0.02, 0.005, 0.03, 0.02, -0.04;
    const servo::SensorMotion motion = arm->carryOut(kLookingDown_rad, wanted);
    EXPECT_FALSE(motion.isLimited());
    EXPECT_LT((motion.achieved - wanted).norm(), 1e-12);
    // The kinematics alone say the same, by a difference of poses.
    constexpr double kStep_s = 1e-5;
    const Eigen::Isometry3d before = arm->X_Base_Sensor(moved(kLookingDown_rad, motion.rate, -kStep_s));
    const Eigen::Isometry3d after = arm->X_Base_Sensor(moved(kLookingDown_rad, motion.rate, kStep_s));
    EXPECT_LT(((after.translation() - before.translation()) / (2 * kStep_s) - wanted.head<3>()).norm(), 1e-8);
    const Eigen::Vector3d turn = servo::logSO3(after.linear() * before.linear().transpose()) / (2 * kStep_s);
    EXPECT_LT((turn - wanted.tail<3>()).norm(), 1e-8);
}

TEST_F(PadArmTest, allJointsAreSlowedDownTogether) {
    Twist wanted = Twist::Zero();
    wanted[0] = 0.02;
    const servo::SensorMotion slow = arm->carryOut(kLookingDown_rad, wanted);
    const servo::SensorMotion fast = arm->carryOut(kLookingDown_rad, 1000.0 * wanted);
    ASSERT_FALSE(slow.slowed);
    ASSERT_TRUE(fast.slowed);
    double most = 0.0;
    for (std::size_t i = 0; i < 7; ++i)
        most = std::max(most, std::abs(slow.rate[i]) / description.fastest_radPerS[i]);
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_NEAR(fast.rate[i], slow.rate[i] / most, 1e-9);
}

TEST_F(PadArmTest, noJointMovesOnTowardsAnEndAndAllMayMoveBack) {
    Twist wanted = Twist::Zero();
    wanted[0] = 0.02;
    const JointVector rate = arm->carryOut(kLookingDown_rad, wanted).rate;
    ASSERT_NE(rate[3], 0.0);
    double& end = (rate[3] > 0.0 ? description.highest_rad : description.lowest_rad)[3];
    end = kLookingDown_rad[3] + (rate[3] > 0.0 ? 0.01 : -0.01);
    const auto bounded = *PadArm::create(chain, description, *description.pad);
    const servo::SensorMotion held = bounded->carryOut(kLookingDown_rad, wanted);
    EXPECT_TRUE(held.atEnd);
    EXPECT_EQ(held.rate, JointVector::zeros(7));
    EXPECT_EQ(held.achieved, Twist::Zero());
    const servo::SensorMotion back = bounded->carryOut(kLookingDown_rad, -wanted);
    EXPECT_FALSE(back.atEnd);
    EXPECT_NEAR(back.rate[3], -rate[3], 1e-12);
}

TEST_F(PadArmTest, aLinkThatTheArmDoesNotHaveAndOtherLimitsAreRefused) {
    core::PadPlacement elsewhere = *description.pad;
    elsewhere.link = "no_such_link";
    const auto noLink = PadArm::create(chain, description, elsewhere);
    ASSERT_FALSE(noLink);
    EXPECT_EQ(noLink.error().kind, core::ErrorKind::notFound);
    core::ArmDescription four = description;
    four.lowest_rad = four.highest_rad = four.fastest_radPerS = JointVector::zeros(4);
    const auto otherArm = PadArm::create(chain, four, *description.pad);
    ASSERT_FALSE(otherArm);
    EXPECT_EQ(otherArm.error().kind, core::ErrorKind::badInput);
}

} // namespace
} // namespace teleta::arm_servo
