// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of tactile servoing and the expected behaviour.
#include "backend/servo/arm/lwr_arm.h"
#include "backend/servo/servo_controller.h"
#include "tests/backend/servo/servo_frames.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

using namespace teleta::servo;
using namespace teleta::servo::test;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using teleta::contact::ContactType;

namespace {

constexpr double kPi = std::numbers::pi;

/// An arm of 1000 N/m presses a sensor onto a spring: at rest, along z.
struct Press {
    double arm_NPerM = 1000.0;
    double object_NPerM = 1e4;
    double surface_m = 0.0;

    [[nodiscard]] double force_N(double command_m) const {
        const double both = arm_NPerM * object_NPerM / (arm_NPerM + object_NPerM);
        return std::max(0.0, both * (command_m - surface_m));
    }
};

} // namespace

TEST(ServoHardCases, anEmptyFrameMovesOnlyTheFreeMotion) {
    Bed bed;
    ServoController free = controllerOf(freeMotion(0.01));
    const ServoOutput down = free.step(inputOf(bed.features()));
    EXPECT_EQ(down.twist_Sensor, Twist(Twist::Unit(kZ) * 0.01));
    EXPECT_EQ(down.contact, ContactState::none);
    ServoController edge = controllerOf(edgeControlTask(5.0));
    const ServoOutput out = edge.step(inputOf(bed.features()));
    EXPECT_EQ(out.twist_Sensor.norm(), 0.0);
    EXPECT_EQ(out.error.norm(), 0.0);
}

TEST(ServoHardCases, oneActiveTaxelHasAPlaceAndAForceButNoDirection) {
    Bed bed;
    bed.at(4, 9) = 1.0F;
    const auto f = bed.features();
    const ServoOutput out = controllerOf(edgeControlTask(5.0)).step(inputOf(f));
    EXPECT_EQ(out.error[kWz], 0.0);
    EXPECT_EQ(out.twist_Sensor[kWz], 0.0);
    EXPECT_EQ(out.error[kWy], 0.0); // DZMP of one taxel is zero: blind
    EXPECT_GT(out.twist_Sensor[kZ], 0.0);
    EXPECT_GT(out.twist_Sensor[kY], 0.0);
}

TEST(ServoHardCases, anIsotropicBlobIsNotTurned) {
    Bed bed;
    const auto f = bed.ball(5.0, 2, 6);
    ASSERT_FALSE(f.alphaZ_rad.has_value());
    const ServoOutput out = controllerOf(edgeControlTask(5.0)).step(inputOf(f));
    EXPECT_EQ(out.twist_Sensor[kWz], 0.0);
    ServoTask touch = edgeControlTask(5.0);
    touch.jacobian = JacobianRule::touch;
    const ServoOutput asPoint = controllerOf(touch).step(inputOf(f));
    EXPECT_FALSE(asPoint.edge);
    EXPECT_EQ(asPoint.inverseJacobian, inverseTactileJacobian(false));
}

TEST(ServoHardCases, anEdgeAtNinetyDegreesTurnsOneWayAndArrives) {
    // The axis of an edge across the sensor flips between +90 and -90 degrees with the noise of each frame.
    std::mt19937_64 random(8);
    std::normal_distribution<double> noise(0.0, 0.03);
    ServoController controller = controllerOf(edgeControlTask(5.0));
    Isometry3d X = Isometry3d::Identity();
    double edge_rad = kPi / 2.0;
    double sign = 0.0;
    for (int i = 0; i < 1000; ++i) {
        double alpha = std::remainder(edge_rad + noise(random), kPi);
        const ServoOutput out =
            controller.step(inputOf(feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0, alpha), 0.01, X));
        X = out.X_Base_Sensor;
        edge_rad -= 0.01 * out.twist_Sensor[kWz];
        if (i == 0)
            sign = out.twist_Sensor[kWz];
        // While it is far from aligned the turn never changes its direction.
        if (std::abs(std::remainder(edge_rad, kPi)) > 0.3) {
            EXPECT_GT(out.twist_Sensor[kWz] * sign, 0.0) << i;
        }
    }
    EXPECT_NEAR(std::remainder(edge_rad, kPi), 0.0, 0.03);
}

