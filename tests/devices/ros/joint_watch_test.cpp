// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/joint_watch.h"
#include "tests/backend/ros/joint_message.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::ros_arm {
namespace {

constexpr std::int64_t kMs = 1'000'000;

class Watched {
public:
    std::optional<ros::JoinedJoints> tell(std::vector<double> position, std::int64_t time_ns,
                                          ros::Time stamp = {}, std::vector<std::string> names = {"a", "b"}) {
        ros::JointMessage message{std::move(names), std::move(position)};
        message.stamp = stamp;
        return watch.take(message.message(), time_ns);
    }

    JointWatch watch{{"a", "b"}, "/joint_states", 0.1};
};

TEST(JointWatch, believesOrdinaryStatesInAnyOrder) {
    Watched arm;
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 0, {1, 0}));
    ASSERT_TRUE(arm.tell({1.05, 0.05}, 10 * kMs, {1, 10'000'000}, {"b", "a"}));
    EXPECT_EQ(arm.watch.sampleAt(10 * kMs)->position, core::JointVector(0.05, 1.05));
    EXPECT_FALSE(arm.watch.takeFault());
}

TEST(JointWatch, aPositionThatIsNoNumberIsAFault) {
    Watched arm;
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 0));
    (void)arm.tell({std::numeric_limits<double>::quiet_NaN(), 1.0}, kMs);
    EXPECT_EQ(arm.watch.takeFault(), (ArmFault{ArmFaultKind::notFinite, "/joint_states"}));
    EXPECT_FALSE(arm.watch.takeFault());
}

TEST(JointWatch, aJumpIsAFault) {
    Watched arm;
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 0));
    ASSERT_TRUE(arm.tell({0.0, 1.11}, 10 * kMs));
    EXPECT_EQ(arm.watch.takeFault(), (ArmFault{ArmFaultKind::jumped, "b"}));
    // 10 rad/s for longer is as far as that.
    ASSERT_TRUE(arm.tell({0.49, 1.11}, 60 * kMs));
    EXPECT_FALSE(arm.watch.takeFault());
    // Messages that were held up are read at once; their stamps tell how long the motion took.
    ASSERT_TRUE(arm.tell({0.49, 1.11}, 61 * kMs, {5, 0}));
    (void)arm.watch.takeFault();
    ASSERT_TRUE(arm.tell({0.69, 1.11}, 61 * kMs, {5, 50'000'000}));
    EXPECT_FALSE(arm.watch.takeFault());
    // After a long pause an arm may be anywhere.
    ASSERT_TRUE(arm.tell({3.0, 1.11}, 2000 * kMs, {7, 0}));
    EXPECT_FALSE(arm.watch.takeFault());
}

TEST(JointWatch, stampsThatLeapExcuseNoJump) {
    Watched arm;
    // A gripper's driver tells its joint without a stamp.
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 0, {1'700'000'000, 0}));
    ASSERT_TRUE(arm.tell({1.0}, kMs, {}, {"b"}));
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 2 * kMs, {1'700'000'000, 2'000'000}));
    EXPECT_FALSE(arm.watch.takeFault());
    ASSERT_TRUE(arm.tell({1.0}, 3 * kMs, {}, {"b"}));
    // 10 rad/s for the 0.1 s that it may be silent.
    ASSERT_TRUE(arm.tell({0.99, 1.0}, 4 * kMs, {1'700'000'000, 4'000'000}));
    EXPECT_FALSE(arm.watch.takeFault());
    ASSERT_TRUE(arm.tell({1.0}, 5 * kMs, {}, {"b"}));
    ASSERT_TRUE(arm.tell({2.0, 1.0}, 6 * kMs, {1'700'000'000, 6'000'000}));
    EXPECT_EQ(arm.watch.takeFault(), (ArmFault{ArmFaultKind::jumped, "a"}));
}

TEST(JointWatch, timeThatGoesBackIsAFault) {
    Watched arm;
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 0, {10, 0}));
    ASSERT_TRUE(arm.tell({0.0, 1.0}, kMs, {8, 0}));
    EXPECT_EQ(arm.watch.takeFault(), (ArmFault{ArmFaultKind::backward, "/joint_states"}));
}

TEST(JointWatch, aJointThatIsLeftOutMakesTheArmUnknown) {
    Watched arm;
    ASSERT_TRUE(arm.tell({0.0, 1.0}, 0));
    for (int i = 1; i <= 10; ++i)
        (void)arm.tell({0.0}, 10 * i * kMs, {}, {"a"});
    EXPECT_TRUE(arm.watch.sampleAt(100 * kMs));
    (void)arm.tell({0.0}, 101 * kMs, {}, {"a"});
    EXPECT_FALSE(arm.watch.sampleAt(101 * kMs));
    EXPECT_EQ(arm.watch.missing(101 * kMs), std::vector<std::string>{"b"});
}

} // namespace
} // namespace teleta::ros_arm
