// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/speed_up.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace teleta::stiffness;

namespace {

constexpr double kRate_radPerS = 0.03;
constexpr double kRest_s = 0.2;
constexpr double kSpeedUp_s = 0.2;
constexpr double kInertia_kgm2 = 0.012;
constexpr double kLowPass_s = 0.03;

/// Rest, half a cosine up to a steady rate, no contact; 1 kHz. The torque is that of the inertia behind a
/// low-pass, integrated with steps of 1/50 of a sample, with an offset of 2 mNm and a drift.
std::vector<JointSample> speedUp(double drift_NmPerS, double torqueNoise_Nm = 0.0,
                                 double angleStep_rad = 0.0) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::vector<JointSample> log;
    double angle_rad = 1.0;
    double inertia_Nm = 0.0;
    constexpr int kParts = 50;
    constexpr double kPart_s = 0.001 / kParts;
    for (int i = 0; i < 600; ++i) {
        const double time_s = 0.001 * i;
        const double read_rad =
            angleStep_rad > 0.0 ? angleStep_rad * std::round(angle_rad / angleStep_rad) : angle_rad;
        log.push_back(
            {time_s, read_rad, 0.002 + drift_NmPerS * time_s + inertia_Nm + torqueNoise_Nm * normal(random)});
        for (int part = 0; part < kParts; ++part) {
            const double phase =
                std::numbers::pi * std::clamp((time_s + part * kPart_s - kRest_s) / kSpeedUp_s, 0.0, 1.0);
            angle_rad += kPart_s * kRate_radPerS * 0.5 * (1.0 - std::cos(phase));
            const double acceleration = 0.5 * kRate_radPerS * std::numbers::pi / kSpeedUp_s * std::sin(phase);
            inertia_Nm += (kInertia_kgm2 * acceleration - inertia_Nm) * kPart_s / kLowPass_s;
        }
    }
    return log;
}

constexpr double kLikelyDrift_NmPerS = 0.05;

} // namespace

TEST(SpeedUp, aDriftIsToldFromTheInertia) {
    for (const double drift_NmPerS : {0.0, 0.01, -0.01}) {
        const std::vector<JointSample> log = speedUp(drift_NmPerS);
        const auto found = findSpeedUp(log, log.size(), kLikelyDrift_NmPerS);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->drift_NmPerS, drift_NmPerS, 5e-4);
        EXPECT_NEAR(found->inertia_kgm2, kInertia_kgm2, 0.02 * kInertia_kgm2);
        EXPECT_NEAR(found->rate_radPerS, kRate_radPerS, 1e-3 * kRate_radPerS);
        const JointSample& last = log[found->first + found->samples - 1];
        EXPECT_NEAR(found->torque_Nm, 0.002 + drift_NmPerS * last.time_s, 2e-5);
    }
}

TEST(SpeedUp, theStandardErrorOfTheDriftIsThatOfItsScatter) {
    // Noise of 0.3 mNm and angles in steps of 0.01 mrad: about as far from the truth as it says.
    const std::vector<JointSample> log = speedUp(0.005, 0.0003, 1e-5);
    const auto found = findSpeedUp(log, log.size(), kLikelyDrift_NmPerS);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->sd_Nm, 0.0003, 3e-5);
    EXPECT_LT(std::abs(found->drift_NmPerS - 0.005), 4.0 * found->driftSe_NmPerS);
    EXPECT_LT(found->driftSe_NmPerS, 0.01);
}

TEST(SpeedUp, aTurnInTheOtherDirectionGivesTheSame) {
    std::vector<JointSample> log = speedUp(0.01);
    const auto forward = findSpeedUp(log, log.size(), kLikelyDrift_NmPerS);
    for (JointSample& sample : log) {
        sample.angle_rad = -sample.angle_rad;
        sample.torque_Nm = -sample.torque_Nm;
    }
    const auto backward = findSpeedUp(log, log.size(), kLikelyDrift_NmPerS);
    ASSERT_TRUE(forward && backward);
    EXPECT_NEAR(backward->drift_NmPerS, -forward->drift_NmPerS, 1e-9);
    EXPECT_NEAR(backward->inertia_kgm2, forward->inertia_kgm2, 1e-9);
}

TEST(SpeedUp, anEvenMotionHasNone) {
    std::vector<JointSample> log;
    for (int i = 0; i < 600; ++i)
        log.push_back({0.001 * i, kRate_radPerS * 0.001 * i, 0.0});
    EXPECT_FALSE(findSpeedUp(log, log.size(), kLikelyDrift_NmPerS));
}

TEST(SpeedUp, aLongMotionNeedsNone) {
    std::vector<JointSample> log = speedUp(0.0);
    const JointSample last = log.back();
    for (int i = 1; i <= 8000; ++i)
        log.push_back({last.time_s + 0.001 * i, last.angle_rad + kRate_radPerS * 0.001 * i, last.torque_Nm});
    EXPECT_FALSE(findSpeedUp(log, log.size(), kLikelyDrift_NmPerS));
}

TEST(SpeedUp, whatTellsNoAccelerationHasNone) {
    const std::vector<JointSample> log = speedUp(0.0);
    EXPECT_FALSE(findSpeedUp({}, 0, kLikelyDrift_NmPerS));
    EXPECT_FALSE(findSpeedUp(log, 10, kLikelyDrift_NmPerS)) << "too few samples";
    EXPECT_FALSE(findSpeedUp(log, 150, kLikelyDrift_NmPerS)) << "at rest";
    const std::vector<JointSample> coarse = speedUp(0.0, 0.0, 3e-3);
    EXPECT_FALSE(findSpeedUp(coarse, coarse.size(), kLikelyDrift_NmPerS)) << "two steps of the angle";
    const std::vector<JointSample> atOnce(100, JointSample{1.0, 0.5, 0.01});
    EXPECT_FALSE(findSpeedUp(atOnce, atOnce.size(), kLikelyDrift_NmPerS)) << "all at one time";
}

TEST(SpeedUp, theAccelerationOfAParabola) {
    std::vector<JointSample> log;
    for (int i = 0; i < 100; ++i)
        log.push_back({0.01 * i, 2.0 - 0.01 * i + 0.5 * 0.3 * std::pow(0.01 * i, 2), 0.0});
    EXPECT_NEAR(accelerationAt(log, 0.5, 0.1).value(), 0.3, 1e-9);
    EXPECT_FALSE(accelerationAt(log, 0.5, 0.01)) << "three samples";
    EXPECT_FALSE(accelerationAt(log, 1.2, 0.3)) << "all on one side";
}