TEST(ServoHardCases, anEdgeAcrossTheCornerIsDrawnToTheMiddle) {
    Bed bed;
    for (int i = 0; i < 4; ++i)
        bed.at(2 + i, 10 + i) = 0.5F; // 45 degrees over the corner at +x, +y
    const auto f = bed.features();
    ASSERT_EQ(f.type, ContactType::edge);
    ASSERT_NEAR(*f.alphaZ_rad, kPi / 4.0, 1e-6);
    const ServoOutput out = controllerOf(edgeControlTask(5.0)).step(inputOf(f));
    EXPECT_GT(out.twist_Sensor[kWz], 0.0);
    // The centre of the edge moves towards the middle row.
    const Vector3d p(*f.cocX_m, *f.cocY_m, 0.0);
    const Vector3d v = out.twist_Sensor.head<3>() + Vector3d(out.twist_Sensor.tail<3>()).cross(p);
    EXPECT_GT(v.y(), 0.0);
    EXPECT_FALSE(out.limits.has(Limit::force));
}

TEST(ServoHardCases, saturatedTaxelsStopThePush) {
    Bed bed;
    const auto f = bed.bar(2.89, 0.0, 6, 6);
    const ServoOutput out = controllerOf(edgeControlTask(20.0)).step(inputOf(f));
    EXPECT_TRUE(out.limits.has(Limit::saturation));
    EXPECT_EQ(out.twist_Sensor[kZ], 0.0);
    EXPECT_EQ(out.integral[kZ], 0.0);
}

TEST(ServoHardCases, aSecondWithoutAFrameCountsAsTheLongestStep) {
    const auto light = feel(ContactType::edge, 4.0, 0.0, 0.0, 0.0, 0.0);
    const ServoTask task = exploreTask(5.0, 0.005);
    ServoController late = controllerOf(task);
    ServoController longest = controllerOf(task);
    const ServoOutput gap = late.step(inputOf(light, 1.0));
    const ServoOutput step = longest.step(inputOf(light, task.limits.longestStep_s));
    EXPECT_TRUE(gap.limits.has(Limit::gap));
    EXPECT_FALSE(step.limits.has(Limit::gap));
    EXPECT_EQ(gap.X_Base_Sensor.matrix(), step.X_Base_Sensor.matrix());
    EXPECT_LE(gap.X_Base_Sensor.translation().norm(),
              task.limits.toolSpeed_mPerS * task.limits.longestStep_s);
}

TEST(ServoHardCases, numbersThatAreNoneMoveNothing) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto good = feel(ContactType::edge, 4.0, 0.0, 0.0, 0.0, 0.0);
    ServoController controller = controllerOf(exploreTask(5.0, 0.005));
    const ServoOutput before = controller.step(inputOf(good));
    std::vector<ServoInput> bad(7, inputOf(good));
    bad[0].dt_s = 0.0;
    bad[1].dt_s = -0.01;
    bad[2].dt_s = nan;
    bad[3].features.force_N = infinity;
    bad[4].features.copX_m = nan;
    bad[5].X_Base_Sensor.translation().x() = nan;
    bad[6].q_rad = jointVector(LwrVector::Constant(nan));
    for (const ServoInput& input : bad) {
        const ServoOutput out = controller.step(input);
        EXPECT_TRUE(out.limits.has(Limit::badInput));
        EXPECT_EQ(out.X_Base_Sensor.matrix(), before.X_Base_Sensor.matrix());
    }
    EXPECT_FALSE(controller.step(inputOf(good)).limits.any());
}

