// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/loading_ramp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace teleta::stiffness;

namespace {

constexpr TorqueWindow kWindow;

/// One sample a millisecond.
std::vector<JointSample> logOf(std::initializer_list<double> torques_Nm) {
    std::vector<JointSample> log;
    for (const double torque_Nm : torques_Nm) {
        const auto i = static_cast<double>(log.size());
        log.push_back({0.001 * i, 1e-5 * i, torque_Nm});
    }
    return log;
}

std::vector<double> torquesOf(const std::vector<JointSample>& samples) {
    std::vector<double> torques_Nm;
    std::transform(samples.begin(), samples.end(), std::back_inserter(torques_Nm),
                   [](const JointSample& sample) { return sample.torque_Nm; });
    return torques_Nm;
}

} // namespace

TEST(LoadingRamp, leavesOutFreeMotionUnloadingAndLaterTouches) {
    const auto ramp = loadingRamp(
        logOf({0.0, 0.001, 0.012, 0.022, 0.033, 0.044, 0.052, 0.041, 0.02, 0.0, 0.03, 0.06, 0.0}), kWindow);
    EXPECT_EQ(torquesOf(ramp), (std::vector<double>{0.012, 0.022, 0.033, 0.044, 0.052}));
}

TEST(LoadingRamp, keepsSamplesWhereTheJointHoldsStill) {
    const auto ramp =
        loadingRamp(logOf({0.0, 0.02, 0.04, 0.0501, 0.0503, 0.0499, 0.0503, 0.0498, 0.01}), kWindow);
    EXPECT_EQ(torquesOf(ramp), (std::vector<double>{0.02, 0.04, 0.0501, 0.0503, 0.0499, 0.0503}));
}

TEST(LoadingRamp, endsWhereTheTorqueLeavesTheMarginAboveTheWindow) {
    const auto ramp = loadingRamp(logOf({0.0, 0.03, 0.049, 0.055, 0.064, 0.066, 0.09, 0.1}), kWindow);
    EXPECT_EQ(torquesOf(ramp), (std::vector<double>{0.03, 0.049, 0.055, 0.064}));
}

TEST(LoadingRamp, takesTheHighestRiseWhenNoneReachesTheUpperBorder) {
    const auto ramp = loadingRamp(logOf({0.0, 0.025, 0.0, 0.022, 0.035, 0.0}), kWindow);
    EXPECT_EQ(torquesOf(ramp), (std::vector<double>{0.022, 0.035}));
}

TEST(LoadingRamp, turnsATouchFromTheOtherSideRound) {
    const auto ramp = loadingRamp(logOf({0.0, -0.02, -0.04, -0.055}), kWindow);
    EXPECT_EQ(torquesOf(ramp), (std::vector<double>{0.02, 0.04, 0.055}));
    EXPECT_NEAR(ramp.back().angle_rad, -3e-5, 1e-18);
}

TEST(LoadingRamp, isRelativeToTheReference) {
    const auto ramp = loadingRamp(logOf({0.5, 0.53, 0.55}), kWindow, 0.5);
    ASSERT_EQ(ramp.size(), 2U);
    EXPECT_NEAR(ramp.front().torque_Nm, 0.03, 1e-15);
}

TEST(LoadingRamp, doesNotDependOnTheOrderOfRowsNorOnRepeatedRows) {
    auto log = logOf({0.0, 0.001, 0.015, 0.022, 0.033, 0.044, 0.052, 0.041, 0.0});
    const auto expected = loadingRamp(log, kWindow);
    log.push_back(log[4]);
    log.push_back(log[2]);
    std::shuffle(log.begin(), log.end(), std::mt19937_64(7));
    EXPECT_EQ(loadingRamp(log, kWindow), expected);
}

TEST(LoadingRamp, isEmptyWhenNothingReachesTheWindow) {
    EXPECT_TRUE(loadingRamp({}, kWindow).empty());
    EXPECT_TRUE(loadingRamp(logOf({0.0, 0.01, 0.0199}), kWindow).empty());
}

TEST(EstimateNoise, findsTheNoiseOfBothReadingsOnASteadyRampWithUnevenTimes) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(0.2, 1.8);
    std::vector<JointSample> ramp;
    double time_s = 0.0;
    for (int i = 0; i < 20000; ++i) {
        time_s += 0.001 * uniform(random);
        ramp.push_back({time_s, 0.01 * time_s + 2e-6 * normal(random), 0.5 * time_s + 5e-4 * normal(random)});
    }
    const EstimatedNoise estimate = estimateNoise(ramp);
    // Standard error of a standard deviation: 1 / sqrt(2 x 18/35 x 20000) = 0.7 %; three of them.
    EXPECT_NEAR(estimate.noise.torque_Nm, 5e-4, 0.021 * 5e-4);
    EXPECT_NEAR(estimate.noise.angle_rad, 2e-6, 0.021 * 2e-6);
    EXPECT_NEAR(estimate.degreesOfFreedom, 18.0 / 35.0 * 19998.0, 1e-6);
}

TEST(EstimateNoise, isUnknownForFewerThanThreeSamplesOrEqualTimes) {
    EXPECT_EQ(estimateNoise({}).degreesOfFreedom, 0.0);
    EXPECT_EQ(estimateNoise(logOf({0.02, 0.05})).degreesOfFreedom, 0.0);
    auto log = logOf({0.02, 0.03, 0.04, 0.05});
    for (JointSample& sample : log)
        sample.time_s = 0.0;
    EXPECT_EQ(estimateNoise(log).degreesOfFreedom, 0.0);
}

TEST(EstimateNoise, oneTripleHasOneDegreeOfFreedom) {
    const EstimatedNoise estimate = estimateNoise(logOf({0.02, 0.035, 0.05}));
    EXPECT_EQ(estimate.degreesOfFreedom, 1.0);
    EXPECT_NEAR(estimate.noise.torque_Nm, 0.0, 1e-17);
}
