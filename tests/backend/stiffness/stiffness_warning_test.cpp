// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/coverage_of_touches.h"
#include "tests/backend/stiffness/simulated_touch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace teleta::stiffness;
using namespace teleta::stiffness::test;

namespace {

TouchStiffness answerTo(Disturbance disturbance, std::uint64_t seed = 3) {
    const DisturbedTouch touch = disturbedTouch(disturbance, seed);
    const auto answer = estimateStiffness(touch.log, settingsOf(touch));
    EXPECT_TRUE(answer) << static_cast<int>(disturbance);
    return answer.value_or(TouchStiffness{});
}

double shareOf(const TouchStiffness& touch, ErrorSource source) {
    for (const ErrorShare& part : touch.errorBudget)
        if (part.source == source)
            return part.share;
    return 0.0;
}

} // namespace

TEST(StiffnessWarning, anUndisturbedTouchHasNone) {
    const TouchStiffness touch = answerTo(Disturbance::none);
    EXPECT_TRUE(touch.warnings.empty());
    EXPECT_TRUE(touch.reliable);
    EXPECT_TRUE(touch.materialKnown());
    EXPECT_EQ(touch.effectiveSamples, static_cast<double>(touch.samples));
    EXPECT_FALSE(touch.tangent_NPerM || touch.secant_NPerM || touch.solid);
}

TEST(StiffnessWarning, anOffsetThatTheFreeMotionShowsIsTakenOffAndTold) {
    const TouchStiffness touch = answerTo(Disturbance::offset30);
    EXPECT_TRUE(touch.has(TouchWarning::torqueOffset));
    EXPECT_TRUE(touch.reliable);
    EXPECT_NEAR(std::abs(touch.torqueReference_Nm), 0.030, 0.0002);
    EXPECT_EQ(touch.torqueDrift_NmPerS, 0.0);
}

TEST(StiffnessWarning, aReferenceThatIsToldIsUsedInsteadOfTheFreeMotion) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 282.0;
    world.torqueReference_Nm = 0.012;
    world.freeMotion_s = 1.0;
    TouchSettings settings;
    settings.contactDistance_m = world.contactDistance_m;
    const auto log = world.record(1);
    const auto byLog = estimateStiffness(log, settings);
    settings.torqueReference_Nm = 0.0;
    const auto told = estimateStiffness(log, settings);
    ASSERT_TRUE(byLog && told);
    EXPECT_NEAR(byLog->torqueReference_Nm, 0.012, 0.0001);
    EXPECT_EQ(told->torqueReference_Nm, 0.0);
    EXPECT_TRUE(told->has(TouchWarning::torqueOffset)) << "the free joint shows that 0 is not its torque";
    settings.torqueReference_Nm = 0.012;
    const auto right = estimateStiffness(log, settings);
    ASSERT_TRUE(right);
    EXPECT_FALSE(right->has(TouchWarning::torqueOffset));
}

TEST(StiffnessWarning, driftAndGravityAreTakenOffAndTold) {
    for (const Disturbance disturbance : {Disturbance::drift, Disturbance::gravity}) {
        const TouchStiffness touch = answerTo(disturbance);
        EXPECT_TRUE(touch.has(TouchWarning::torqueDrift));
        EXPECT_TRUE(touch.reliable);
        // 2 mNm/s; or 1 Nm/rad at 5 mrad/s.
        EXPECT_NEAR(std::abs(touch.torqueDrift_NmPerS), disturbance == Disturbance::drift ? 0.002 : 0.005,
                    0.0005);
        EXPECT_GT(shareOf(touch, ErrorSource::torqueDrift), 0.0);
    }
}

TEST(StiffnessWarning, coarseReadingsAreToldAndNotReliable) {
    const TouchStiffness torque = answerTo(Disturbance::torqueSteps5);
    EXPECT_TRUE(torque.has(TouchWarning::coarseTorque));
    EXPECT_FALSE(torque.reliable);
    EXPECT_FALSE(torque.has(TouchWarning::stickSlip)) << "a step back is no fall";
    EXPECT_GT(shareOf(torque, ErrorSource::quantization), 0.0);
    EXPECT_FALSE(answerTo(Disturbance::torqueSteps1).has(TouchWarning::coarseTorque));
}

TEST(StiffnessWarning, aForceThatDependsOnTheRateIsToldAndNotReliable) {
    const TouchStiffness touch = answerTo(Disturbance::standardSolid, 5);
    EXPECT_TRUE(touch.has(TouchWarning::rateDependent));
    EXPECT_FALSE(touch.reliable);
    EXPECT_FALSE(touch.materialKnown());
    EXPECT_FALSE(touch.materialCertain);
}

TEST(StiffnessWarning, aHardeningObjectIsToldWithItsTangentAndItsSecant) {
    const DisturbedTouch log = disturbedTouch(Disturbance::hertz, 1);
    const TouchStiffness touch = answerTo(Disturbance::hertz, 1);
    EXPECT_TRUE(touch.has(TouchWarning::nonlinear));
    EXPECT_FALSE(touch.reliable);
    ASSERT_TRUE(touch.tangent_NPerM && touch.secant_NPerM);
    EXPECT_NEAR(*touch.secant_NPerM, log.truth_NPerM, 0.05 * log.truth_NPerM);
    // Force over depth to the power 1.5: the tangent grows with the third root of the force.
    EXPECT_GT(*touch.tangent_NPerM, 1.05 * *touch.secant_NPerM);
}