TEST(ServoHardCases, badNumbersInTheFirstFrameHoldTheMeasuredPose) {
    const Isometry3d measured(Eigen::Translation3d(0.3, 0.1, 0.2));
    ServoController controller = controllerOf(exploreTask(5.0, 0.005));
    ServoInput input = inputOf(feel(ContactType::edge, 4.0, 0.0, 0.0, 0.0, 0.0), 0.01, measured);
    input.features.force_N = std::numeric_limits<double>::quiet_NaN();
    const ServoOutput out = controller.step(input);
    EXPECT_TRUE(out.limits.has(Limit::badInput));
    EXPECT_EQ(out.X_Base_Sensor.matrix(), measured.matrix());
}

TEST(ServoHardCases, theForceSettlesOnSoftAndOnStiffObjectsAtSlowAndFastRates) {
    for (const double object_NPerM : {300.0, 1e4, 1e7, 1e9})
        for (const double rate_Hz : {20.0, 100.0, 1000.0}) {
            const Press press{1000.0, object_NPerM, 0.0};
            ServoController controller = controllerOf(pointFollowingTask(5.0));
            Isometry3d X = Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.0005));
            double force_N = press.force_N(X.translation().z());
            double highest_N = 0.0;
            for (int i = 0; i < static_cast<int>(30.0 * rate_Hz); ++i) {
                X = controller
                        .step(
                            inputOf(feel(ContactType::point, force_N, 0.0, 0.0, 0.0, 0.0), 1.0 / rate_Hz, X))
                        .X_Base_Sensor;
                force_N = press.force_N(X.translation().z());
                highest_N = std::max(highest_N, force_N);
            }
            EXPECT_NEAR(force_N, 5.0, 0.01) << object_NPerM << " N/m, " << rate_Hz << " Hz";
            EXPECT_LT(highest_N, 1.5 * 5.0) << object_NPerM << " N/m, " << rate_Hz << " Hz";
        }
}

TEST(ServoHardCases, onASlopeTheIntegralTakesAwayTheDroop) {
    // The surface falls away by 2 mm/s. With P alone the error would be v/(K_P C) = 0.63 N.
    const ServoTask task = pointFollowingTask(5.0);
    for (const bool integral : {true, false}) {
        ServoTask used = task;
        if (!integral)
            used.gains.integral.setZero();
        ServoController controller = controllerOf(used);
        Press press{1000.0, 16800.0, 0.0};
        Isometry3d X = Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.0053));
        double force_N = press.force_N(X.translation().z());
        for (int i = 0; i < 2000; ++i) {
            press.surface_m += 0.002 * 0.01;
            X = controller.step(inputOf(feel(ContactType::point, force_N, 0.0, 0.0, 0.0, 0.0), 0.01, X))
                    .X_Base_Sensor;
            force_N = press.force_N(X.translation().z());
        }
        const double droop_N = 0.002 / (used.gains.proportional[kZ] * used.normalCompliance_mPerN);
        EXPECT_NEAR(force_N, integral ? 5.0 : 5.0 - droop_N, 0.02);
    }
}

TEST(ServoHardCases, afterAMinuteAgainstAWallTheFirstStepBackLeadsBack) {
    // The contact stays 10 mm off, because the arm is held.
    const ServoTask task = pointFollowingTask(5.0);
    ServoController controller = controllerOf(task);
    ServoOutput out;
    for (int i = 0; i < 6000; ++i)
        out = controller.step(inputOf(feel(ContactType::point, 4.0, 0.010, 0.0, 0.010, 0.0)));
    EXPECT_LE(out.X_Base_Sensor.translation().norm(), task.limits.deviation_m + 1e-9);
    EXPECT_LE(std::abs(out.integral[kX]), task.gains.integralLimit[kX]);
    const ServoOutput back =
        controller.step(inputOf(feel(ContactType::point, 5.0, -0.010, 0.0, -0.010, 0.0)));
    EXPECT_LT(back.twist_Sensor[kX], 0.0);
    // The force that was missing for a minute does not make it push on.
    const ServoOutput release =
        controller.step(inputOf(feel(ContactType::point, 12.0, -0.010, 0.0, -0.010, 0.0)));
    EXPECT_LT(release.twist_Sensor[kZ], 0.0);
}

