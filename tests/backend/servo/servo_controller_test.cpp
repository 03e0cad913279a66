// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/arm/lwr_arm.h"
#include "backend/servo/servo_controller.h"
#include "tests/backend/contact/allocation_count.h"
#include "tests/backend/servo/servo_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

using namespace teleta::servo;
using namespace teleta::servo::test;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using teleta::contact::ContactType;

namespace {

const auto kEven = feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0);

Isometry3d somewhere() {
    Twist xi;
    xi << 0.4, -0.1, 0.5, 0.3, 2.6, -0.4;
    return expSE3(xi);
}

double distance(const Isometry3d& a, const Isometry3d& b) {
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

} // namespace

TEST(ServoController, thePoseIsMeasuredOnceThenTheCommandIsTakenAsCurrent) {
    ServoController controller = controllerOf(exploreTask(5.0, 0.005));
    const Isometry3d start = somewhere();
    const ServoOutput first = controller.step(inputOf(kEven, 0.01, start));
    EXPECT_LE(distance(first.X_Base_Sensor, start * expSE3(0.01 * first.twist_Sensor)), 1e-15);
    // The arm lags and its pose is noisy; neither affects the command.
    const ServoOutput second =
        controller.step(inputOf(kEven, 0.01, start * Eigen::Translation3d(0.0, 0.0, -0.002)));
    EXPECT_LE(distance(second.X_Base_Sensor, first.X_Base_Sensor * expSE3(0.01 * second.twist_Sensor)),
              1e-15);
}

TEST(ServoController, theTwistInTheBaseIsThatOfTheSensorByTheAdjoint) {
    ServoController controller = controllerOf(exploreTask(5.0, 0.005));
    const Isometry3d start = somewhere();
    const ServoOutput out =
        controller.step(inputOf(feel(ContactType::edge, 4.0, 0.003, 0.001, 0.001, 0.0, 0.2), 0.01, start));
    EXPECT_LE((out.twist_Base - adjoint(start) * out.twist_Sensor).norm(), 1e-15);
    EXPECT_LE(distance(out.X_Base_Sensor, expSE3(0.01 * out.twist_Base) * start), 1e-15);
}

TEST(ServoController, eachErrorMovesTheSensorTheRightWay) {
    const ServoTask edge = edgeControlTask(5.0);
    const auto move = [](const ServoTask& task, const teleta::contact::TactileFeatures& f) {
        return controllerOf(task).step(inputOf(f)).twist_Sensor;
    };
    EXPECT_GT(move(edge, feel(ContactType::edge, 4.0, 0.0, 0.0, 0.0, 0.0))[kZ], 0.0); // too light: push
    EXPECT_LT(move(edge, feel(ContactType::edge, 6.0, 0.0, 0.0, 0.0, 0.0))[kZ], 0.0);
    EXPECT_GT(move(edge, feel(ContactType::edge, 5.0, 0.0, 0.002, 0.0, 0.002))[kY], 0.0); // towards it
    EXPECT_GT(move(edge, feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0, 0.1))[kWz], 0.0);
    EXPECT_GT(move(pointFollowingTask(5.0), feel(ContactType::point, 5.0, 0.002, 0.0, 0.002, 0.0))[kX], 0.0);
    // Phase II: only the end at +x touches, so the sensor turns about +y, and that end recedes.
    EXPECT_GT(move(alignTask(5.0), feel(ContactType::point, 5.0, 0.02, 0.0, 0.02, 0.0))[kWy], 0.0);
    EXPECT_LT(move(alignTask(5.0), feel(ContactType::point, 5.0, -0.02, 0.0, -0.02, 0.0))[kWy], 0.0);
}

TEST(ServoController, whatIsWantedOfContactAndMomentIsThatOfTheTask) {
    const auto after = [](const ServoTask& task, ContactType type) {
        return controllerOf(task).step(inputOf(feel(type, 5.0, 0.0, 0.0, 0.0, 0.0)));
    };
    const ServoOutput free = after(freeMotion(), ContactType::none);
    EXPECT_FALSE(free.desiredCocX_m() || free.desiredDzmpY_m());
    const ServoOutput align = after(alignTask(5.0), ContactType::point); // CoC_x to the middle, eq. (16)
    EXPECT_EQ(align.desiredCocX_m(), std::optional<double>(0.0));
    EXPECT_FALSE(align.desiredDzmpY_m());
    const ServoOutput edge = after(edgeControlTask(5.0), ContactType::edge);
    EXPECT_FALSE(edge.desiredCocX_m());
    EXPECT_EQ(edge.desiredDzmpY_m(), std::optional<double>(0.0));
    ServoTask slide = exploreTask(5.0, 0.005);
    slide.desired.wy_m = 0.001; // row 5 is -DZMP_y
    const ServoOutput explore = after(slide, ContactType::edge);
    EXPECT_EQ(explore.desiredCocX_m(), std::optional<double>(-0.025));
    EXPECT_EQ(explore.desiredDzmpY_m(), std::optional<double>(-0.001));
    const ServoOutput tray = after(comanipulationTask(6.0), ContactType::edge);
    EXPECT_FALSE(tray.desiredCocX_m());
    EXPECT_EQ(tray.desiredDzmpY_m(), std::optional<double>(0.0));
}

