// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/impedance_arm.h"
#include "tests/backend/simulation/servo/servo_bodies.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace teleta::simulation {
namespace {

void settle(ImpedanceArm& arm, double duration_s, double step_s = 0.001) {
    for (int i = 0; i < std::lround(duration_s / step_s); ++i)
        arm.step(step_s);
}

} // namespace

TEST(LwrInertia, theStretchedArmTurnsAboutItsBaseAsBarsAndAPointDo) {
    servo::LwrVector q_rad = servo::LwrVector::Zero();
    q_rad[1] = 0.5 * std::numbers::pi; // horizontal
    const LwrMatrix mass = lwrMassMatrix(servo::LwrKinematics().forward(q_rad));
    // 7 kg from 0 to 0.4 m, 6 kg from 0.4 to 0.79 m, 3 kg at 0.868 m, 0.05 kg m^2 in the joint.
    const double expected = 7.0 * 0.4 * 0.4 / 3.0 +
                            6.0 * (std::pow(0.79, 3) - std::pow(0.4, 3)) / (3.0 * 0.39) +
                            3.0 * 0.868 * 0.868 + 0.05;
    EXPECT_NEAR(mass(0, 0), expected, 1e-9);
    EXPECT_TRUE(mass.isApprox(mass.transpose(), 1e-12));
}

TEST(LwrInertia, everyModeHasTheDampingRatioInSingularPosturesToo) {
    servo::Vector6 stiffness;
    stiffness << 1000.0, 1000.0, 1000.0, 200.0, 200.0, 200.0;
    for (const servo::LwrVector& q_rad : {test::lookingDown(), servo::LwrVector(servo::LwrVector::Zero())}) {
        const servo::LwrPosture posture = servo::LwrKinematics().forward(q_rad);
        const LwrMatrix mass = lwrMassMatrix(posture);
        const LwrMatrix spring = posture.jacobian.transpose() * stiffness.asDiagonal() * posture.jacobian;
        const LwrMatrix damping = modalDamping(mass, posture.jacobian, stiffness, 0.7);
        const Eigen::GeneralizedSelfAdjointEigenSolver<LwrMatrix> modes(spring, mass);
        for (int i = 0; i < servo::kLwrJoints; ++i) {
            const servo::LwrVector mode = modes.eigenvectors().col(i);
            const double omega_radPerS = std::sqrt(std::max(modes.eigenvalues()[i], 0.0));
            // D v = 2 zeta omega M v
            EXPECT_NEAR((damping * mode - 1.4 * omega_radPerS * (mass * mode)).norm(), 0.0, 1e-5);
        }
    }
}

TEST(ImpedanceArm, goesToItsReferenceInFreeSpace) {
    ImpedanceArm arm = test::armBefore(WallSurface{}, 0.2, 1200.0);
    const Eigen::Isometry3d goal =
        arm.X_Base_Sensor() *
        servo::expSE3((servo::Twist() << 0.02, -0.01, 0.03, 0.1, -0.05, 0.2).finished());
    arm.setReference(goal);
    settle(arm, 8.0);
    EXPECT_LT(servo::poseDifference(goal, arm.X_Base_Sensor()).norm(), 1e-4);
}

TEST(ImpedanceArm, overshootsAStepAsADampingRatioOf07Does) {
    ImpedanceArm arm = test::armBefore(WallSurface{}, 0.2, 1200.0);
    const double start_m = arm.X_Base_Sensor().translation().z();
    Eigen::Isometry3d goal = arm.X_Base_Sensor();
    goal.translation().z() += 0.01;
    arm.setReference(goal);
    double highest_m = 0.0;
    for (int i = 0; i < 20000; ++i) {
        arm.step(1e-4);
        highest_m = std::max(highest_m, arm.X_Base_Sensor().translation().z() - start_m);
    }
    // exp(-pi zeta / sqrt(1 - zeta^2)) = 4.6 % for one mode; several of different speed overshoot less, and
    // the joints' own damping takes a part.
    EXPECT_GT(highest_m, 0.01);
    EXPECT_LT(highest_m, 0.01 * 1.046);
}

TEST(ImpedanceArm, pressesAWallWithBothSpringsInSeries) {
    ImpedanceArm arm = test::armBefore(WallSurface{}, 0.0, 1200.0);
    Eigen::Isometry3d goal = arm.X_Base_Sensor();
    goal.translation() += 0.01 * goal.linear().col(2);
    arm.setReference(goal);
    settle(arm, 5.0);
    const double array_NPerM = 84.0 * 1200.0;
    EXPECT_NEAR(-arm.contact().wrench_Sensor.z(), 0.01 * 1000.0 * array_NPerM / (1000.0 + array_NPerM), 1e-3);
}

