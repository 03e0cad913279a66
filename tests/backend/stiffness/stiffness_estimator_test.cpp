// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/simulated_touch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace teleta::stiffness;
using teleta::stiffness::test::SimulatedTouch;

namespace {

TouchSettings at(double contactDistance_m, Method method = Method::regression) {
    TouchSettings settings;
    settings.contactDistance_m = contactDistance_m;
    settings.contactDistanceSe_m = 0.0;
    settings.method = method;
    return settings;
}

/// A clean ramp from 0 to 0.06 Nm of a joint that feels so many Nm/rad.
std::vector<JointSample> cleanRamp(double joint_NmPerRad, int samples = 121) {
    std::vector<JointSample> log;
    for (int i = 0; i < samples; ++i) {
        const double torque_Nm = 0.06 * i / (samples - 1);
        log.push_back({0.001 * i, torque_Nm / joint_NmPerRad, torque_Nm});
    }
    return log;
}

} // namespace

TEST(StiffnessEstimator, twoPointReproducesTableTwoFromLogsOfTableOne) {
    struct Row {
        double rotation_rad, torqueRise_Nm, contactDistance_m, total_NPerM, object_NPerM;
        Material material;
    };
    // Contact distances that reproduce the printed k_i, see touch_equations_test.
    for (const Row& row : {Row{39.53e-4, 2.98e-2, 0.170, 260.8, 282.0, Material::sponge},
                           Row{10.82e-4, 3.0e-2, 0.170, 959.3, 1325.9, Material::rubberSponge},
                           Row{4.12e-4, 2.79e-2, 0.170, 2343.8, 7223.9, Material::rubber},
                           Row{3.84e-4, 2.92e-2, 0.1755, 2469.0, 8562.9, Material::wood}}) {
        const std::vector<JointSample> log{
            {0.0, 0.1, 0.0}, {0.5, 0.2, 0.021}, {0.6, 0.2 + row.rotation_rad, 0.021 + row.torqueRise_Nm}};
        const auto touch = estimateStiffness(log, at(row.contactDistance_m, Method::twoPoint));
        ASSERT_TRUE(touch);
        ASSERT_TRUE(touch->total.value_NPerM && touch->object.value_NPerM);
        EXPECT_NEAR(*touch->total.value_NPerM, row.total_NPerM, 0.002 * row.total_NPerM);
        EXPECT_NEAR(*touch->object.value_NPerM, row.object_NPerM, 0.002 * row.object_NPerM);
        EXPECT_EQ(touch->material, row.material);
        EXPECT_EQ(touch->samples, 2U);
        EXPECT_NEAR(touch->deltaTheta_rad, row.rotation_rad, 1e-15);
        EXPECT_NEAR(touch->deltaTorque_Nm, row.torqueRise_Nm, 1e-15);
    }
}

TEST(StiffnessEstimator, twoPointTakesTheSamplesNearestToBothBorders) {
    std::vector<JointSample> log;
    for (const double torque_Nm : {0.0, 0.012, 0.018, 0.023, 0.035, 0.046, 0.051, 0.056})
        log.push_back({10.0 * torque_Nm, torque_Nm / 10.0, torque_Nm});
    const auto touch = estimateStiffness(log, at(0.17, Method::twoPoint));
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->deltaTorque_Nm, 0.051 - 0.018, 1e-15);
}

TEST(StiffnessEstimator, bothMethodsFindTheStiffnessOfACleanRamp) {
    for (const Method method : {Method::twoPoint, Method::regression}) {
        for (const double object_NPerM : {1e-3, 1.0, 282.0, 1325.9, 7223.9, 8562.9, 1e5}) {
            const double total_NPerM = 1.0 / (1.0 / object_NPerM + 1.0 / kPaperLinkStiffness_NPerM);
            const auto touch = estimateStiffness(cleanRamp(0.17 * 0.17 * total_NPerM), at(0.17, method));
            ASSERT_TRUE(touch);
            ASSERT_TRUE(touch->object.value_NPerM) << object_NPerM;
            EXPECT_NEAR(*touch->total.value_NPerM, total_NPerM, 1e-10 * total_NPerM);
            EXPECT_NEAR(*touch->object.value_NPerM, object_NPerM, 1e-8 * object_NPerM);
            EXPECT_EQ(touch->samples, method == Method::twoPoint ? 2U : 61U)
                << "0.5 mNm apart, borders included";
            EXPECT_NEAR(touch->deltaTorque_Nm, 0.03, 1e-12);
            EXPECT_NEAR(touch->deltaTorque_Nm / (0.17 * 0.17 * touch->deltaTheta_rad), total_NPerM,
                        1e-9 * total_NPerM);
        }
    }
}

