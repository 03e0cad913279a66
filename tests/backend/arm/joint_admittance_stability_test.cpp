// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/joint_admittance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace teleta::arm;

namespace {

constexpr double kSteps_s[] = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 2e-2};
constexpr double kStiffness_NmPerRad[] = {0.0, 1e-9, 1e-3, 1.0, 1e3, 1e6, 1e9};

} // namespace

TEST(JointAdmittanceStability, energyNeverGrowsWithoutInput) {
    std::mt19937_64 random(21);
    std::uniform_real_distribution<double> exponent(-4.0, 3.0);
    std::uniform_real_distribution<double> start(-1.0, 1.0);
    for (const double step_s : kSteps_s) {
        for (const double stiffness : kStiffness_NmPerRad) {
            for (int round = 0; round < 40; ++round) {
                AdmittanceParameters parameters{std::pow(10.0, exponent(random)),
                                                std::pow(10.0, exponent(random)), stiffness};
                if (round % 4 == 1)
                    parameters.damping_NmsPerRad = 0.0;
                if (round % 4 == 2 && stiffness > 0.0)
                    parameters.inertia_kgm2 = 0.0;
                const double reference_rad = start(random);
                auto joint =
                    JointAdmittance::create(parameters, {start(random), 10.0 * start(random)}).value();
                const double first_J = joint.energy_J(reference_rad);
                double last_J = first_J;
                for (int i = 0; i < 300; ++i) {
                    ASSERT_TRUE(joint.step(0.0, reference_rad, step_s));
                    const double energy_J = joint.energy_J(reference_rad);
                    // Rounding of the angle, 1e-16 rad against the reference, is all that may come in.
                    ASSERT_LE(energy_J, last_J * (1.0 + 1e-12) + 1e-28 * stiffness)
                        << "M " << parameters.inertia_kgm2 << " D " << parameters.damping_NmsPerRad << " K "
                        << stiffness << " step " << step_s << " at " << i;
                    last_J = energy_J;
                }
            }
        }
    }
}

TEST(JointAdmittanceStability, stiffSpringSettlesInAFewStepsInsteadOfRinging) {
    for (const double step_s : kSteps_s) {
        auto joint = JointAdmittance::create({0.1, 0.0, 1e9}, {0.1, 0.0}).value();
        for (int i = 0; i < 40; ++i)
            ASSERT_TRUE(joint.step(0.0, 0.0, step_s));
        // omega h is 10 at 0.1 ms and 2000 at 20 ms; undamped in truth, damped by the method.
        EXPECT_LE(std::abs(joint.state().angle_rad), 0.1 * 1e-6) << step_s;
    }
}

TEST(JointAdmittanceStability, torqueGivesTheSameRestAtAnyStepAndStiffness) {
    for (const double step_s : kSteps_s) {
        for (const double stiffness : {1.0, 1e3, 1e6, 1e9}) {
            const double damping = 2.0 * std::sqrt(0.1 * stiffness);
            auto joint = JointAdmittance::create({0.1, damping, stiffness}).value();
            const double settle_s = 60.0 * std::sqrt(0.1 / stiffness);
            const int steps = 100 + static_cast<int>(settle_s / step_s);
            for (int i = 0; i < steps; ++i)
                ASSERT_TRUE(joint.step(2.0, 0.0, step_s));
            EXPECT_NEAR(joint.state().angle_rad * stiffness, 2.0, 1e-9) << step_s << ", " << stiffness;
        }
    }
}

TEST(JointAdmittanceStability, tenMillionStepsDoNotDrift) {
    auto joint = JointAdmittance::create({0.1, 2.0, 10.0}).value();
    for (int i = 0; i < 10'000'000; ++i)
        static_cast<void>(joint.step(0.7, 0.3, 0.001));
    EXPECT_NEAR(joint.state().angle_rad, 0.37, 1e-13);
    EXPECT_NEAR(joint.state().rate_radPerS, 0.0, 1e-12);
}

TEST(JointAdmittanceStability, resultsScale) {
    for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
        auto reference = JointAdmittance::create({0.1, 0.5, 10.0}).value();
        auto law = JointAdmittance::create({0.1 * scale, 0.5 * scale, 10.0 * scale}).value();
        auto torque = reference;
        for (int i = 0; i < 200; ++i) {
            ASSERT_TRUE(reference.step(0.5, 0.0, 0.001) && law.step(0.5 * scale, 0.0, 0.001) &&
                        torque.step(0.5 * scale, 0.0, 0.001));
            const double angle_rad = reference.state().angle_rad;
            EXPECT_NEAR(law.state().angle_rad, angle_rad, 1e-12 * angle_rad);
            EXPECT_NEAR(torque.state().angle_rad, scale * angle_rad, 1e-12 * scale * angle_rad);
        }
    }
}

TEST(JointAdmittanceStability, lawsTowardsNoInertiaNoDampingAndNoStiffnessStayDefined) {
    for (int decade = 0; decade >= -12; --decade) {
        const double small = std::pow(10.0, decade);
        for (const AdmittanceParameters& parameters :
             {AdmittanceParameters{small, 0.0, 10.0}, AdmittanceParameters{small, 2.0, 10.0},
              AdmittanceParameters{0.0, small, 10.0}, AdmittanceParameters{0.1, small, 10.0},
              AdmittanceParameters{0.1, 2.0, small}, AdmittanceParameters{0.0, 2.0, small}}) {
            auto joint = JointAdmittance::create(parameters).value();
            for (int i = 0; i < 100; ++i) {
                const auto state = joint.step(0.5, 0.0, 0.02);
                ASSERT_TRUE(state);
                EXPECT_LE(std::abs(state->angle_rad), 20.0);
            }
        }
    }
}

TEST(JointAdmittanceStability, numbersThatCannotBeReckonedWithAreRefused) {
    const double largest = std::numeric_limits<double>::max();
    EXPECT_EQ(JointAdmittance::create({largest, 0.0, 0.0}).error(), AdmittanceRefusal::outOfRange);
    EXPECT_EQ(JointAdmittance::create({0.1, 0.0, 0.0}, {largest, 0.0}).error(),
              AdmittanceRefusal::outOfRange);
    auto joint = JointAdmittance::create({0.1, 2.0, 10.0}).value();
    EXPECT_EQ(joint.step(largest, 0.0, 0.001).error(), AdmittanceRefusal::outOfRange);
    EXPECT_EQ(joint.step(0.0, -largest, 0.001).error(), AdmittanceRefusal::outOfRange);
    auto weightless = JointAdmittance::create({0.0, 0.0, std::numeric_limits<double>::denorm_min()}).value();
    EXPECT_EQ(weightless.step(1.0, 0.0, 0.001).error(), AdmittanceRefusal::outOfRange);
    auto light = JointAdmittance::create({1e-300, 0.0, 0.0}).value();
    EXPECT_EQ(light.step(1.0, 0.0, 0.001).error(), AdmittanceRefusal::outOfRange);
    EXPECT_EQ(light.state().angle_rad, 0.0);
}