TEST(ImpedanceArm, aTrayComesToRestWhereTheArrayHoldsItsMoment) {
    scene::BarShape bar = test::straightBar();
    ImpedanceArm arm = test::armBefore(BarSurface(bar), 0.0, 2000.0, 1e9, true);
    Eigen::Isometry3d goal = arm.X_Base_Sensor();
    goal.translation() += 0.006 * goal.linear().col(2);
    arm.setReference(goal);
    settle(arm, 3.0);
    const double force_N = -arm.contact().wrench_Sensor.z();
    EXPECT_GT(force_N, 4.0);
    arm.setHinge(0.002, 0.01);
    settle(arm, 5.0);
    // Moment of the array about the hinge's axis, in balance with the torque on the tray.
    const Eigen::Isometry3d& X = arm.X_Base_Sensor();
    const servo::Wrench onArray = arm.contact().wrench_Sensor;
    const Eigen::Vector3d force_Base = X.linear() * onArray.head<3>();
    const Eigen::Vector3d moment_Base =
        X.linear() * onArray.tail<3>() + (X.translation() - arm.object().p_Base_Hinge).cross(force_Base);
    EXPECT_NEAR(arm.object().axis_Base.dot(moment_Base), 0.01, 5e-5);
}

TEST(ImpedanceArm, frictionDragsASlidingArrayByItsShareOfTheForceAgainstTheWay) {
    // The reference goes along the wall at 5 mm/s, 5 mm behind its surface.
    constexpr double kSpeed_mPerS = 0.005;
    constexpr double kCreep_mPerS = 1e-4;
    double lag_m[2] = {};
    double force_N[2] = {};
    for (const int rubs : {0, 1}) {
        ImpedanceArm arm = test::armBefore(WallSurface{}, 0.0, 1200.0, 1e9, false, 0.4 * rubs);
        Eigen::Isometry3d goal = arm.X_Base_Sensor();
        const Eigen::Vector3d along = goal.linear().col(1);
        goal.translation() += 0.005 * goal.linear().col(2);
        arm.setReference(goal);
        settle(arm, 3.0);
        for (int i = 0; i < 4000; ++i) {
            goal.translation() += 0.001 * kSpeed_mPerS * along;
            arm.setReference(goal);
            arm.step(0.001);
        }
        lag_m[rubs] = (goal.translation() - arm.X_Base_Sensor().translation()).dot(along);
        force_N[rubs] = -arm.contact().wrench_Sensor.z();
    }
    EXPECT_NEAR(force_N[1], force_N[0], 0.05);
    const double expected_N = 0.4 * force_N[1] * kSpeed_mPerS / std::hypot(kSpeed_mPerS, kCreep_mPerS);
    EXPECT_NEAR((lag_m[1] - lag_m[0]) * 1000.0, expected_N, 0.03 * expected_N);
}

TEST(ImpedanceArm, whatFrictionCanHoldCreepsAndWhatItCannotSlidesUntilItCan) {
    ImpedanceArm arm = test::armBefore(WallSurface{}, 0.0, 1200.0, 1e9, false, 0.4);
    Eigen::Isometry3d goal = arm.X_Base_Sensor();
    const Eigen::Vector3d along = goal.linear().col(1);
    goal.translation() += 0.005 * goal.linear().col(2);
    arm.setReference(goal);
    settle(arm, 3.0);
    const double held_m = 0.4 * -arm.contact().wrench_Sensor.z() / 1000.0;
    const auto lag_m = [&] { return (goal.translation() - arm.X_Base_Sensor().translation()).dot(along); };
    // Half of what friction holds: it creeps at the share h/sqrt(1 - h^2) of 0.1 mm/s, h = 1/2.
    const double before_m = lag_m();
    goal.translation() += (0.5 * held_m - before_m) * along;
    arm.setReference(goal);
    settle(arm, 0.2);
    EXPECT_GT(lag_m(), 0.5 * held_m - 0.2 * 1e-4);
    // Three times as much: it slides, and its mass carries it on until it sticks; the rest is held.
    goal.translation() += (3.0 * held_m - lag_m()) * along;
    arm.setReference(goal);
    settle(arm, 1.5);
    EXPECT_LT(lag_m(), held_m);
    EXPECT_GT(lag_m(), 0.5 * held_m);
}

} // namespace teleta::simulation