TEST(StiffnessEstimator, theComplianceAloneIsThatOfTheWholeAnswer) {
    SimulatedTouch world;
    world.freeMotion_s = 1.0;
    for (const Method method : {Method::twoPoint, Method::regression}) {
        for (const double object_NPerM : {282.0, 1325.9, 8562.9}) {
            world.objectCompliance_mPerN = 1.0 / object_NPerM;
            const std::vector<JointSample> log = world.record(7);
            const auto touch = estimateStiffness(log, at(world.contactDistance_m, method));
            const auto compliance_mPerN = estimateObjectCompliance(log, at(world.contactDistance_m, method));
            ASSERT_TRUE(touch && compliance_mPerN);
            EXPECT_EQ(*compliance_mPerN, touch->objectCompliance.value_mPerN);
        }
    }
    EXPECT_EQ(estimateObjectCompliance({}, at(0.17)).error(), Refusal::noSamples);
    EXPECT_EQ(estimateObjectCompliance(cleanRamp(10.0), at(0.0)).error(), Refusal::notPositive);
    std::vector<JointSample> gentle = cleanRamp(10.0);
    gentle.resize(30);
    EXPECT_EQ(estimateObjectCompliance(gentle, at(0.17)).error(), Refusal::windowNotReached);
}

TEST(StiffnessEstimator, windowIsConfigurable) {
    TouchSettings settings = at(0.17);
    settings.window = {0.01, 0.03};
    const auto touch = estimateStiffness(cleanRamp(20.0), settings);
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->samples, 41U);
    EXPECT_NEAR(touch->deltaTorque_Nm, 0.02, 1e-12);
}

TEST(StiffnessEstimator, aReferenceTorqueIsTakenOff) {
    auto log = cleanRamp(20.0);
    for (JointSample& sample : log)
        sample.torque_Nm += 1.5;
    TouchSettings settings = at(0.17);
    settings.torqueReference_Nm = 1.5;
    const auto touch = estimateStiffness(log, settings);
    ASSERT_TRUE(touch && touch->total.value_NPerM);
    EXPECT_NEAR(*touch->total.value_NPerM, 20.0 / (0.17 * 0.17), 1e-6);
    EXPECT_EQ(touch->samples, 61U);
}

TEST(StiffnessEstimator, freeMotionUnloadingAndASecondTouchDoNotMoveTheAnswer) {
    auto log = cleanRamp(20.0);
    const auto alone = estimateStiffness(log, at(0.17));
    // Unloads along a much softer line (hysteresis), then meets something harder.
    for (int i = 1; i <= 60; ++i)
        log.push_back({0.12 + 0.001 * i, 0.003 - 0.00002 * i, 0.06 - 0.001 * i});
    for (int i = 0; i <= 60; ++i)
        log.push_back({0.30 + 0.001 * i, 0.002 + 0.00001 * i, 0.001 * i});
    const auto touch = estimateStiffness(log, at(0.17));
    ASSERT_TRUE(alone && touch);
    EXPECT_NEAR(*touch->total.value_NPerM, *alone->total.value_NPerM, 1e-9 * *alone->total.value_NPerM);
    EXPECT_EQ(touch->samples, alone->samples);
}

TEST(StiffnessEstimator, aTouchFromTheOtherSideHasTheSameStiffness) {
    auto log = cleanRamp(20.0);
    const auto forward = estimateStiffness(log, at(0.17));
    for (JointSample& sample : log) {
        sample.torque_Nm = -sample.torque_Nm;
        sample.angle_rad = -sample.angle_rad;
    }
    const auto backward = estimateStiffness(log, at(0.17));
    ASSERT_TRUE(forward && backward);
    EXPECT_EQ(*forward->object.value_NPerM, *backward->object.value_NPerM);
}

