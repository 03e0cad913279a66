// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/overdriven.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace teleta::pattern;
using teleta::core::Intensities;

namespace {

/// 50 Hz at its start, a fifth of the voltage; 250 Hz at full.
MotorProfile straightMotor() {
    MotorProfile profile;
    profile.startDrive = 0.2;
    profile.riseTime_s = 0.1;
    profile.fallTime_s = 0.1;
    profile.curve = {{0.2, 50.0}, {1.0, 250.0}};
    profile.longestOverdrive_s = 0.2;
    return profile;
}

MotorProfiles all(const MotorProfile& profile) {
    MotorProfiles profiles;
    profiles.fill(profile);
    return profiles;
}

/// The third tactor holds an intensity over the middle second of three.
Pattern held(double intensity) {
    Pattern pattern;
    pattern.duration_s = 3.0;
    pattern.tracks[2] = {{1.0, intensity}, {2.0, intensity}};
    return pattern;
}

Pattern overdrivenOf(const Pattern& pattern, const MotorProfiles& profiles) {
    auto helped = overdriven(pattern, profiles);
    EXPECT_TRUE(helped) << describe(helped.error());
    return helped ? *helped : Pattern{};
}

/// Seconds at intensity 1, sampled in the middle of each step.
double boosted_s(const Pattern& pattern, std::size_t tactor) {
    int steps = 0;
    for (int k = 0; (k + 0.5) * kOverdriveStep_s < pattern.duration_s; ++k)
        steps += evaluate(pattern, (k + 0.5) * kOverdriveStep_s)[tactor] == 1.0 ? 1 : 0;
    return steps * kOverdriveStep_s;
}

/// From the onset at 1 s until the third motor has 90 % of a speed.
double reached_s(const Pattern& pattern, const MotorProfiles& profiles, double speed_Hz) {
    double found_s = 0.0;
    forEachPredictedSample(pattern, profiles, 1000.0,
                           [&](double t_s, const Intensities&, const Intensities& speeds_Hz) {
                               found_s = t_s - 1.0;
                               return speeds_Hz[2] < 0.9 * speed_Hz;
                           });
    return found_s;
}

} // namespace

// At full drive the speed is V (1 - exp(-t ln 10 / rise)) with V = 250 Hz. An intensity of 0.5 is 150 Hz: 90
// % of it, 135 Hz, are reached after t = -rise log10(1 - 135 / 250).
TEST(Overdriven, aMotorRunsAtFullDriveUntilItHasNineTenthsOfItsSpeed) {
    const Pattern helped = overdrivenOf(held(0.5), all(straightMotor()));
    const double reached = -0.1 * std::log10(1.0 - 135.0 / 250.0);
    const double whole_s = std::ceil(reached / kOverdriveStep_s) * kOverdriveStep_s;
    EXPECT_NEAR(boosted_s(helped, 2), whole_s, 1e-9);
    EXPECT_EQ(evaluate(helped, 0.999)[2], 0.0);
    EXPECT_EQ(evaluate(helped, 1.0001)[2], 1.0);
    EXPECT_EQ(evaluate(helped, 1.0 + whole_s - 1e-4)[2], 1.0);
    EXPECT_EQ(evaluate(helped, 1.0 + whole_s + 1e-4)[2], 0.5);
    EXPECT_EQ(evaluate(helped, 1.9999)[2], 0.5);
    EXPECT_EQ(evaluate(helped, 2.0001)[2], 0.0);
    for (const std::size_t other : {0U, 1U, 3U, 4U, 5U})
        EXPECT_TRUE(helped.tracks[other].empty());
}

TEST(Overdriven, theMotorIsPredictedToBeThereSooner) {
    const MotorProfiles profiles = all(straightMotor());
    const double without_s = reached_s(held(0.5), profiles, 150.0);
    const double with_s = reached_s(overdrivenOf(held(0.5), profiles), profiles, 150.0);
    EXPECT_NEAR(without_s, 0.1, 0.0021) << "the rise time";
    EXPECT_NEAR(with_s, -0.1 * std::log10(1.0 - 135.0 / 250.0), 0.0021);
}