TEST(ServoHardCases, aLostContactIsSearchedWithinTheBoundAndThenReported) {
    const ServoTask task = exploreTask(5.0, 0.005);
    ServoController controller = controllerOf(task);
    const SearchSettings search = planOf(task).search;
    const Isometry3d last =
        Isometry3d(Eigen::AngleAxisd(0.4, Vector3d::UnitX())) * Eigen::Translation3d(0.3, 0.1, 0.2);
    for (int i = 0; i < 20; ++i)
        controller.step(inputOf(feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0), 0.01, last));
    Isometry3d X = last;
    bool searched = false;
    ServoOutput out;
    double deepest_m = 0.0;
    double farthestBack_m = 0.0;
    double longest_s = 0.0;
    for (int i = 0; i < 3000; ++i) {
        out = controller.step(inputOf(nothing(), 0.01, X));
        X = out.X_Base_Sensor;
        if (out.contact == ContactState::lost && longest_s == 0.0)
            longest_s = 0.01 * i;
        searched = searched || out.contact == ContactState::searching;
        const Vector3d p_Last = last.inverse() * X.translation();
        deepest_m = std::max(deepest_m, p_Last.z());
        farthestBack_m = std::max(farthestBack_m, -p_Last.x());
        EXPECT_LE(std::abs(p_Last.y()), 1e-9);
    }
    EXPECT_TRUE(searched);
    EXPECT_EQ(out.contact, ContactState::lost);
    EXPECT_EQ(out.twist_Sensor.norm() < 1e-9, true);
    EXPECT_NEAR(deepest_m, search.depth_m, 1e-4);
    EXPECT_NEAR(farthestBack_m, (search.probes - 1) * search.probeStep_m, 1e-4);
    EXPECT_NEAR((last.inverse() * X.translation()).z(), -search.retreat_m, 1e-5);
    // Way of the search over its speed: three probes forth and back, two shifts.
    const double way_m =
        search.retreat_m + 6.0 * (search.depth_m + search.retreat_m) + 2.0 * search.probeStep_m;
    EXPECT_NEAR(longest_s, search.lostAfter_s + way_m / search.speed_mPerS, 0.2);
}

TEST(ServoHardCases, aSearchWhoseTargetIsOutOfReachEndsAndSaysSo) {
    // The joints are at their ends, so the arm cannot follow the search.
    const LwrKinematics arm;
    LwrVector q_rad;
    q_rad << 0.1, 0.6, 0.1, -1.4, 0.1, 0.9, 0.1;
    InverseSettings inverse;
    inverse.limits.lowest_rad = q_rad;
    inverse.limits.highest_rad = q_rad;
    const ServoTask task = exploreTask(5.0, 0.005);
    ServoController controller =
        *ServoController::create(planOf(task), std::make_shared<LwrArm>(arm, inverse));
    const SearchSettings search = planOf(task).search;
    const Isometry3d X = arm.X_Base_Tool(q_rad);
    const auto step = [&](const teleta::contact::TactileFeatures& features) {
        ServoInput input = inputOf(features, 0.01, X);
        input.q_rad = jointVector(q_rad);
        return controller.step(input);
    };
    for (int i = 0; i < 20; ++i)
        step(feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0));
    // Each of the targets, four a probe, is given up after twice the way to it and half a second; the longest
    // way is that to the depth of the last probe.
    const double way_m = std::hypot(search.depth_m + search.retreat_m, search.probes * search.probeStep_m);
    const double longest_s = 4.0 * search.probes * (2.0 * way_m / search.speed_mPerS + 0.5);
    ServoOutput out;
    bool stuck = false;
    int steps = 0;
    do {
        out = step(nothing());
        stuck = stuck || out.limits.has(Limit::jointEnd);
    } while (out.contact != ContactState::lost && ++steps < static_cast<int>(100.0 * longest_s));
    EXPECT_EQ(out.contact, ContactState::lost);
    EXPECT_TRUE(stuck);
    EXPECT_LE((out.X_Base_Sensor.translation() - X.translation()).norm(), 1e-3);
}