TEST(StiffnessEstimator, materialSafetyAndIntervalFollowTheObject) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 282.0;
    const auto sponge = estimateStiffness(world.record(1), at(0.17));
    ASSERT_TRUE(sponge);
    EXPECT_EQ(sponge->material, Material::sponge);
    EXPECT_TRUE(sponge->materialCertain);
    EXPECT_LT(*sponge->object.lower95_NPerM, *sponge->object.value_NPerM);
    EXPECT_GT(*sponge->object.upper95_NPerM, *sponge->object.value_NPerM);

    world.objectCompliance_mPerN = 1.0 / kRubberToWood_NPerM;
    const auto border = estimateStiffness(world.record(1), at(0.17));
    ASSERT_TRUE(border);
    EXPECT_FALSE(border->materialCertain) << "the interval holds the border of two classes";

    world.objectCompliance_mPerN = 0.0;
    const auto aluminium = estimateStiffness(world.record(1), at(0.17));
    ASSERT_TRUE(aluminium);
    EXPECT_TRUE(aluminium->object.onlyBound());
    EXPECT_GT(*aluminium->object.lower95_NPerM, kWoodToMetal_NPerM);
    EXPECT_EQ(aluminium->material, Material::metal);
    EXPECT_TRUE(aluminium->materialCertain);
    EXPECT_FALSE(aluminium->stifferThanLink);
}

TEST(StiffnessEstimator, knownNoiseGivesTwoSamplesAStandardError) {
    const std::vector<JointSample> log{{0.0, 0.0, 0.02}, {1.0, 0.001, 0.05}};
    TouchSettings settings = at(0.2, Method::twoPoint);
    const auto unknown = estimateStiffness(log, settings);
    ASSERT_TRUE(unknown);
    EXPECT_FALSE(unknown->total.se_NPerM) << "two samples do not tell their noise";
    EXPECT_NEAR(unknown->total.value_NPerM.value(), 750.0, 1e-9);

    settings.torqueNoise_Nm = 0.0003;
    settings.angleNoise_rad = 0.0;
    const auto known = estimateStiffness(log, settings);
    ASSERT_TRUE(known);
    // k = dTau / (P^2 dTheta), each torque off by 0.3 mNm of 30: sqrt(2) %.
    EXPECT_NEAR(known->total.se_NPerM.value(), std::sqrt(2.0) * 7.5, 1e-6);
    settings.method = Method::regression;
    EXPECT_EQ(estimateStiffness(log, settings).error(), Refusal::tooFewSamples);
}

TEST(StiffnessEstimator, scatterLargerThanTheKnownNoiseCounts) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 1325.9;
    TouchSettings settings = at(0.17);
    settings.torqueNoise_Nm = 0.00001;
    settings.angleNoise_rad = 0.0;
    const auto touch = estimateStiffness(world.record(5), settings);
    const auto fromScatter = estimateStiffness(world.record(5), at(0.17));
    ASSERT_TRUE(touch && fromScatter);
    EXPECT_NEAR(*touch->total.se_NPerM, *fromScatter->total.se_NPerM, 0.02 * *fromScatter->total.se_NPerM);
}

TEST(StiffnessEstimator, anAngleThatDoesNotChangeIsABoundAtTheLinkStiffness) {
    auto log = cleanRamp(20.0);
    for (JointSample& sample : log)
        sample.angle_rad = 0.25;
    for (const Method method : {Method::twoPoint, Method::regression}) {
        const auto touch = estimateStiffness(log, at(0.17, method));
        ASSERT_TRUE(touch);
        EXPECT_TRUE(touch->total.onlyBound());
        EXPECT_TRUE(touch->object.onlyBound());
        EXPECT_NEAR(touch->object.lower95_NPerM.value(), kPaperLinkStiffness_NPerM, 1e-9);
        EXPECT_TRUE(touch->stifferThanLink);
        EXPECT_EQ(touch->material, Material::metal);
        EXPECT_EQ(touch->deltaTheta_rad, 0.0);
    }
}

