// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/flexible_arm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::simulation {
namespace {

scene::ArmBody stretchedBody() {
    scene::ArmBody body;
    body.start_rad = {0.0, 0.0, 0.0, 0.4};
    body.jointDampingTime_s = 0.0;
    return body;
}

FlexibleArm run(const scene::JointControl& control, double step_s, double duration_s, bool implicit) {
    FlexibleArm arm(stretchedBody(), control, {});
    const arm::JointVector reference(0.01, 0.0, -0.01, 0.42);
    const auto steps = std::lround(duration_s / step_s);
    for (long i = 0; i < steps; ++i) {
        if (implicit)
            arm.step(step_s, reference);
        else
            arm.stepExplicitly(step_s, reference);
    }
    return arm;
}

} // namespace

// Two integrators of the same equations meet as the step shrinks: that of the difference is of first order.
TEST(ExplicitStep, meetsTheImplicitOneAsTheStepShrinks) {
    for (const scene::JointControl& control :
         {scene::JointControl(scene::PositionControl{60.0}),
          scene::JointControl(scene::AdmittanceControl{0.1, 2.0, 10.0})}) {
        const auto difference = [&](double step_s) {
            return (run(control, step_s, 0.02, true).state().motor_rad -
                    run(control, step_s, 0.02, false).state().motor_rad)
                .norm();
        };
        const double coarse = difference(2e-5);
        EXPECT_NEAR(coarse / difference(1e-5), 2.0, 0.5);
        EXPECT_LT(coarse, 1e-4);
    }
}

TEST(ExplicitStep, atRestStaysAtRest) {
    FlexibleArm arm(stretchedBody(), scene::PositionControl{60.0}, {});
    const arm::JointVector start = arm.state().link_rad;
    for (int i = 0; i < 1000; ++i)
        arm.stepExplicitly(1e-5, start);
    EXPECT_EQ(arm.state().link_rad, start);
    EXPECT_EQ(arm.torque_Nm(), arm::JointVector::Zero());
}

} // namespace teleta::simulation
