// SPDX-License-Identifier: GPL-3.0-or-later
// A planar arm whose two joints turn about y, with links of 0.3 and 0.2 m along x:
//   x = 0.3 cos a + 0.2 cos(a + b),  z = -0.3 sin a - 0.2 sin(a + b),  turned by a + b
#include "backend/arm_model/urdf_reader.h"
#include "devices/ros/check/frame_check.h"
#include "tests/devices/ros/told_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>

namespace teleta::ros_arm {
namespace {

using test::ToldFrame;

std::shared_ptr<const arm_model::SerialChain> planarArm() {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/gripper.urdf");
    EXPECT_TRUE(model);
    const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                      "base_link", "tool0");
    EXPECT_TRUE(chain);
    return std::make_shared<const arm_model::SerialChain>(*chain);
}

constexpr double kStart_s = 1'790'000'000.0;

/// The frame of the lower link, in that of the upper arm's beginning, as a robot with this link would tell.
ToldFrame lowerLink(double a, double b, double stamp_s, double upperArm_m = 0.3) {
    return {.frame = "lower",
            .parent = "base_link",
            .p_m = {upperArm_m * std::cos(a), 0.0, -upperArm_m * std::sin(a)},
            .quaternion = {std::cos((a + b) / 2.0), 0.0, std::sin((a + b) / 2.0), 0.0},
            .stamp_s = stamp_s};
}

class TwoJoints {
public:
    TwoJoints() {
        test::tellFrames({{.frame = "tool0", .parent = "lower", .p_m = {0.2, 0.0, 0.0}}},
                         [this](const ros::TFMessage& message) { check.takeFixed(message); });
    }
    void tell(const ToldFrame& frame) {
        test::tellFrames({frame}, [this](const ros::TFMessage& message) { check.takeMoving(message, 0); });
    }
    FrameCheck check{planarArm()};
};

TEST(FrameCheck, aRobotOfThisDescriptionIsWhereItsFramesAre) {
    TwoJoints arm;
    for (int i = 0; i < 50; ++i) {
        const double a = 0.01 * i, b = -0.02 * i, stamp_s = kStart_s + 0.01 * i;
        arm.tell(lowerLink(a, b, stamp_s));
        arm.check.takeJoints({a, b}, stamp_s);
    }
    EXPECT_EQ(arm.check.seen().messages, 50U);
    EXPECT_TRUE(arm.check.seen().connected);
    EXPECT_GE(arm.check.seen().compared, 47U);
    EXPECT_LT(arm.check.seen().farthest_m, 1e-9);
    EXPECT_LT(arm.check.seen().largestTurn_rad, 1e-7);
}

TEST(FrameCheck, aPoseBetweenTwoSamplesIsComparedWithWhatLiesBetween) {
    TwoJoints arm;
    for (int i = 0; i < 20; ++i) {
        arm.check.takeJoints({0.03 * i, 0.01 * i}, kStart_s + 0.02 * i);
        arm.tell(lowerLink(0.03 * (i + 0.25), 0.01 * (i + 0.25), kStart_s + 0.02 * (i + 0.25)));
    }
    EXPECT_GE(arm.check.seen().compared, 17U);
    // Stamps have steps of a quarter of a microsecond, and the arm 1.5 rad/s.
    EXPECT_LT(arm.check.seen().farthest_m, 1e-6);
}

TEST(FrameCheck, anotherRobotsDescriptionIsAsFarOffAsItsLinksDiffer) {
    TwoJoints arm;
    for (int i = 0; i < 5; ++i) {
        arm.tell(lowerLink(0.4, -0.3, kStart_s + 0.01 * i, 0.33));
        arm.check.takeJoints({0.4, -0.3}, kStart_s + 0.01 * i);
    }
    EXPECT_NEAR(arm.check.seen().farthest_m, 0.03, 1e-9);
    EXPECT_NEAR(arm.check.seen().largestTurn_rad, 0.0, 1e-7);
    // A joint with another zero turns the tip as well.
    for (int i = 5; i < 9; ++i) {
        arm.tell(lowerLink(0.4, -0.3, kStart_s + 0.01 * i));
        arm.check.takeJoints({0.4, -0.1}, kStart_s + 0.01 * i);
    }
    EXPECT_NEAR(arm.check.seen().largestTurn_rad, 0.2, 1e-9);
}

TEST(FrameCheck, whatCannotBeComparedIsNotCompared) {
    FrameCheck alone{planarArm()};
    test::tellFrames({lowerLink(0.0, 0.0, kStart_s)},
                     [&alone](const ros::TFMessage& message) { alone.takeMoving(message, 0); });
    EXPECT_FALSE(alone.seen().connected) << "nothing says where the tool is";

    TwoJoints arm;
    for (int i = 0; i < 5; ++i) {
        arm.tell(lowerLink(0.4, 0.0, 0.0));                      // no stamp
        arm.tell(lowerLink(0.4, 0.0, kStart_s - 5.0));           // of before the first sample
        arm.tell(lowerLink(0.4, 0.0, kStart_s + 0.5 + 1.0 * i)); // between samples that are far apart
        arm.check.takeJoints({0.0, 0.0}, kStart_s + 1.0 * i);
        arm.check.takeJoints({0.0, 0.0}, kStart_s + 1.0 * i); // not newer
    }
    EXPECT_TRUE(arm.check.seen().connected);
    EXPECT_EQ(arm.check.seen().compared, 0U);
}

TEST(FrameCheck, aJointThatComesRoundIsNotInterpolatedThroughZero) {
    TwoJoints arm;
    for (int i = 0; i < 10; ++i) {
        const double a = i < 5 ? 3.1 : -3.1; // a continuous joint as some drivers tell it
        arm.check.takeJoints({a, 0.0}, kStart_s + 0.02 * i);
        arm.tell(lowerLink(i < 4 || i > 4 ? a : std::numbers::pi, 0.0, kStart_s + 0.02 * (i + 0.5)));
    }
    EXPECT_GE(arm.check.seen().compared, 6U);
    EXPECT_LT(arm.check.seen().farthest_m, 1e-6);
}

TEST(FrameCheck, goesOnAfterTheRobotsClockJumped) {
    TwoJoints arm;
    arm.tell(lowerLink(0.4, 0.0, kStart_s + 3600.0)); // of another clock
    const auto compared = [&arm](double start_s) {
        const std::uint64_t before = arm.check.seen().compared;
        for (int i = 0; i < 10; ++i) {
            arm.tell(lowerLink(0.4, -0.3, start_s + 0.01 * i));
            arm.check.takeJoints({0.4, -0.3}, start_s + 0.01 * i);
        }
        return arm.check.seen().compared - before;
    };
    EXPECT_GE(compared(kStart_s), 7U);
    EXPECT_GE(compared(kStart_s - 1000.0), 7U) << "a simulation was started anew";
    EXPECT_LT(arm.check.seen().farthest_m, 1e-9);
}

TEST(FrameCheck, framesOfDifferentTimesMakeNoPose) {
    TwoJoints arm;
    const auto upper = [](double stamp_s) {
        return ToldFrame{.frame = "base_link", .parent = "world", .stamp_s = stamp_s};
    };
    const auto lower = [](double stamp_s) {
        ToldFrame frame = lowerLink(0.4, 0.0, stamp_s);
        frame.parent = "world";
        return frame;
    };
    arm.tell(upper(kStart_s));
    arm.check.takeJoints({0.4, 0.0}, kStart_s);
    arm.tell(lower(kStart_s + 0.1));
    arm.check.takeJoints({0.4, 0.0}, kStart_s + 0.1);
    arm.check.takeJoints({0.4, 0.0}, kStart_s + 0.2);
    EXPECT_EQ(arm.check.seen().compared, 0U) << "the base may have moved meanwhile";
    arm.tell(upper(kStart_s + 0.25));
    arm.tell(lower(kStart_s + 0.25));
    arm.check.takeJoints({0.4, 0.0}, kStart_s + 0.25);
    arm.check.takeJoints({0.4, 0.0}, kStart_s + 0.3);
    EXPECT_EQ(arm.check.seen().compared, 1U);
    EXPECT_LT(arm.check.seen().farthest_m, 1e-9);
}

} // namespace
} // namespace teleta::ros_arm
