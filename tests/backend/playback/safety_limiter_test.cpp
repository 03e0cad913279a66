// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/playback/safety_limiter.h"
#include "tests/backend/playback/scripted_bracelet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace teleta;
using core::Drive;
using core::Intensities;
using core::kFullDrive;
using playback::SafetyLimiter;
using playback::SafetyLimits;
using test::all;

namespace {

constexpr double kPeriod_s = 0.005;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Nothing limits but the range.
SafetyLimits free() {
    return {.rise_perS = kInfinity, .heatBudget = 1.0};
}

Drive allDrive(std::uint16_t value) {
    Drive drive;
    drive.fill(value);
    return drive;
}

} // namespace

TEST(SafetyLimiter, clampsToTheRangeAndTakesNanAsOff) {
    SafetyLimiter limiter(free(), kPeriod_s);
    const Drive drive = limiter.step({-0.5, 0.0, 1.0, 1.5, kInfinity, -kInfinity}, kPeriod_s);
    EXPECT_EQ(drive, (Drive{0, 0, kFullDrive, kFullDrive, kFullDrive, 0}));
    EXPECT_EQ(limiter.step(all(kNan), kPeriod_s), allDrive(0));
}

TEST(SafetyLimiter, turnsNanOffAtOnceHoweverSlowAFallIs) {
    SafetyLimits limits = free();
    limits.fall_perS = 0.1;
    SafetyLimiter limiter(limits, kPeriod_s);
    ASSERT_EQ(limiter.step(all(1.0), kPeriod_s), allDrive(kFullDrive));
    const Drive drive = limiter.step({kNan, 0.0, 1.0, 1.0, 1.0, 1.0}, kPeriod_s);
    EXPECT_EQ(drive[0], 0);
    EXPECT_EQ(drive[1], 4092) << "4095 (1 - 0.1 * 0.005) rounded down";
    EXPECT_EQ(drive[2], kFullDrive);
}

TEST(SafetyLimiter, roundsDownSoThatNoLimitIsExceeded) {
    SafetyLimiter limiter(free(), kPeriod_s);
    EXPECT_EQ(limiter.step(all(0.5), kPeriod_s), allDrive(2047)) << "4095 / 2 = 2047.5";
    EXPECT_EQ(limiter.step(all(0.99999), kPeriod_s), allDrive(4094));
    for (int count = 0; count <= kFullDrive; ++count) {
        SafetyLimiter fresh(free(), kPeriod_s);
        ASSERT_EQ(fresh.step(all(static_cast<double>(count) / kFullDrive), kPeriod_s)[0], count);
    }
}

TEST(SafetyLimiter, keepsTheUsersLimitOfEachTactor) {
    SafetyLimits limits = free();
    limits.userLimit = {0.2, 0.4, 0.0, 1.0, kNan, 7.0};
    limits.fall_perS = 0.001;
    SafetyLimiter limiter(limits, kPeriod_s);
    EXPECT_EQ(limiter.step(all(1.0), kPeriod_s), (Drive{819, 1638, 0, kFullDrive, 0, kFullDrive}));
    limits.userLimit.fill(0.1);
    limiter.setLimits(limits);
    const Drive drive = limiter.step(all(1.0), kPeriod_s);
    for (const std::uint16_t value : drive)
        EXPECT_LE(value, 409) << "a limit that is lowered holds at once, also where a fall is slow";
}

TEST(SafetyLimiter, risesNoFasterThanTheSlewLimit) {
    SafetyLimits limits = free();
    limits.rise_perS = 20.0;
    SafetyLimiter limiter(limits, kPeriod_s);
    // 20 / s in steps of 5 ms: a tenth each.
    for (int k = 1; k <= 10; ++k)
        EXPECT_NEAR(limiter.step(all(1.0), kPeriod_s)[3], std::min(0.1 * k, 1.0) * kFullDrive, 1.0) << k;
    EXPECT_EQ(limiter.step(all(0.0), kPeriod_s), allDrive(0)) << "falling is not limited by default";
    EXPECT_NEAR(limiter.step(all(1.0), 3600.0)[0], 0.2 * kFullDrive, 1.0)
        << "a pause counts as two periods: tactors do not jump";
}

TEST(SafetyLimiter, risesSlowlyAlsoBelowOneCountAStep) {
    SafetyLimits limits = free();
    limits.rise_perS = 0.01;
    SafetyLimiter limiter(limits, kPeriod_s);
    Drive drive{};
    for (int k = 0; k < 2000; ++k)
        drive = limiter.step(all(1.0), kPeriod_s);
    EXPECT_NEAR(drive[0], 0.01 * 10.0 * kFullDrive, 1.0) << "10 s at 0.01 / s";
}

TEST(SafetyLimiter, doesNothingInNoTime) {
    SafetyLimiter limiter({}, kPeriod_s);
    for (const double elapsed_s : {0.0, -1.0, kNan})
        EXPECT_EQ(limiter.step(all(1.0), elapsed_s), allDrive(0)) << elapsed_s;
    EXPECT_EQ(limiter.heat(), all(0.0));
}

