// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/arm_servo.h"
#include "tests/backend/arm_servo/servo_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::arm_servo {
namespace {

using core::JointVector;
using test::kLookingDown_rad;
using test::ServoBench;

constexpr double kForce_N = 3.0;

double farthest(const JointVector& a, const JointVector& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// A ball of four taxels, so far below the pad and beside its middle.
ServoBench::World ballBelow(const ServoBench& bench, double below_m, double x_m, double y_m) {
    const Eigen::Isometry3d X = bench.pad->X_Base_Sensor(bench.q_rad);
    return ServoBench::ball(X * Eigen::Vector3d(x_m, y_m, below_m), 4 * kTaxelStiffness_NPerM, 4);
}

TEST(ArmServo, nothingIsPostedWithoutTheSwitch) {
    ServoBench bench;
    bench.world = ballBelow(bench, -0.001, 0.0, 0.0); // it presses on the pad
    bench.run(5.0);
    EXPECT_EQ(bench.posts, 0);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(farthest(bench.q_rad, kLookingDown_rad), 0.0);
}

TEST(ArmServo, theFirstPressMovesTheShadowAlone) {
    ServoBench bench;
    bench.servo.setTask(ArmTask::point, kForce_N);
    bench.press();
    bench.run(20.0);
    EXPECT_EQ(bench.servo.stage(), Stage::rehearsing);
    EXPECT_EQ(bench.posts, 0);
    EXPECT_EQ(farthest(bench.q_rad, kLookingDown_rad), 0.0);
    // The shadow holds the force on the ball that is assumed, and the contact in the middle of the pad.
    ASSERT_TRUE(bench.newest.shadow_rad);
    EXPECT_NEAR(bench.newest.force_N, kForce_N, 0.05 * kForce_N);
    EXPECT_EQ(bench.newest.output.kind, servo::TaskKind::pointFollowing);
    EXPECT_GT(farthest(*bench.newest.shadow_rad, kLookingDown_rad), 0.003);
    bench.release();
    bench.run(1.0);
    EXPECT_EQ(bench.servo.stage(), Stage::rehearsed);
    EXPECT_FALSE(bench.newest.shadow_rad);
    EXPECT_EQ(bench.posts, 0);
}

TEST(ArmServo, eachTaskHoldsItsForceInTheRehearsal) {
    for (const ArmTask task : kArmTasks) {
        ServoBench bench;
        const double force_N = usualForce_N(task);
        bench.servo.setTask(task, force_N);
        bench.press();
        bench.run(20.0);
        EXPECT_EQ(bench.servo.stage(), Stage::rehearsing) << static_cast<int>(task);
        EXPECT_EQ(bench.newest.output.contact, servo::ContactState::touching) << static_cast<int>(task);
        EXPECT_NEAR(bench.newest.force_N, force_N, 0.05 * force_N) << static_cast<int>(task);
        EXPECT_EQ(bench.posts, 0);
    }
}

TEST(ArmServo, theSecondPressBringsThePadIntoContactAndHoldsForceAndPlace) {
    ServoBench bench;
    bench.servo.setTask(ArmTask::point, kForce_N);
    bench.rehearse();
    ASSERT_EQ(bench.servo.stage(), Stage::rehearsed);
    bench.world = ballBelow(bench, 0.004, 0.005, -0.004);
    bench.press();
    bench.run(30.0);
    ASSERT_EQ(bench.servo.stage(), Stage::driving) << static_cast<int>(bench.servo.ending());
    EXPECT_FALSE(bench.newest.shadow_rad);
    EXPECT_NEAR(bench.feels.force_N, kForce_N, 0.02 * kForce_N);
    ASSERT_TRUE(bench.feels.copX_m);
    EXPECT_NEAR(*bench.feels.copX_m, 0.0, 0.0002);
    EXPECT_NEAR(*bench.feels.copY_m, 0.0, 0.0002);
}

TEST(ArmServo, theForceIsHeldOnAHardFlatSurfaceToo) {
    ServoBench bench;
    bench.servo.setTask(ArmTask::point, kForce_N);
    bench.rehearse();
    constexpr int kAll = 84;
    const Eigen::Isometry3d X = bench.pad->X_Base_Sensor(bench.q_rad);
    bench.world = ServoBench::ball(X * Eigen::Vector3d(0.0, 0.0, 0.002), kAll * kTaxelStiffness_NPerM, kAll);
    bench.press();
    bench.run(30.0);
    ASSERT_EQ(bench.servo.stage(), Stage::driving) << static_cast<int>(bench.servo.ending());
    EXPECT_NEAR(bench.feels.force_N, kForce_N, 0.05 * kForce_N);
}

TEST(ArmServo, lettingGoStopsTheArmAndTheNextPressGoesOn) {
    ServoBench bench;
    bench.rehearse();
    bench.press();
    bench.run(1.0);
    EXPECT_GT(bench.motions, 10);
    bench.release();
    const ArmServoStep first = bench.tick();
    ASSERT_TRUE(first.rate);
    EXPECT_EQ(*first.rate, JointVector::zeros(7));
    const int posts = bench.posts;
    bench.run(1.0);
    EXPECT_EQ(bench.posts, posts) << "nothing more is told";
    EXPECT_EQ(bench.servo.ending(), Ending::letGo);
    const JointVector rested_rad = bench.q_rad;
    bench.run(1.0);
    EXPECT_LT(farthest(bench.q_rad, rested_rad), 1e-6);

    bench.press();
    bench.run(0.2);
    EXPECT_EQ(bench.servo.stage(), Stage::driving);
}

TEST(ArmServo, aShortRehearsalDoesNotCount) {
    ServoBench bench;
    bench.rehearse(ArmServo::kLeastRehearsal_s - 0.2);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(bench.servo.ending(), Ending::tooShort);
    bench.press();
    bench.run(1.0);
    EXPECT_EQ(bench.servo.stage(), Stage::rehearsing);
    EXPECT_EQ(bench.posts, 0);
}

/// Something goes wrong, and goes away again.
struct Trouble {
    const char* name;
    std::function<void(ServoBench&)> begin;
    std::function<void(ServoBench&)> end;
    Ending ending;
    bool ofRehearsals = true; ///< it ends a rehearsal as well
};

std::vector<Trouble> troubles() {
    return {{"STOP", [](auto& b) { b.stopped = true; }, [](auto& b) { b.stopped = false; }, Ending::stopped},
            {"silent pad", [](auto& b) { b.padSilent = true; }, [](auto& b) { b.padSilent = false; },
             Ending::noFrames},
            {"old joints", [](auto& b) { b.jointsOld = true; }, [](auto& b) { b.jointsOld = false; },
             Ending::noJoints},
            {"hindered", [](auto& b) { b.hindered = true; }, [](auto& b) { b.hindered = false; },
             Ending::hindered, false},
            {"task changed", [](auto& b) { b.servo.setTask(ArmTask::roll, kForce_N); }, [](auto&) {},
             Ending::taskChanged},
            {"moved by another", [](auto& b) { b.servo.forget(); }, [](auto&) {}, Ending::armMoved}};
}

TEST(ArmServo, whatGoesWrongEndsTheMotionAndTheSameHoldMovesNothing) {
    for (const Trouble& trouble : troubles()) {
        ServoBench bench;
        bench.rehearse();
        bench.press();
        bench.run(1.0);
        ASSERT_EQ(bench.servo.stage(), Stage::driving) << trouble.name;
        ASSERT_GT(bench.motions, 0) << trouble.name;
        trouble.begin(bench);
        bench.run(0.4);
        EXPECT_EQ(bench.servo.stage(), Stage::idle) << trouble.name;
        EXPECT_EQ(bench.servo.ending(), trouble.ending) << trouble.name;
        // Still held, with the trouble and after it.
        const int motions = bench.motions;
        bench.run(1.0);
        trouble.end(bench);
        bench.run(1.0);
        EXPECT_EQ(bench.motions, motions) << trouble.name;
        // The next press is a rehearsal.
        bench.release();
        bench.run(0.1);
        bench.press();
        bench.run(1.0);
        EXPECT_EQ(bench.servo.stage(), Stage::rehearsing) << trouble.name;
        EXPECT_EQ(bench.motions, motions) << trouble.name;
    }
}

TEST(ArmServo, whatGoesWrongInARehearsalOrAfterItMakesItNotCount) {
    for (const Trouble& trouble : troubles()) {
        if (!trouble.ofRehearsals)
            continue;
        ServoBench bench;
        bench.press();
        bench.run(2.0);
        trouble.begin(bench);
        bench.run(0.4);
        EXPECT_EQ(bench.servo.stage(), Stage::idle) << trouble.name;
        EXPECT_EQ(bench.servo.ending(), trouble.ending) << trouble.name;
        trouble.end(bench);
        bench.release();
        bench.run(0.1);
        bench.press();
        bench.run(1.0);
        EXPECT_EQ(bench.servo.stage(), Stage::rehearsing) << trouble.name;
        EXPECT_EQ(bench.posts, 0) << trouble.name;
    }
}

TEST(ArmServo, aPressWithStopEngagedMovesNothingWhenStopIsReleased) {
    ServoBench bench;
    bench.rehearse();
    bench.stopped = true;
    bench.press();
    bench.run(0.5);
    bench.stopped = false;
    bench.run(1.0);
    EXPECT_EQ(bench.posts, 0);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(bench.servo.ending(), Ending::stopped);
}

TEST(ArmServo, anArmThatWasMovedSinceIsRehearsedAgain) {
    ServoBench bench;
    bench.rehearse();
    bench.q_rad[2] += 2 * ArmServo::kMoved_rad;
    bench.run(0.1);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(bench.servo.ending(), Ending::armMoved);
    bench.press();
    bench.run(1.0);
    EXPECT_EQ(bench.servo.stage(), Stage::rehearsing);
    EXPECT_EQ(bench.posts, 0);
}

TEST(ArmServo, aHindranceOfTheTimeBeforeThePressMayLastAMoment) {
    ServoBench bench;
    bench.rehearse();
    bench.hindered = true;
    bench.press();
    const ArmServoStep first = bench.tick();
    ASSERT_TRUE(first.rate);
    EXPECT_EQ(*first.rate, JointVector::zeros(7)) << "the arm learns that the switch was let go";
    bench.hindered = false;
    bench.run(1.0);
    EXPECT_EQ(bench.servo.stage(), Stage::driving);
}

TEST(ArmServo, aContactThatIsNotFoundAgainEndsTheRun) {
    ServoBench bench;
    bench.rehearse();
    bench.world = ballBelow(bench, 0.002, 0.0, 0.0);
    bench.press();
    bench.run(10.0);
    ASSERT_EQ(bench.servo.stage(), Stage::driving);
    ASSERT_GT(bench.feels.active, 0);
    bench.world = [](const Eigen::Isometry3d&) { return contact::TactileFeatures{}; };
    for (int i = 0; i < 100 && bench.servo.stage() == Stage::driving; ++i)
        bench.run(1.0);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(bench.servo.ending(), Ending::contactLost);
    const int posts = bench.posts;
    bench.run(1.0);
    EXPECT_EQ(bench.posts, posts);
}

TEST(ArmServo, aPadThatFeelsNothingDoesNotGoOnForEver) {
    ServoBench bench;
    bench.rehearse();
    const Eigen::Vector3d begin_m = bench.pad->X_Base_Sensor(bench.q_rad).translation();
    bench.press();
    bench.run(70.0);
    EXPECT_EQ(bench.servo.ending(), Ending::nothingFound);
    const Eigen::Vector3d end_m = bench.pad->X_Base_Sensor(bench.q_rad).translation();
    EXPECT_NEAR((end_m - begin_m).norm(), ArmServo::kFarthest_m, 0.001);
}

/// As of a broken cable: the bounds do not begin anew with each touch.
TEST(ArmServo, aContactThatFlickersDoesNotLiftTheBounds) {
    ServoBench bench;
    bench.rehearse();
    const Eigen::Vector3d begin_m = bench.pad->X_Base_Sensor(bench.q_rad).translation();
    bool touches = false;
    bench.world = [&](const Eigen::Isometry3d&) {
        touches = !touches;
        return touches ? ServoBench::touch(0.3, 0.0, 0.0, 1, contact::ContactType::point)
                       : contact::TactileFeatures{};
    };
    bench.press();
    bench.run(120.0);
    EXPECT_FALSE(bench.servo.isRunning());
    EXPECT_NE(bench.servo.ending(), Ending::none);
    const Eigen::Vector3d end_m = bench.pad->X_Base_Sensor(bench.q_rad).translation();
    EXPECT_LT((end_m - begin_m).norm(), ArmServo::kFarthest_m + ArmServo::kDeepest_m + 0.001);
}

TEST(ArmServo, aViewThatHungEndsTheMotionAndTheSameHoldMovesNothing) {
    ServoBench bench;
    bench.rehearse();
    bench.press();
    bench.run(2.0);
    ASSERT_EQ(bench.servo.stage(), Stage::driving);
    bench.hang(0.15);
    const int motions = bench.motions;
    bench.run(1.0);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(bench.servo.ending(), Ending::hindered);
    EXPECT_EQ(bench.motions, motions);
}

/// The arm holds, and says why: it does not wait at the end of a joint for whatever frees it.
TEST(ArmServo, theEndOfAJointEndsTheRun) {
    ServoBench bench;
    for (std::size_t i = 0; i < bench.q_rad.size(); ++i) {
        bench.description.lowest_rad[i] = bench.q_rad[i] - PadArm::kMargin_rad - 0.002;
        bench.description.highest_rad[i] = bench.q_rad[i] + PadArm::kMargin_rad + 0.002;
    }
    bench.pad = *PadArm::create(bench.chain, bench.description, *bench.description.pad);
    bench.servo = ArmServo(bench.chain, bench.pad, core::ArrayLayout{}, contact::FeatureSettings{});
    bench.rehearse();
    bench.press();
    bench.run(0.3);
    ASSERT_EQ(bench.servo.stage(), Stage::driving);
    bench.run(10.0);
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
    EXPECT_EQ(bench.servo.ending(), Ending::jointEnd);
    EXPECT_GT(bench.motions, 0);
}

/// STOP that is engaged in the same step in which the switch is let go.
TEST(ArmServo, lettingGoAndStopInOneStepStillTellTheArmToRest) {
    ServoBench bench;
    bench.rehearse();
    bench.press();
    bench.run(2.0);
    ASSERT_EQ(bench.servo.stage(), Stage::driving);
    bench.release();
    bench.stopped = true;
    const ArmServoStep step = bench.tick();
    ASSERT_TRUE(step.rate);
    EXPECT_TRUE(std::ranges::all_of(*step.rate, [](double rate) { return rate == 0.0; }));
    EXPECT_EQ(bench.servo.stage(), Stage::idle);
}

TEST(ArmServo, aPadThatFeelsTooLittleIsNotPressedOn) {
    ServoBench bench;
    bench.rehearse();
    const Eigen::Vector3d begin_m = bench.pad->X_Base_Sensor(bench.q_rad).translation();
    // Saturated taxels: 1 N whatever the depth.
    bench.world = [&](const Eigen::Isometry3d&) {
        return ServoBench::touch(1.0, 0.0, 0.0, 1, contact::ContactType::point);
    };
    bench.press();
    bench.run(60.0);
    EXPECT_EQ(bench.servo.ending(), Ending::tooDeep);
    const Eigen::Vector3d end_m = bench.pad->X_Base_Sensor(bench.q_rad).translation();
    EXPECT_NEAR((end_m - begin_m).norm(), ArmServo::kDeepest_m, 0.001);
}

} // namespace
} // namespace teleta::arm_servo
