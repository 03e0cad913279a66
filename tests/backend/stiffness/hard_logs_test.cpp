// SPDX-License-Identifier: GPL-3.0-or-later
// Logs that a user may have by mistake. Every call runs with floating-point exceptions trapped.
#include "backend/stiffness/free_motion.h"
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/disturbed_touch.h"
#include "tests/backend/stiffness/simulated_touch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace teleta::stiffness;
using namespace teleta::stiffness::test;

namespace {

tl::expected<TouchStiffness, Refusal> answerTo(const std::vector<JointSample>& log) {
    TouchSettings settings;
    settings.contactDistance_m = 0.17;
    return estimateStiffness(log, settings);
}

SimulatedTouch touchOf(double object_NPerM) {
    SimulatedTouch world;
    world.objectCompliance_mPerN = 1.0 / object_NPerM;
    world.freeMotion_s = 1.0;
    return world;
}

} // namespace

TEST(HardLogs, aConstantTorqueIsRefused) {
    for (const double torque_Nm : {0.0, 0.01, 0.035, 0.3}) {
        std::vector<JointSample> log;
        for (int i = 0; i < 1000; ++i)
            log.push_back({0.001 * i, 1e-5 * i, torque_Nm});
        const auto touch = answerTo(log);
        ASSERT_FALSE(touch) << torque_Nm;
        EXPECT_TRUE(touch.error() == Refusal::windowNotReached || touch.error() == Refusal::torqueUnchanged)
            << torque_Nm << ": " << toString(touch.error());
    }
}

TEST(HardLogs, anOffsetLargerThanTheWindowIsTakenOff) {
    for (const double offset_Nm : {-5.0, -0.1, 0.1, 5.0}) {
        SimulatedTouch world = touchOf(282.0);
        world.torqueReference_Nm = offset_Nm;
        const auto touch = answerTo(world.record(1));
        ASSERT_TRUE(touch) << offset_Nm;
        EXPECT_NEAR(*touch->object.value_NPerM, 282.0, 0.02 * 282.0);
        EXPECT_TRUE(touch->has(TouchWarning::torqueOffset));
        EXPECT_NEAR(touch->torqueReference_Nm, offset_Nm, 0.0002);
    }
}

// The noise bends any line somewhere, which must not be taken for the end of a free motion.
TEST(HardLogs, aTorqueThatRisesFromTheStartHasNoFreeMotion) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise;
    for (int i = 0; i < 500; ++i) {
        const int samples = i % 2 == 0 ? 200 : 2000;
        std::vector<JointSample> log;
        for (int j = 0; j < samples; ++j) {
            const double torque_Nm = 0.06 * j / samples;
            log.push_back({0.001 * j, torque_Nm / 40.0, torque_Nm + 5e-4 * noise(random)});
        }
        EXPECT_FALSE(findFreeMotion(log, TorqueWindow{})) << i;
    }
}

TEST(HardLogs, stepsLargerThanTheWindowAreRefusedOrNotReliable) {
    for (const double step_Nm : {0.02, 0.03, 0.05, 0.2}) {
        auto log = touchOf(282.0).record(1);
        for (JointSample& sample : log)
            sample.torque_Nm = step_Nm * std::round(sample.torque_Nm / step_Nm);
        const auto touch = answerTo(log);
        if (touch) {
            EXPECT_FALSE(touch->reliable) << step_Nm;
        }
    }
}

TEST(HardLogs, anAngleThatIsCoarserThanTheRotationIsNotReliable) {
    auto log = touchOf(1325.9).record(1);
    for (JointSample& sample : log)
        sample.angle_rad = 0.002 * std::round(sample.angle_rad / 0.002);
    const auto touch = answerTo(log);
    if (touch) {
        EXPECT_TRUE(!touch->reliable || touch->object.onlyBound());
    }
}

TEST(HardLogs, timeThatGoesBackwardsIsPutInOrder) {
    auto log = touchOf(282.0).record(1);
    const auto inOrder = answerTo(log);
    std::ranges::reverse(log);
    const auto reversed = answerTo(log);
    ASSERT_TRUE(inOrder && reversed);
    EXPECT_EQ(inOrder->object.value_NPerM, reversed->object.value_NPerM);
    // A clock that was set back by a second within the free motion: rows of both seconds are mixed.
    auto setBack = touchOf(282.0).record(1);
    for (std::size_t i = 500; i < setBack.size(); ++i)
        setBack[i].time_s -= 0.4;
    const auto touch = answerTo(setBack);
    if (touch) {
        EXPECT_GT(*touch->object.lower95_NPerM, 0.0);
        EXPECT_TRUE(std::isfinite(*touch->object.lower95_NPerM));
    }
}

TEST(HardLogs, samplingThatChangesWithinTheLogKeepsTheAnswer) {
    SimulatedTouch world = touchOf(282.0);
    const auto all = world.record(1);
    std::vector<JointSample> log;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i < all.size() / 2 || i % 5 == 0)
            log.push_back(all[i]);
    const auto touch = answerTo(log);
    ASSERT_TRUE(touch);
    EXPECT_LE(*touch->object.lower95_NPerM, 282.0);
    EXPECT_GE(*touch->object.upper95_NPerM, 282.0);
}

TEST(HardLogs, twelveDecadesOfStiffnessHaveAValueOrABound) {
    for (int decade = -6; decade <= 6; ++decade) {
        SimulatedTouch world = touchOf(std::pow(10.0, decade));
        // As many samples for each: a soft object is pressed more quickly.
        world.speed_radPerS = 0.03 / (0.17 * 0.17 * world.totalStiffness_NPerM()) / 0.3;
        const auto touch = answerTo(world.record(7));
        ASSERT_TRUE(touch) << decade;
        const double truth = std::pow(10.0, decade);
        EXPECT_TRUE(touch->reliable) << decade;
        EXPECT_LE(touch->object.lower95_NPerM.value(), 1.02 * truth) << decade;
        if (touch->object.upper95_NPerM) {
            EXPECT_GE(*touch->object.upper95_NPerM, 0.98 * truth) << decade;
        }
        EXPECT_EQ(touch->object.onlyBound(), decade >= 6) << decade;
    }
}

TEST(HardLogs, anyLogThatIsCutShortIsAnsweredOrRefused) {
    const auto log = disturbedTouch(Disturbance::standardSolidHeld, 1).log;
    for (std::size_t size = 0; size < log.size(); size += 7) {
        const auto touch = answerTo({log.begin(), log.begin() + static_cast<std::ptrdiff_t>(size)});
        if (touch) {
            EXPECT_TRUE(touch->object.value_NPerM || touch->object.lower95_NPerM);
        }
    }
}

TEST(HardLogs, numbersWithoutSenseAreAnsweredOrRefused) {
    std::mt19937_64 random(5);
    for (int log = 0; log < 300; ++log) {
        std::vector<JointSample> samples(static_cast<std::size_t>(random() % 200));
        const auto number = [&random] {
            const double exponent = std::uniform_real_distribution<double>(-90.0, 90.0)(random);
            return (random() % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, exponent);
        };
        for (JointSample& sample : samples)
            sample = {number(), number(), random() % 3 == 0 ? number() : 0.001 * (random() % 60)};
        const auto touch = answerTo(samples);
        if (touch && touch->object.value_NPerM) {
            EXPECT_TRUE(std::isfinite(*touch->object.value_NPerM));
        }
    }
}
