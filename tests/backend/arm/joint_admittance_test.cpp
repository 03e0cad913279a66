// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/joint_admittance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace teleta::arm;

namespace {

/// Angle after a step of torque on a resting joint, from the textbook solution of M q'' + D q' + K q = tau.
double stepResponse_rad(const AdmittanceParameters& p, double torque_Nm, double time_s) {
    const double final_rad = torque_Nm / p.stiffness_NmPerRad;
    const double natural = std::sqrt(p.stiffness_NmPerRad / p.inertia_kgm2);
    const double ratio = p.damping_NmsPerRad / (2.0 * std::sqrt(p.stiffness_NmPerRad * p.inertia_kgm2));
    if (ratio < 1.0) {
        const double damped = natural * std::sqrt(1.0 - ratio * ratio);
        return final_rad *
               (1.0 - std::exp(-ratio * natural * time_s) *
                          (std::cos(damped * time_s) + ratio * natural / damped * std::sin(damped * time_s)));
    }
    if (ratio > 1.0) {
        const double root = natural * std::sqrt(ratio * ratio - 1.0);
        const double slow = -ratio * natural + root;
        const double fast = -ratio * natural - root;
        return final_rad *
               (1.0 + (fast * std::exp(slow * time_s) - slow * std::exp(fast * time_s)) / (slow - fast));
    }
    return final_rad * (1.0 - std::exp(-natural * time_s) * (1.0 + natural * time_s));
}

/// Largest difference to the closed form over one second.
double worstError_rad(const AdmittanceParameters& parameters, double torque_Nm, double step_s) {
    auto joint = JointAdmittance::create(parameters).value();
    double worst_rad = 0.0;
    const int steps = static_cast<int>(std::lround(1.0 / step_s));
    for (int i = 1; i <= steps; ++i) {
        const JointState state = joint.step(torque_Nm, 0.0, step_s).value();
        worst_rad = std::max(worst_rad,
                             std::abs(state.angle_rad - stepResponse_rad(parameters, torque_Nm, i * step_s)));
    }
    return worst_rad;
}

constexpr AdmittanceParameters kUnderdamped{0.1, 0.5, 10.0};
constexpr AdmittanceParameters kCritical{0.1, 2.0, 10.0};
constexpr AdmittanceParameters kOverdamped{0.1, 8.0, 10.0};

} // namespace

TEST(JointAdmittance, stepResponseIsTheClosedForm) {
    for (const AdmittanceParameters& parameters : {kUnderdamped, kCritical, kOverdamped}) {
        const double final_rad = 0.5 / parameters.stiffness_NmPerRad;
        EXPECT_LE(worstError_rad(parameters, 0.5, 0.001), 1e-4 * final_rad);
    }
}

TEST(JointAdmittance, errorFallsWithTheSquareOfTheStep) {
    for (const AdmittanceParameters& parameters : {kUnderdamped, kCritical, kOverdamped}) {
        const double ratio = worstError_rad(parameters, 0.5, 0.002) / worstError_rad(parameters, 0.5, 0.001);
        EXPECT_GE(ratio, 3.6);
        EXPECT_LE(ratio, 4.4);
    }
}

TEST(JointAdmittance, constantTorqueEndsInTheAngleOfTheSpring) {
    auto joint = JointAdmittance::create(kCritical).value();
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(joint.step(0.7, 0.3, 0.01));
    EXPECT_NEAR(joint.state().angle_rad, 0.3 + 0.07, 1e-14);
    EXPECT_NEAR(joint.state().rate_radPerS, 0.0, 1e-13);
}

TEST(JointAdmittance, withoutInertiaItIsAFirstOrderLag) {
    auto joint = JointAdmittance::create({0.0, 2.0, 10.0}).value();
    for (int i = 1; i <= 1000; ++i) {
        const JointState state = joint.step(1.0, 0.0, 0.001).value();
        const double decay = std::exp(-5.0 * 0.001 * i); // K/D = 5 per s
        EXPECT_NEAR(state.angle_rad, 0.1 * (1.0 - decay), 1e-7);
        EXPECT_NEAR(state.rate_radPerS, 0.5 * decay, 1e-6);
    }
}