TEST(ServoHardCases, aContactThatIsFoundAgainGoesOnWithAlignment) {
    ServoPlan plan = explorePlan();
    plan.start = 3;
    ServoController controller = *ServoController::create(plan);
    const auto edge = feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0);
    Isometry3d X = Isometry3d::Identity();
    for (int i = 0; i < 20; ++i)
        X = controller.step(inputOf(edge, 0.01, X)).X_Base_Sensor;
    // A flicker of 40 ms is no loss.
    ServoOutput out;
    for (int i = 0; i < 4; ++i)
        out = controller.step(inputOf(nothing(), 0.01, X));
    EXPECT_EQ(out.contact, ContactState::touching);
    EXPECT_EQ(controller.step(inputOf(edge, 0.01, X)).kind, TaskKind::explore);
    for (int i = 0; i < 60; ++i)
        out = controller.step(inputOf(nothing(), 0.01, X));
    EXPECT_EQ(out.contact, ContactState::searching);
    out = controller.step(inputOf(feel(ContactType::point, 1.0, 0.01, 0.0, 0.01, 0.0), 0.01, X));
    EXPECT_EQ(out.kind, TaskKind::align);
    EXPECT_TRUE(out.phaseBegan);
    EXPECT_EQ(out.contact, ContactState::touching);
}

TEST(ServoHardCases, aTaskThatIsBegunAfterTheContactWasLostRuns) {
    ServoPlan plan = explorePlan();
    plan.start = 3;
    ServoController controller = *ServoController::create(plan);
    Isometry3d X = Isometry3d::Identity();
    const auto run = [&](const teleta::contact::TactileFeatures& features, int steps) {
        ServoOutput out;
        for (int i = 0; i < steps; ++i) {
            out = controller.step(inputOf(features, 0.01, X));
            X = out.X_Base_Sensor;
        }
        return out;
    };
    run(feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0), 20);
    ASSERT_EQ(run(nothing(), 3000).contact, ContactState::lost);
    ASSERT_TRUE(controller.enter(0).has_value());
    const ServoOutput approach = run(nothing(), 1);
    EXPECT_EQ(approach.twist_Sensor, Twist(plan.tasks[0].feedForward.constant_Sensor));
    // A task that needs contact feels for it anew.
    ASSERT_TRUE(controller.enter(3).has_value());
    EXPECT_EQ(run(nothing(), 1).contact, ContactState::searching);
}

TEST(ServoHardCases, anArmThroughItsSingularityGetsBoundedCommands) {
    const LwrKinematics arm;
    const auto guard = std::make_shared<const LwrArm>(arm);
    ServoTask task = freeMotion(0.05);
    ServoController controller = *ServoController::create(planOf(task), guard);
    LwrVector q_rad = LwrVector::Zero();
    q_rad[1] = 0.6;
    q_rad[3] = -0.02; // almost stretched, and it is commanded further outwards
    Isometry3d last = arm.X_Base_Tool(q_rad);
    bool singular = false;
    for (int i = 0; i < 500; ++i) {
        ServoInput input = inputOf(nothing(), 0.01, arm.X_Base_Tool(q_rad));
        input.q_rad = jointVector(q_rad);
        const ServoOutput out = controller.step(input);
        ASSERT_TRUE(out.X_Base_Sensor.matrix().array().isFinite().all());
        EXPECT_LE((out.X_Base_Sensor.translation() - last.translation()).norm(), 0.05 * 0.01 + 1e-12);
        singular = singular || out.limits.has(Limit::singular);
        last = out.X_Base_Sensor;
    }
    EXPECT_TRUE(singular);
}