// h' = (1 - h) / tau from 0: h = 1 - exp(-t / tau) reaches B at t = -tau ln(1 - B).
TEST(SafetyLimiter, givesFullStrengthUntilTheHeatBudgetIsReachedAndItsRootAfterwards) {
    SafetyLimits limits = free();
    limits.heatTime_s = 2.0;
    limits.heatBudget = 0.36;
    SafetyLimiter limiter(limits, kPeriod_s);
    const double full_s = -2.0 * std::log(1.0 - 0.36);
    for (int k = 0; k < 2000; ++k) {
        const double t_s = k * kPeriod_s;
        const Drive drive = limiter.step(all(1.0), kPeriod_s);
        if (t_s < full_s - kPeriod_s) {
            EXPECT_EQ(drive, allDrive(kFullDrive)) << t_s;
        } else if (t_s > full_s + kPeriod_s) {
            EXPECT_NEAR(drive[0], 0.6 * kFullDrive, 1.0) << t_s;
        }
        for (const double heat : limiter.heat())
            EXPECT_LE(heat, 0.36 * (1.0 + 1e-12));
    }
}

TEST(SafetyLimiter, coolsWhileOff) {
    SafetyLimits limits = free();
    limits.heatTime_s = 2.0;
    SafetyLimiter limiter(limits, kPeriod_s);
    for (int k = 0; k < 4000; ++k)
        (void)limiter.step(all(1.0), kPeriod_s);
    const double hot = limiter.heat()[0];
    limiter.off(0.0);
    EXPECT_EQ(limiter.output(), all(0.0));
    limiter.off(2.0);
    EXPECT_NEAR(limiter.heat()[0], hot * std::exp(-1.0), 1e-12);
}

TEST(SafetyLimiter, allowsNothingWithLimitsThatAreNoNumbers) {
    for (const SafetyLimits& limits :
         {SafetyLimits{.rise_perS = kNan}, SafetyLimits{.rise_perS = -1.0}, SafetyLimits{.heatTime_s = kNan},
          SafetyLimits{.heatTime_s = 0.0}, SafetyLimits{.heatTime_s = kInfinity},
          SafetyLimits{.heatBudget = kNan}, SafetyLimits{.heatBudget = -1.0}}) {
        SafetyLimiter limiter(limits, kPeriod_s);
        for (int k = 0; k < 100; ++k)
            ASSERT_EQ(limiter.step(all(1.0), kPeriod_s), allDrive(0));
    }
}

// Whatever is wanted, and however irregular the calls are.
TEST(SafetyLimiter, holdsEveryLimitUnderRandomInput) {
    const SafetyLimits limits{
        .userLimit = {0.9, 0.8, 0.7, 0.6, 0.5, 0.4}, .rise_perS = 30.0, .heatTime_s = 0.5, .heatBudget = 0.2};
    SafetyLimiter limiter(limits, kPeriod_s);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> value(-2.0, 3.0);
    std::uniform_real_distribution<double> time(0.0, kPeriod_s);
    Intensities before{};
    for (int k = 0; k < 100'000; ++k) {
        Intensities wanted;
        for (double& intensity : wanted) {
            intensity = value(random);
            if (intensity > 2.9)
                intensity = kNan;
        }
        const double elapsed_s = time(random);
        const Drive drive = limiter.step(wanted, elapsed_s);
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            ASSERT_LE(drive[i], limits.userLimit[i] * kFullDrive);
            ASSERT_LE(limiter.output()[i] - before[i], 30.0 * elapsed_s + 1e-12);
            ASSERT_LE(limiter.heat()[i], 0.2 * (1.0 + 1e-9));
            if (!(wanted[i] > 0.0)) {
                ASSERT_EQ(drive[i], 0);
            }
        }
        before = limiter.output();
    }
}

TEST(SafetyLimiter, mapsIntensitiesToTheRangeOfTheMotor) {
    SafetyLimiter limiter(free(), kPeriod_s);
    const playback::DriveRanges ranges{
        {{0.2, 0.8}, {0.2, 0.8}, {0.2, 0.8}, {0.0, 1.0}, {0.25, 1.0}, {0.2, 0.8}}};
    const Drive drive = limiter.step({0.0, 1e-9, 1.0, 0.5, 0.5, kNan}, kPeriod_s, ranges);
    EXPECT_EQ(drive, (Drive{0, 819, 3276, 2047, 2559, 0})) << "4095 (start + i (full - start)), rounded down";
    EXPECT_DOUBLE_EQ(limiter.output()[2], 1.0) << "told in intensities";
}

TEST(SafetyLimiter, takesARangeThatMakesNoSenseAsNone) {
    for (const playback::DriveRange range :
         {playback::DriveRange{0.9, 0.2}, playback::DriveRange{kNan, 1.0}, playback::DriveRange{0.2, 1.5},
          playback::DriveRange{-0.1, 1.0}}) {
        SafetyLimiter limiter(free(), kPeriod_s);
        playback::DriveRanges ranges;
        ranges.fill(range);
        EXPECT_EQ(limiter.step(all(0.5), kPeriod_s, ranges), allDrive(2047));
    }
}