TEST(JointAdmittance, withoutInertiaAndDampingTheSpringAnswersAtOnce) {
    auto joint = JointAdmittance::create({0.0, 0.0, 10.0}).value();
    const JointState first = joint.step(1.0, 0.2, 0.005).value();
    EXPECT_NEAR(first.angle_rad, 0.3, 1e-15);
    EXPECT_NEAR(first.rate_radPerS, 60.0, 1e-11) << "0.3 rad in 5 ms";
    EXPECT_NEAR(joint.step(1.0, 0.2, 0.005)->rate_radPerS, 0.0, 1e-11);
}

TEST(JointAdmittance, withoutStiffnessItCreepsAtTorqueOverDamping) {
    auto creeping = JointAdmittance::create({0.0, 2.0, 0.0}).value();
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(creeping.step(1.0, 55.0, 0.01));
    EXPECT_NEAR(creeping.state().angle_rad, 0.5, 1e-14);
    EXPECT_NEAR(creeping.state().rate_radPerS, 0.5, 1e-14);
}

TEST(JointAdmittance, aFreeMassFollowsNewton) {
    auto joint = JointAdmittance::create({0.5, 0.0, 0.0}).value();
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(joint.step(1.0, 0.0, 0.01));
    EXPECT_NEAR(joint.state().rate_radPerS, 2.0, 1e-13);
    EXPECT_NEAR(joint.state().angle_rad, 1.0, 1e-13); // t^2 tau / (2 M)
}

TEST(JointAdmittance, anUndampedSpringKeepsItsPeriod) {
    // Period 2 pi sqrt(M/K) = 0.6283 s. The method's phase lags by (omega h)^2 / 24 or less a radian turned.
    auto joint = JointAdmittance::create({0.1, 0.0, 10.0}, {0.1, 0.0}).value();
    for (int i = 0; i < 6283; ++i)
        ASSERT_TRUE(joint.step(0.0, 0.0, 0.0001));
    EXPECT_NEAR(joint.state().angle_rad, 0.1, 1e-5);
}

TEST(JointAdmittance, refusesWhatHasNoLawOfMotionAndKeepsTheState) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(JointAdmittance::create({0.0, 0.0, 0.0}).error(), AdmittanceRefusal::undetermined);
    EXPECT_EQ(JointAdmittance::create({-0.1, 1.0, 1.0}).error(), AdmittanceRefusal::negative);
    EXPECT_EQ(JointAdmittance::create({0.1, nan, 1.0}).error(), AdmittanceRefusal::notFinite);
    EXPECT_EQ(JointAdmittance::create(kCritical, {nan, 0.0}).error(), AdmittanceRefusal::notFinite);

    auto joint = JointAdmittance::create(kCritical, {0.25, -0.5}).value();
    EXPECT_EQ(joint.step(nan, 0.0, 0.001).error(), AdmittanceRefusal::notFinite);
    EXPECT_EQ(joint.step(0.0, nan, 0.001).error(), AdmittanceRefusal::notFinite);
    EXPECT_EQ(joint.step(0.0, 0.0, nan).error(), AdmittanceRefusal::notFinite);
    EXPECT_EQ(joint.step(0.0, 0.0, 0.0).error(), AdmittanceRefusal::badStep);
    EXPECT_EQ(joint.step(0.0, 0.0, -0.001).error(), AdmittanceRefusal::badStep);
    EXPECT_EQ(joint.step(0.0, 0.0, 2.0).error(), AdmittanceRefusal::badStep);
    EXPECT_EQ(joint.setParameters({0.0, 0.0, 0.0}).error(), AdmittanceRefusal::undetermined);
    EXPECT_EQ(joint.setState({0.0, nan}).error(), AdmittanceRefusal::notFinite);
    EXPECT_EQ(joint.state().angle_rad, 0.25);
    EXPECT_EQ(joint.state().rate_radPerS, -0.5);
    EXPECT_EQ(joint.parameters().damping_NmsPerRad, kCritical.damping_NmsPerRad);
}

TEST(JointAdmittance, parametersChangeWhileItMoves) {
    auto joint = JointAdmittance::create(kCritical).value();
    for (int i = 0; i < 500; ++i)
        ASSERT_TRUE(joint.step(1.0, 0.0, 0.01));
    ASSERT_TRUE(joint.setParameters({0.1, 20.0, 100.0}));
    EXPECT_NEAR(joint.state().angle_rad, 0.1, 1e-12) << "the state stays";
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(joint.step(1.0, 0.0, 0.01));
    EXPECT_NEAR(joint.state().angle_rad, 0.01, 1e-12);
}