TEST(Overdriven, noLongerThanTheProfileAllowsAndNotAtAllWithoutABudget) {
    MotorProfile motor = straightMotor();
    motor.longestOverdrive_s = 0.022; // four steps and a rest
    const Pattern helped = overdrivenOf(held(0.5), all(motor));
    EXPECT_EQ(evaluate(helped, 1.0199)[2], 1.0);
    EXPECT_EQ(evaluate(helped, 1.0201)[2], 0.5) << "the motor is not there yet";
    motor.longestOverdrive_s = 0.0;
    EXPECT_EQ(overdrivenOf(held(0.5), all(motor)), held(0.5));
}

TEST(Overdriven, manyBurstsShareTheBudgetWhichComesBackAtATenth) {
    MotorProfile motor = straightMotor();
    motor.longestOverdrive_s = 0.05;
    Pattern pattern;
    pattern.duration_s = 10.0;
    for (int k = 0; k < 50; ++k)
        pattern.tracks[0].insert(
            pattern.tracks[0].end(),
            {{0.2 * k, 0.0}, {0.2 * k, 0.6}, {0.2 * k + 0.1, 0.6}, {0.2 * k + 0.1, 0.0}});
    const double boosts_s = boosted_s(overdrivenOf(pattern, all(motor)), 0);
    EXPECT_GT(boosts_s, motor.longestOverdrive_s);
    EXPECT_LE(boosts_s, motor.longestOverdrive_s + 0.1 * pattern.duration_s + 1e-9);
}

TEST(Overdriven, whatIsAlreadyFullOrOffStaysAsItIs) {
    EXPECT_EQ(overdrivenOf(held(1.0), all(straightMotor())), held(1.0));
    EXPECT_EQ(overdrivenOf(held(0.0), all(straightMotor())), held(0.0));
    // Balanced down: the full drive cannot be exceeded.
    MotorProfile balanced = straightMotor();
    balanced.fullDrive = 0.6;
    EXPECT_EQ(overdrivenOf(held(1.0), all(balanced)), held(1.0));
    EXPECT_GT(boosted_s(overdrivenOf(held(0.5), all(balanced)), 2), 0.0);
}

TEST(Overdriven, builtInPatternsAreNowhereWeakerNorLongerAndStayWithinOne) {
    for (const Pattern& pattern : builtInPatterns()) {
        const Pattern helped = overdrivenOf(pattern, assumedMotors());
        EXPECT_EQ(helped.duration_s, pattern.duration_s);
        EXPECT_EQ(helped.id, pattern.id);
        for (int k = 0; k < 4000; ++k) {
            const double t_s = pattern.duration_s * (k + 0.37) / 4000.0;
            const Intensities before = evaluate(pattern, t_s);
            const Intensities after = evaluate(helped, t_s);
            const Intensities atStep =
                evaluate(pattern, std::floor(t_s / kOverdriveStep_s + 1e-9) * kOverdriveStep_s);
            for (std::size_t i = 0; i < before.size(); ++i) {
                ASSERT_GE(after[i], before[i] - 2e-3) << pattern.id << " at " << t_s;
                ASSERT_LE(after[i], 1.0);
                if (before[i] == 0.0 && atStep[i] == 0.0) {
                    ASSERT_LT(after[i], 2e-3) << pattern.id << " at " << t_s;
                }
            }
        }
    }
}

TEST(Overdriven, objectsAreHelpedAsTracksAre) {
    Pattern pattern;
    pattern.duration_s = 2.0;
    pattern.objects.push_back({"", Sweep{0.5, 0.3, 0.4, {1, 4}, 0.5}, {}});
    const Pattern helped = overdrivenOf(pattern, all(straightMotor()));
    EXPECT_TRUE(helped.objects.empty());
    EXPECT_GT(boosted_s(helped, 1), 0.0);
    EXPECT_DOUBLE_EQ(boosted_s(helped, 1), boosted_s(helped, 4));
    EXPECT_EQ(boosted_s(helped, 0), 0.0);
}

TEST(Overdriven, aPatternThatIsTooLongIsRefused) {
    Pattern pattern = held(0.5);
    pattern.duration_s = kLongestOverdriven_s + 1.0;
    const auto refused = overdriven(pattern, assumedMotors());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, teleta::core::ErrorKind::refused);
    pattern.duration_s = std::nan("");
    EXPECT_FALSE(overdriven(pattern, assumedMotors()));
}