TEST(ActiveLimits, areReadFromTheirNames) {
    ActiveLimits limits;
    EXPECT_EQ(ActiveLimits::fromNames(""), limits);
    limits.set(Limit::gap);
    limits.set(Limit::toolSpeed);
    EXPECT_EQ(ActiveLimits::fromNames(limits.names()), limits);
    for (const char* wrong : {"mood", "+gap", "gap,force", "Gap", "gap++force"})
        EXPECT_FALSE(ActiveLimits::fromNames(wrong)) << wrong;
}

TEST(ServoController, aTurnLeavesTheContactWhereItIs) {
    ServoController controller = controllerOf(rollTask(5.0, 0.2, 10.0));
    const Vector3d p_Sensor_Contact(0.005, -0.002, 0.0);
    auto f = feel(ContactType::point, 5.0, 0.0, 0.0, 0.005, -0.002);
    const Isometry3d start = somewhere();
    const Vector3d before = start * p_Sensor_Contact;
    Isometry3d X = start;
    for (int i = 0; i < 100; ++i)
        X = controller.step(inputOf(f, 0.01, X)).X_Base_Sensor;
    EXPECT_GT(logSO3(start.linear().transpose() * X.linear()).norm(), 0.1);
    EXPECT_LE((X * p_Sensor_Contact - before).norm(), 1e-12);
}

TEST(ServoController, aSwayGoesByItsAngleToBothSides) {
    const double angle_rad = 0.2;
    ServoController controller = controllerOf(rollTask(5.0, angle_rad, 4.0));
    const auto f = feel(ContactType::point, 5.0, 0.0, 0.0, 0.0, 0.0);
    Isometry3d X = Isometry3d::Identity();
    double highest = 0.0;
    double lowest = 0.0;
    for (int i = 0; i < 4000; ++i) {
        X = controller.step(inputOf(f, 0.001, X)).X_Base_Sensor;
        const double turned = logSO3(X.linear()).y();
        highest = std::max(highest, turned);
        lowest = std::min(lowest, turned);
    }
    EXPECT_NEAR(highest, angle_rad, 1e-3);
    EXPECT_NEAR(lowest, -angle_rad, 1e-3);
    EXPECT_NEAR(logSO3(X.linear()).y(), 0.0, 1e-3);
}

TEST(ServoController, anErrorThatStaysIsIntegratedUpToTheLimit) {
    const ServoTask task = edgeControlTask(5.0);
    ServoController controller = controllerOf(task);
    const auto f = feel(ContactType::edge, 4.5, 0.0, 0.0, 0.0, 0.0);
    const double error_m = 0.5 * task.normalCompliance_mPerN;
    Isometry3d X = Isometry3d::Identity();
    ServoOutput out;
    for (int i = 0; i < 100; ++i) {
        out = controller.step(inputOf(f, 0.01, X));
        X = out.X_Base_Sensor;
    }
    // The integral learns what K_P alone would not have left over: e (1 - (1 - K_P dt)^k).
    const double expected_s =
        (1.0 - std::pow(1.0 - 0.01 * task.gains.proportional[kZ], 100)) / task.gains.proportional[kZ];
    EXPECT_NEAR(out.twist_Sensor[kZ],
                task.gains.proportional[kZ] * error_m +
                    task.gains.integral[kZ] * error_m * (1.0 - expected_s),
                1e-12);
    for (int i = 0; i < 5000; ++i) {
        out = controller.step(inputOf(f, 0.01, X));
        X = out.X_Base_Sensor;
    }
    EXPECT_DOUBLE_EQ(out.integral[kZ], task.gains.integralLimit[kZ]);
}

TEST(ServoController, anyRateGivesTheSameMotion) {
    const auto f = feel(ContactType::edge, 4.0, 0.002, 0.001, 0.001, 0.001, 0.1);
    std::vector<Isometry3d> ends;
    for (const int rate_Hz : {50, 100, 1000}) {
        ServoController controller = controllerOf(edgeControlTask(5.0));
        Isometry3d X = Isometry3d::Identity();
        for (int i = 0; i < rate_Hz; ++i)
            X = controller.step(inputOf(f, 1.0 / rate_Hz, X)).X_Base_Sensor;
        ends.push_back(X);
    }
    // The integral is summed by rectangles: first order in the step.
    EXPECT_LE(distance(ends[1], ends[2]), 2e-4);
    EXPECT_LE(distance(ends[0], ends[2]), 4e-4);
}

