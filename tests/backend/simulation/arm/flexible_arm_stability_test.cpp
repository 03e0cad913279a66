// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/joint_admittance.h"
#include "backend/core/random_stream.h"
#include "backend/simulation/arm/flexible_arm.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace teleta::simulation {

namespace {

using arm::JointVector;

constexpr double kElbow_rad = 1.8;

/// Objects around the bent forearm, each a few millimetres away: a post in front of it, a box behind it and a
/// corner at its end.
std::vector<TouchedBody> surroundings(double stiffness_NPerM) {
    const scene::ArmBody arms;
    const Eigen::Vector2d along(std::cos(kElbow_rad), std::sin(kElbow_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    std::vector<TouchedBody> bodies;
    const auto add = [&](const scene::Outline& outline, double distance_m, double aside_m, double turn_rad) {
        const Eigen::Vector2d centre_m =
            Eigen::Vector2d(arms.upperArmLength_m, 0.0) + distance_m * along + aside_m * across;
        const scene::ArmObject object{.name = "body",
                                      .outline = outline,
                                      .x_m = centre_m.x(),
                                      .y_m = centre_m.y(),
                                      .angle_rad = kElbow_rad + turn_rad,
                                      .stiffness_NPerM = stiffness_NPerM};
        bodies.push_back(
            {.outline = OutlineGeometry(object), .stiffness_NPerM = stiffness_NPerM, .doublingDepth_m = {}});
    };
    add(scene::RoundOutline{0.02}, 0.17, 0.053, 0.0);
    add(scene::RectangleOutline{0.06, 0.04}, 0.12, -0.056, 0.1);
    add(scene::TriangleOutline{0.08}, 0.37, 0.01, 3.141592653589793);
    return bodies;
}

scene::ArmBody body(double dampingTime_s) {
    scene::ArmBody body;
    body.jointDampingTime_s = dampingTime_s;
    body.start_rad = {1.5707963267948966, 0.0, 0.0, kElbow_rad};
    return body;
}

class ArmEnergy : public testing::TestWithParam<std::tuple<double, double, bool>> {};

} // namespace

TEST_P(ArmEnergy, neverGrowsWithoutAMotorThatMoves) {
    const auto [step_s, stiffness_NPerM, admittance] = GetParam();
    const scene::JointControl control = admittance
                                            ? scene::JointControl(scene::AdmittanceControl{0.05, 0.0, 20.0})
                                            : scene::JointControl(scene::PositionControl{60.0});
    core::RandomStream random(11, "energy");
    int touched = 0;
    constexpr int kThrows = teleta::test::kSanitized ? 2 : 6;
    for (int throwNumber = 0; throwNumber < kThrows; ++throwNumber) {
        const scene::ArmBody undamped = body(throwNumber % 2 == 0 ? 0.0 : 0.03);
        FlexibleArm arm(undamped, control, surroundings(stiffness_NPerM));
        const JointVector reference_rad = Eigen::Map<const JointVector>(undamped.start_rad.data());
        ArmState state = arm.state();
        for (int j = 0; j < 4; ++j) {
            state.linkRate_radPerS[j] = 4.0 * random.normal();
            state.link_rad[j] += 0.02 * random.normal();
        }
        arm.setState(state);
        double energy_J = arm.energy_J(reference_rad);
        const double start_J = energy_J;
        const int steps = static_cast<int>(std::min(2000.0, 4.0 / step_s));
        for (int i = 0; i < steps; ++i) {
            arm.step(step_s, reference_rad);
            const double next_J = arm.energy_J(reference_rad);
            ASSERT_TRUE(std::isfinite(next_J));
            // Rounding of contact depths (1e-16 m) and of joint angles is all that may show.
            ASSERT_LE(next_J, energy_J + 1e-9 * start_J) << "step " << i << ", throw " << throwNumber;
            energy_J = next_J;
            for (const BodyContact& contact : arm.contacts())
                touched += contact.force_N > 0.0 ? 1 : 0;
        }
        EXPECT_LT(energy_J, start_J);
    }
    EXPECT_GT(touched, 0);
}

INSTANTIATE_TEST_SUITE_P(StepsAndStiffness, ArmEnergy,
                         testing::Combine(testing::Values(0.0001, 0.001, 0.005, 0.02),
                                          testing::Values(10.0, 1e3, 1e6, 1e9), testing::Bool()));

TEST(ArmStability, pressesAgainstAnythingAtAnyStepWithoutLosingIt) {
    // The elbow is told to go 0.02 rad into a post; in the end the torques of spring and contact balance.
    for (const double stiffness_NPerM : {10.0, 1e3, 1e5, 1e7, 1e9}) {
        for (const double step_s : {0.0001, 0.001, 0.02}) {
            if (teleta::test::kSanitized && step_s < 0.001)
                continue; // 30 000 steps like those of the other lengths
            scene::ArmBody arms = body(0.03);
            FlexibleArm arm(arms, scene::PositionControl{60.0}, surroundings(stiffness_NPerM));
            JointVector reference_rad = Eigen::Map<const JointVector>(arms.start_rad.data());
            double limit_rad = reference_rad[3];
            while (arm.contactAt(reference_rad, arm.bodies()[0]).depth_m < 0.0)
                reference_rad[3] = limit_rad += 0.001;
            reference_rad[3] += 0.02;
            const int steps = static_cast<int>(3.0 / step_s);
            for (int i = 0; i < steps; ++i)
                arm.step(step_s, reference_rad);
            const BodyContact& contact = arm.contacts()[0];
            ASSERT_GT(contact.force_N, 0.0);
            EXPECT_NEAR(arm.torque_Nm()[3], contact.force_N * contact.along_m,
                        1e-6 * arm.torque_Nm()[3] + 1e-7)
                << stiffness_NPerM << " N/m, " << step_s << " s";
            EXPECT_LT(arm.state().linkRate_radPerS.norm(), 1e-6);
        }
    }
}

TEST(ArmStability, followsTheLawOfTheJointAdmittance) {
    // A stiff joint with almost no link: motor and link move as arm::JointAdmittance says.
    scene::ArmBody light = body(0.0);
    light.forearmMass_kg = light.upperArmMass_kg = 1e-9;
    light.jointInertia_kgm2 = 1e-9;
    light.jointStiffness_NmPerRad = {1e7, 1e7, 1e7, 1e7};
    const arm::AdmittanceParameters law{0.1, 1.0, 10.0};
    auto joint = arm::JointAdmittance::create(law);
    ASSERT_TRUE(joint);
    FlexibleArm arm(light, scene::AdmittanceControl{0.1, 1.0, 10.0}, {});
    const JointVector reference_rad = Eigen::Map<const JointVector>(light.start_rad.data());
    const double torque_Nm = 0.5;
    JointVector external_Nm = JointVector::Zero();
    external_Nm[3] = torque_Nm;
    double worst_rad = 0.0;
    for (int i = 0; i < 20000; ++i) {
        arm.step(0.0001, reference_rad, external_Nm);
        const auto state = joint->step(torque_Nm, 0.0, 0.0001);
        ASSERT_TRUE(state);
        worst_rad =
            std::max(worst_rad, std::abs(arm.state().motor_rad[3] - reference_rad[3] - state->angle_rad));
    }
    // Backward Euler is of first order: its error here is about step times rate, 1e-4 s 0.3 rad/s.
    EXPECT_LT(worst_rad, 1e-4);
    EXPECT_NEAR(arm.state().motor_rad[3] - reference_rad[3], torque_Nm / 10.0, 1e-4);
}

TEST(ArmStability, keepsTheEnergyOfFreeLinks) {
    // Joints so soft that the links fly: the turn by velocity torques neither adds nor takes energy.
    scene::ArmBody loose = body(0.0);
    loose.jointStiffness_NmPerRad = {1e-9, 1e-9, 1e-9, 1e-9};
    FlexibleArm arm(loose, scene::PositionControl{60.0}, {});
    const JointVector reference_rad = Eigen::Map<const JointVector>(loose.start_rad.data());
    ArmState state = arm.state();
    state.linkRate_radPerS = {0.5, -1.0, 0.7, 2.0};
    arm.setState(state);
    const double start_J = arm.energy_J(reference_rad);
    for (int i = 0; i < 10000; ++i)
        arm.step(0.001, reference_rad);
    EXPECT_NEAR(arm.energy_J(reference_rad), start_J, 1e-6 * start_J);
}

} // namespace teleta::simulation