// h' = (u^2 - h) / T with the drive u: a motor that starts at 0.6 is heated by 0.6 at the weakest intensity.
TEST(SafetyLimiter, countsTheHeatOfTheDriveNotOfTheIntensity) {
    SafetyLimits limits = free();
    limits.heatBudget = 0.3;
    limits.heatTime_s = 1.0;
    SafetyLimiter limiter(limits, kPeriod_s);
    playback::DriveRanges ranges;
    ranges.fill({0.6, 1.0});
    double on_s = 0.0;
    while (limiter.step(all(1e-6), kPeriod_s, ranges)[0] > 0 && on_s < 10.0)
        on_s += kPeriod_s;
    EXPECT_NEAR(on_s, -std::log(1.0 - 0.3 / 0.36), 0.02) << "then what is left does not turn the motor";
    EXPECT_LE(limiter.heat()[0], 0.3 + 1e-12);
}

// A motor that starts above sqrt(heatBudget) = 0.707 cannot be held at its budget. From rest at full drive it
// bears -T ln(1 - B) = 20.79 s; then it cools to 0.9 B in -T ln 0.9 = 3.16 s and bears
// T ln((1 - 0.9 B) / (1 - B)) = 2.86 s more, and so on: in 60 s it is switched 1 + 2 (6 and a half times).
TEST(SafetyLimiter, letsAMotorRestThatCannotBeHeldAtItsBudgetInsteadOfSwitchingItWithEveryFrame) {
    SafetyLimiter limiter({}, kPeriod_s);
    playback::DriveRanges ranges;
    ranges.fill({0.75, 1.0});
    const double full_s = -30.0 * std::log(0.5);
    const double rest_s = -30.0 * std::log(0.9);
    const double again_s = 30.0 * std::log(0.55 / 0.5);
    int edges = 0;
    bool wasOn = false;
    double firstOff_s = 0.0;
    for (int k = 0; k < 12'000; ++k) {
        const bool on = limiter.step(all(1.0), kPeriod_s, ranges)[0] > 0;
        if (on != wasOn && k > 0)
            ++edges;
        if (!on && wasOn && firstOff_s == 0.0)
            firstOff_s = k * kPeriod_s;
        wasOn = on;
        for (const double heat : limiter.heat())
            ASSERT_LE(heat, 0.5 * (1.0 + 1e-12));
    }
    EXPECT_NEAR(firstOff_s, full_s, 0.05);
    EXPECT_NEAR(edges, 1.0 + 2.0 * (60.0 - full_s) / (rest_s + again_s), 2.0);
    EXPECT_LE(edges, 16);
}

TEST(SafetyLimiter, goesOnAtTheRootOfTheBudgetWhereTheMotorStillTurnsThere) {
    SafetyLimiter limiter({}, kPeriod_s);
    playback::DriveRanges ranges;
    ranges.fill({0.6, 1.0});
    for (int k = 0; k < 12'000; ++k)
        ASSERT_GT(limiter.step(all(1.0), kPeriod_s, ranges)[0], 0.6 * kFullDrive) << k;
    EXPECT_NEAR(limiter.step(all(1.0), kPeriod_s, ranges)[0], std::sqrt(0.5) * kFullDrive, 1.0);
}

TEST(SafetyLimiter, goesOnAfterTheBudgetWasLoweredBelowTheHeatAndTheMotorCooled) {
    SafetyLimiter limiter({}, kPeriod_s);
    for (int k = 0; k < 4000; ++k)
        (void)limiter.step(all(1.0), kPeriod_s);
    const double hot = limiter.heat()[0];
    SafetyLimits lower;
    lower.heatBudget = 0.25;
    limiter.setLimits(lower);
    double off_s = 0.0;
    while (limiter.step(all(1.0), kPeriod_s)[0] == 0 && off_s < 100.0)
        off_s += kPeriod_s;
    EXPECT_NEAR(off_s, 30.0 * std::log(hot / 0.25), 0.02) << "h = hot exp(-t / T) is down at the budget";
    for (int k = 0; k < 2000; ++k)
        ASSERT_GT(limiter.step(all(1.0), kPeriod_s)[0], 0);
    EXPECT_NEAR(limiter.step(all(1.0), kPeriod_s)[0], 0.5 * kFullDrive, 1.0);
}

TEST(SafetyLimiter, goesOnFromAHeatOfBeforeThatHasCooledSince) {
    SafetyLimiter limiter({.rise_perS = kInfinity}, kPeriod_s);
    limiter.resume(all(0.5), 0.0);
    EXPECT_NEAR(limiter.step(all(1.0), 0.0)[0], std::sqrt(0.5) * kFullDrive, 1.0);
    limiter.resume(all(0.5), 30.0);
    EXPECT_NEAR(limiter.heat()[0], 0.5 * std::exp(-1.0), 1e-12);
    limiter.resume(all(0.5), -1.0);
    EXPECT_EQ(limiter.heat()[0], 0.5) << "no time has passed";
}