TEST(ServoController, limitsActAndAreReported) {
    ServoTask task = edgeControlTask(5.0);
    ServoOutput out =
        controllerOf(task).step(inputOf(feel(ContactType::edge, 31.0, 0.0, 0.01, 0.0, 0.01, 0.3)));
    EXPECT_TRUE(out.limits.has(Limit::force));
    EXPECT_LT(out.twist_Sensor[kZ], 0.0);
    EXPECT_EQ(out.twist_Sensor.head<2>().norm() + out.twist_Sensor.tail<3>().norm(), 0.0);

    auto saturated = feel(ContactType::edge, 4.0, 0.0, 0.001, 0.0, 0.001);
    saturated.peak_N = 2.89;
    out = controllerOf(task).step(inputOf(saturated));
    EXPECT_TRUE(out.limits.has(Limit::saturation));
    EXPECT_EQ(out.twist_Sensor[kZ], 0.0);
    EXPECT_GT(out.twist_Sensor[kY], 0.0);

    task.gains.proportional[kY] = -20.0;
    out = controllerOf(task).step(inputOf(feel(ContactType::edge, 5.0, 0.0, 0.009, 0.0, 0.009)));
    EXPECT_TRUE(out.limits.has(Limit::toolSpeed));
    EXPECT_NEAR(out.twist_Sensor.head<3>().norm(), task.limits.toolSpeed_mPerS, 1e-15);
    task.gains.proportional[kWz] = -20.0;
    out = controllerOf(task).step(inputOf(feel(ContactType::edge, 5.0, 0.0, 0.0, 0.0, 0.0, 0.5)));
    EXPECT_TRUE(out.limits.has(Limit::turnRate));
    EXPECT_NEAR(out.twist_Sensor.tail<3>().norm(), task.limits.turnRate_radPerS, 1e-15);
    EXPECT_FALSE(controllerOf(edgeControlTask(5.0)).step(inputOf(kEven)).limits.any());
}

TEST(ServoController, theCommandStaysNearTheMeasuredPose) {
    // A person holds the arm, so that it does not follow.
    ServoController controller = controllerOf(exploreTask(5.0, 0.01));
    ServoOutput out;
    for (int i = 0; i < 2000; ++i)
        out = controller.step(inputOf(kEven));
    EXPECT_TRUE(out.limits.has(Limit::deviation));
    EXPECT_NEAR(out.X_Base_Sensor.translation().norm(), ServoLimits{}.deviation_m, 1e-9);
}

TEST(ServoController, jointsAtTheirLimitsAndSingularArmsAreReported) {
    const double degree = std::numbers::pi / 180.0;
    const LwrKinematics arm(Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.05)));
    const auto guard = std::make_shared<const LwrArm>(arm);
    LwrVector q_rad;
    q_rad << 10, 30, -20, -80, 15, 60, 5;
    q_rad *= degree;
    const auto stepAt = [&](const LwrVector& q, ServoTask task) {
        ServoController controller = *ServoController::create(planOf(task), guard);
        ServoInput input = inputOf(kEven, 0.01, arm.X_Base_Tool(q));
        input.q_rad = jointVector(q);
        return controller.step(input);
    };
    ServoTask slide = exploreTask(5.0, 0.005);
    EXPECT_FALSE(stepAt(q_rad, slide).limits.any());

    LwrVector end_rad = q_rad;
    end_rad[6] = LwrLimits::highest()[6];
    ServoTask turn = edgeControlTask(5.0);
    turn.feedForward.constant_Sensor[kWz] = 0.3;
    EXPECT_TRUE(stepAt(end_rad, turn).limits.has(Limit::jointEnd));

    ServoTask fast = slide;
    fast.limits.toolSpeed_mPerS = 10.0;
    fast.feedForward.constant_Sensor[kX] = 3.0;
    const ServoOutput quick = stepAt(q_rad, fast);
    EXPECT_TRUE(quick.limits.has(Limit::jointSpeed) || quick.limits.has(Limit::jointEnd));
    EXPECT_LT(quick.twist_Sensor.head<3>().norm(), 3.0);

    LwrVector stretched_rad = LwrVector::Zero();
    stretched_rad[1] = 40.0 * degree;
    ServoTask push = edgeControlTask(5.0);
    push.feedForward.constant_Sensor[kZ] = 0.02;
    const ServoOutput singular = stepAt(stretched_rad, push);
    EXPECT_TRUE(singular.limits.has(Limit::singular));
    EXPECT_TRUE(singular.X_Base_Sensor.matrix().array().isFinite().all());
    EXPECT_NEAR(singular.twist_Sensor[kZ], 0.0, 1e-9);
}