TEST(StiffnessEstimator, aTotalStifferThanTheLinkIsABoundThatSaysSo) {
    // k_i = 4000 over k_ri = 3468.6: c_o = -3.83e-5 m/N, so at least 1 / 3.83e-5.
    const auto touch = estimateStiffness(cleanRamp(0.17 * 0.17 * 4000.0), at(0.17));
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->total.value_NPerM.value(), 4000.0, 1e-6);
    EXPECT_TRUE(touch->object.onlyBound());
    EXPECT_TRUE(touch->stifferThanLink);
    EXPECT_NEAR(touch->object.lower95_NPerM.value(), 1.0 / (1.0 / 3468.6 - 1.0 / 4000.0), 1e-3);
}

TEST(StiffnessEstimator, refusesWhatItCannotAnswer) {
    const auto log = cleanRamp(20.0);
    const auto error = [](const std::vector<JointSample>& samples, const TouchSettings& settings) {
        return estimateStiffness(samples, settings).error();
    };
    TouchSettings settings = at(0.17);
    EXPECT_EQ(error({}, settings), Refusal::noSamples);
    EXPECT_EQ(error({{0.0, 0.0, 0.03}}, settings), Refusal::tooFewSamples);
    EXPECT_EQ(error({{0.0, 0.0, 0.0}, {1.0, 1.0, 0.019}}, settings), Refusal::windowNotReached);
    EXPECT_EQ(error({{0.0, 0.0, 0.03}, {1.0, 1.0, 0.03}, {2.0, 2.0, 0.03}}, settings),
              Refusal::torqueUnchanged);
    EXPECT_EQ(error(log, at(0.0)), Refusal::notPositive);
    EXPECT_EQ(error(log, at(-0.17)), Refusal::notPositive);
    settings.linkStiffness_NPerM = 0.0;
    EXPECT_EQ(error(log, settings), Refusal::notPositive);
    settings = at(0.17);
    settings.linkStiffnessSe_NPerM = -1.0;
    EXPECT_EQ(error(log, settings), Refusal::negativeUncertainty);
    settings = at(0.17);
    settings.window = {0.05, 0.02};
    EXPECT_EQ(error(log, settings), Refusal::badWindow);
    settings.window = {-0.02, 0.05};
    EXPECT_EQ(error(log, settings), Refusal::badWindow);
    auto opposed = log;
    for (JointSample& sample : opposed)
        sample.angle_rad = -sample.angle_rad;
    EXPECT_EQ(error(opposed, at(0.17)), Refusal::angleOpposesTorque);
    EXPECT_EQ(error(opposed, at(0.17, Method::twoPoint)), Refusal::angleOpposesTorque);
}

TEST(StiffnessEstimator, twoPointRefusesWhenNoSampleLiesInOneHalfOfTheWindow) {
    const std::vector<JointSample> onlyHigh{{0.0, 0.0, 0.0}, {0.5, 0.1, 0.045}, {0.6, 0.11, 0.055}};
    EXPECT_EQ(estimateStiffness(onlyHigh, at(0.17, Method::twoPoint)).error(), Refusal::windowNotReached);
    const std::vector<JointSample> onlyLow{{0.0, 0.0, 0.0}, {0.5, 0.1, 0.02}, {0.6, 0.11, 0.03}};
    EXPECT_EQ(estimateStiffness(onlyLow, at(0.17, Method::twoPoint)).error(), Refusal::windowNotReached);
}

TEST(StiffnessEstimator, methodNamesAreThoseOfTheCommandLine) {
    EXPECT_EQ(std::string(toString(Method::twoPoint)), "two-point");
    EXPECT_EQ(std::string(toString(Method::regression)), "regression");
    EXPECT_EQ(methodFromString("two-point"), Method::twoPoint);
    EXPECT_EQ(methodFromString("regression"), Method::regression);
    EXPECT_FALSE(methodFromString("twopoint"));
}
