// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/impedance_arm.h"
#include "tests/backend/simulation/servo/servo_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::simulation {
namespace {

/// Energy after each step is never above the energy before it, but for rounding.
constexpr double kRounding = 1e-12;

void expectPassive(ImpedanceArm arm, double step_s, double duration_s, const std::string& what,
                   double leftOver = 0.05) {
    const double start_J = arm.energy_J();
    double before_J = start_J;
    for (int i = 0; i < std::lround(duration_s / step_s); ++i) {
        arm.step(step_s);
        const double now_J = arm.energy_J();
        ASSERT_TRUE(std::isfinite(now_J)) << what << ", step " << i;
        ASSERT_LE(now_J, before_J + kRounding * (1.0 + start_J)) << what << ", step " << i;
        before_J = now_J;
    }
    EXPECT_LT(before_J, leftOver * start_J) << what;
}

} // namespace

TEST(ImpedanceArmStability, neverGainsEnergyForAnyContactStiffnessAndStep) {
    const std::vector<TouchedShape> shapes{BarSurface(test::straightBar()), BarSurface(test::bentBar()),
                                           BallSurface{0.012}, EdgeSurface{}, WallSurface{}};
    for (const TouchedShape& shape : shapes) {
        for (const double stiffness_NPerM : {10.0, 1e3, 1e5, 1e7, 1e9}) {
            for (const double step_s : {1e-3, 1e-2}) {
                ImpedanceArm arm = test::armBefore(shape, 0.002, stiffness_NPerM);
                test::push(arm, (servo::Twist() << 0.02, 0.01, 0.25, 0.0, 0.1, 0.0).finished());
                expectPassive(std::move(arm), step_s, 2.0,
                              "shape " + std::to_string(shape.index()) + ", " +
                                  std::to_string(stiffness_NPerM) + " N/m, " + std::to_string(step_s) + " s");
            }
        }
    }
}

TEST(ImpedanceArmStability, neverGainsEnergyAtStepsOfATenthOfAMillisecond) {
    for (const double stiffness_NPerM : {10.0, 1e9}) {
        ImpedanceArm arm = test::armBefore(WallSurface{}, 0.001, stiffness_NPerM);
        test::push(arm, (servo::Twist() << 0.0, 0.0, 0.3, 0.0, 0.0, 0.0).finished());
        expectPassive(std::move(arm), 1e-4, 1.5, std::to_string(stiffness_NPerM));
    }
}

TEST(ImpedanceArmStability, neverGainsEnergyWithATrayThatTurns) {
    for (const double stiffness_NPerM : {10.0, 1e3, 1e7}) {
        for (const double step_s : {1e-3, 1e-2}) {
            ImpedanceArm arm =
                test::armBefore(BarSurface(test::straightBar()), 0.002, stiffness_NPerM, 1e9, true);
            test::push(arm, (servo::Twist() << 0.05, 0.0, 0.2, 0.0, 0.3, 0.0).finished());
            expectPassive(std::move(arm), step_s, 2.0, std::to_string(stiffness_NPerM));
        }
    }
}

TEST(ImpedanceArmStability, neverGainsEnergyWithFriction) {
    for (const bool tray : {false, true})
        for (const double friction : {0.1, 1.0})
            for (const double stiffness_NPerM : {10.0, 1e3, 1e7, 1e9})
                for (const double step_s : {1e-4, 1e-3, 1e-2}) {
                    ImpedanceArm arm = test::armBefore(BarSurface(test::straightBar()), 0.002,
                                                       stiffness_NPerM, 1e9, tray, friction);
                    test::push(arm, (servo::Twist() << 0.05, 0.05, 0.25, 0.0, 0.1, 0.1).finished());
                    expectPassive(std::move(arm), step_s, step_s < 1e-3 ? 0.5 : 2.0,
                                  "friction " + std::to_string(friction) + ", " +
                                      std::to_string(stiffness_NPerM) + " N/m, " + std::to_string(step_s) +
                                      " s",
                                  step_s < 1e-3 ? 1.0 : 0.05);
                }
}

TEST(ImpedanceArmStability, comesToRestOnAnObjectOf1e7NPerMAt1kHzAndAt100Hz) {
    for (const double step_s : {1e-3, 1e-2}) {
        ImpedanceArm arm = test::armBefore(WallSurface{}, 0.001, 1e7, 1e7);
        Eigen::Isometry3d goal = arm.X_Base_Sensor();
        goal.translation() += 0.006 * goal.linear().col(2);
        arm.setReference(goal);
        for (int i = 0; i < std::lround(4.0 / step_s); ++i)
            arm.step(step_s);
        double least_N = 1e9;
        double most_N = 0.0;
        for (int i = 0; i < std::lround(1.0 / step_s); ++i) {
            arm.step(step_s);
            least_N = std::min(least_N, -arm.contact().wrench_Sensor.z());
            most_N = std::max(most_N, -arm.contact().wrench_Sensor.z());
        }
        // 5 mm behind the surface at 1000 N/m, and no bouncing.
        EXPECT_NEAR(least_N, 5.0, 0.01) << step_s;
        EXPECT_NEAR(most_N, 5.0, 0.01) << step_s;
    }
}

TEST(ImpedanceArmStability, passesTheStretchedSingularPostureWithoutGainingEnergy) {
    ImpedanceArm arm = test::armBefore(WallSurface{}, 10.0, 1200.0);
    ImpedanceState state;
    state.q_rad.setZero();
    state.rate_radPerS << 0.3, 0.2, -0.3, -0.4, 0.2, 0.3, 0.1;
    arm.setState(state);
    expectPassive(std::move(arm), 1e-3, 10.0, "singular");
}

} // namespace teleta::simulation