TEST(ServoController, stopCommandsTheMeasuredPoseAndForgetsTheIntegrals) {
    ServoController controller = controllerOf(exploreTask(5.0, 0.005));
    ServoInput input = inputOf(feel(ContactType::edge, 4.0, 0.0, 0.0, 0.0, 0.0));
    ServoOutput out;
    for (int i = 0; i < 50; ++i) {
        out = controller.step(input);
        input.X_Base_Sensor = out.X_Base_Sensor;
    }
    ASSERT_GT(out.integral[kZ], 0.0);
    // The object keeps the array from reaching the commanded pose.
    input.X_Base_Sensor.translation() += Vector3d(0.001, 0.0, 0.004);
    const Isometry3d measured = input.X_Base_Sensor;
    input.hold = true;
    const ServoOutput held = controller.step(input);
    EXPECT_EQ(held.X_Base_Sensor.matrix(), measured.matrix());
    // It lets go there and does not drift.
    input.X_Base_Sensor.translation() += Vector3d(0.0, 0.0, 0.01);
    EXPECT_EQ(controller.step(input).X_Base_Sensor.matrix(), measured.matrix());
    EXPECT_EQ(held.twist_Sensor.norm(), 0.0);
    EXPECT_EQ(held.actual, out.actual); // the features are still reported
    input.hold = false;
    EXPECT_EQ(controller.step(input).integral[kZ], 0.0);
}

TEST(ServoController, gainsAndTasksChangeWhileItRunsWithinLimits) {
    ServoController controller = controllerOf(exploreTask(5.0, 0.005));
    const auto light = feel(ContactType::edge, 4.0, 0.0, 0.0, 0.0, 0.0);
    ServoOutput out;
    for (int i = 0; i < 50; ++i)
        out = controller.step(inputOf(light));
    ServoTask task = exploreTask(5.0, 0.005);
    task.gains.integral[kZ] = 0.75;
    ASSERT_TRUE(controller.setTask(0, task).has_value());
    const ServoOutput next = controller.step(inputOf(light));
    const double notExplained_m =
        task.normalCompliance_mPerN * (1.0 - std::pow(1.0 - 0.01 * task.gains.proportional[kZ], 50));
    EXPECT_NEAR(next.integral[kZ] - out.integral[kZ], 0.75 * 0.01 * notExplained_m, 1e-12);
    task.gains.proportional[kZ] = 1000.0;
    EXPECT_EQ(controller.setTask(0, task).error(), TaskRefusal::gainTooHigh);
    EXPECT_DOUBLE_EQ(controller.plan().tasks[0].gains.proportional[kZ], 3.0);
    EXPECT_EQ(controller.setTask(1, exploreTask(5.0, 0.005)).error(), TaskRefusal::badReference);
    EXPECT_EQ(controller.enter(1).error(), TaskRefusal::badReference);
}

TEST(ServoController, anArmThatTheTwistDrivesIsWhereItIsMeasured) {
    // It does nothing of what it is told: the command must not run away from it, nor act as a limit.
    ServoController controller = *ServoController::create(planOf(freeMotion(0.05)));
    const Isometry3d here(Eigen::Translation3d(0.1, 0.2, 0.3));
    for (int i = 0; i < 1000; ++i) {
        ServoInput input = inputOf(nothing(), 0.01, here);
        input.bySpeed = true;
        const ServoOutput out = controller.step(input);
        EXPECT_FALSE(out.limits.any()) << out.limits.names();
        EXPECT_DOUBLE_EQ(out.twist_Sensor[kZ], 0.05);
        EXPECT_NEAR((out.X_Base_Sensor.translation() - here.translation()).norm(), 0.05 * 0.01, 1e-12);
    }
}

TEST(ServoController, aStepAllocatesNothing) {
    ServoController controller =
        *ServoController::create(explorePlan(), std::make_shared<LwrArm>(LwrKinematics()));
    ServoInput input = inputOf(kEven);
    LwrVector q_rad;
    q_rad << 0.2, 0.5, -0.3, -1.4, 0.3, 1.0, 0.1;
    input.q_rad = jointVector(q_rad);
    input.X_Base_Sensor = LwrKinematics().X_Base_Tool(q_rad);
    controller.step(input);
    const std::size_t before = teleta::contact::test::allocationCount();
    for (int i = 0; i < 1000; ++i) {
        input.features = i % 100 < 50 ? kEven : nothing();
        input.X_Base_Sensor = controller.step(input).X_Base_Sensor;
    }
    EXPECT_EQ(teleta::contact::test::allocationCount(), before);
}