TEST(StiffnessWarning, playThatShowsWhereTheJointTurnsRoundIsTold) {
    const TouchStiffness touch = answerTo(Disturbance::backlash);
    EXPECT_TRUE(touch.has(TouchWarning::stickSlip));
    EXPECT_FALSE(touch.reliable);
}

/// 60 mNm in 240 ms against 5 kN/m; for one sample the torque falls back.
std::vector<JointSample> risesAndFallsBack(double by_Nm, double noise_Nm) {
    constexpr double kDistance_m = 0.175;
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<JointSample> log;
    for (int i = 0; i < 500; ++i) {
        const double torque_Nm = 0.00025 * std::max(0, i - 260);
        log.push_back({1e-3 * i,
                       torque_Nm / (5000.0 * kDistance_m * kDistance_m) + 1e-3 * (i < 260 ? 0.02 * i : 5.2),
                       torque_Nm + noise_Nm * noise(random) - (i == 400 ? by_Nm : 0.0)});
    }
    return log;
}

TEST(StiffnessWarning, aTorqueThatFallsBackInTheRiseIsNotTheObjects) {
    TouchSettings settings;
    settings.contactDistance_m = 0.175;
    settings.linkStiffness_NPerM = 1e9;
    settings.patternsAreErrors = true;
    const auto isTold = [&](double by_Nm, double noise_Nm) {
        const auto touch = estimateStiffness(risesAndFallsBack(by_Nm, noise_Nm), settings);
        EXPECT_TRUE(touch) << by_Nm;
        return touch && touch->has(TouchWarning::stickSlip);
    };
    // A quarter of the window is 7.5 mNm.
    for (const double noise_Nm : {0.0, 0.0005}) {
        EXPECT_FALSE(isTold(0.0, noise_Nm));
        EXPECT_FALSE(isTold(0.005, noise_Nm));
        EXPECT_TRUE(isTold(0.010, noise_Nm));
        EXPECT_TRUE(isTold(0.028, noise_Nm)) << "out of the window, where the rise seems to begin anew";
    }
    EXPECT_FALSE(isTold(0.010, 0.002)) << "8 standard deviations of this noise are 16 mNm";
}

TEST(StiffnessWarning, noiseThatRemembersForLongLeavesTooFewSamples) {
    const DisturbedTouch touch = disturbedTouch(Disturbance::correlated200, 1);
    const auto answer = estimateStiffness(touch.log, settingsOf(touch));
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(), Refusal::tooFewSamples);
}

TEST(StiffnessWarning, anErrorOfTheDistanceEntersTwice) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 282.0;
    world.torqueNoise_Nm = 0.0;
    TouchSettings settings;
    settings.contactDistance_m = world.contactDistance_m;
    settings.contactDistanceSe_m = 0.001;
    const auto touch = estimateStiffness(world.record(1), settings);
    ASSERT_TRUE(touch);
    // dk / k = 2 (k_o / k_i) dP / P with the link's stiffness known by itself.
    const double total_NPerM = world.totalStiffness_NPerM();
    EXPECT_NEAR(*touch->object.se_NPerM / 282.0, 2.0 * 282.0 / total_NPerM * 0.001 / 0.17, 1e-4);
    EXPECT_NEAR(shareOf(*touch, ErrorSource::contactDistance), 1.0, 1e-6);
}

TEST(StiffnessWarning, aPerfectLineStillHasAnIntervalUnlessThePlaceIsExact) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / 1325.9;
    world.torqueNoise_Nm = 0.0;
    TouchSettings settings;
    settings.contactDistance_m = world.contactDistance_m;
    const auto touch = estimateStiffness(world.record(1), settings);
    ASSERT_TRUE(touch);
    EXPECT_LT(*touch->object.lower95_NPerM, 0.999 * *touch->object.value_NPerM);
    EXPECT_GT(*touch->object.upper95_NPerM, 1.001 * *touch->object.value_NPerM);
    settings.contactDistanceSe_m = 0.0;
    const auto exact = estimateStiffness(world.record(1), settings);
    ASSERT_TRUE(exact);
    EXPECT_NEAR(*exact->object.lower95_NPerM, *exact->object.upper95_NPerM, 1e-6 * 1325.9);
    EXPECT_TRUE(exact->reliable);
    EXPECT_TRUE(exact->warnings.empty());
}

TEST(StiffnessWarning, theSharesOfTheErrorAddUpAndFall) {
    const DisturbedTouch log = disturbedTouch(Disturbance::distance, 4);
    TouchSettings settings = settingsOf(log);
    settings.linkStiffnessSe_NPerM = 50.0;
    const auto touch = estimateStiffness(log.log, settings);
    ASSERT_TRUE(touch);
    double sum = 0.0;
    double last = 1.0;
    for (const ErrorShare& part : touch->errorBudget) {
        EXPECT_LE(part.share, last);
        EXPECT_GT(part.share, 0.0);
        last = part.share;
        sum += part.share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_GE(touch->errorBudget.size(), 3U);
}

TEST(StiffnessWarning, namesAreThoseOfTheFiles) {
    EXPECT_EQ(std::string(toString(TouchWarning::rateDependent)), "rate_dependent");
    EXPECT_EQ(std::string(toString(ErrorSource::contactDistance)), "contact_distance");
    for (const TouchWarning warning : kTouchWarnings)
        EXPECT_NE(std::string(toString(warning)), "");
}
