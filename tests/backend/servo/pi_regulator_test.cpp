// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/pi_regulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace teleta::servo;

namespace {

constexpr double kStep_s = 0.001;
constexpr double kProportional = 3.0;
constexpr double kIntegral = 1.5;

ServoGains gainsOf(double integralLimit = 1.0) {
    ServoGains gains;
    gains.proportional[kZ] = kProportional;
    gains.integral[kZ] = kIntegral;
    gains.integralLimit[kZ] = integralLimit;
    return gains;
}

/// A depth that follows its command, and what it is wanted to be.
class Depth {
public:
    explicit Depth(bool oneToOne) { m_rows.oneToOne[kZ] = oneToOne; }

    PiRegulator regulator;
    ServoGains gains = gainsOf();
    double error = 0.0;
    double drift_mPerS = 0.0; ///< at which the surface falls away
    double highest_mPerS = 1e3;

    void run(double time_s) {
        for (int i = 0; i < std::lround(time_s / kStep_s); ++i) {
            m_rows.takesPart[kZ] = m_rows.known[kZ] = true;
            const Twist wanted = regulator.step(Vector6::Unit(kZ) * error, m_rows, kStep_s, gains);
            const double moved = std::min(wanted[kZ], highest_mPerS);
            regulator.giveBack(Vector6::Unit(kZ) * (wanted[kZ] - moved));
            error -= kStep_s * (moved - drift_mPerS);
            lowest = std::min(lowest, error);
        }
    }
    double lowest = 0.0;

private:
    PiRegulator::Rows m_rows;
};

/// Poles of s^2 + K_P s + K_I.
struct Poles {
    double slow = 0.5 * (-kProportional + std::sqrt(kProportional * kProportional - 4.0 * kIntegral));
    double fast = 0.5 * (-kProportional - std::sqrt(kProportional * kProportional - 4.0 * kIntegral));
};

} // namespace

TEST(PiRegulator, aStepSettlesAsTheProportionalPartAloneWithoutOvershoot) {
    Depth depth(true);
    depth.error = 0.004;
    depth.run(1.0);
    EXPECT_NEAR(depth.error, 0.004 * std::pow(1.0 - kProportional * kStep_s, 1000), 1e-15);
    EXPECT_LE(depth.error, 0.05 * 0.004) << "within 5 % after ln(20) / 3 s";
    depth.run(10.0);
    EXPECT_GE(depth.lowest, -1e-15);
    EXPECT_NEAR(depth.regulator.integral()[kZ], 0.0, 1e-15);
}

TEST(PiRegulator, withTheErrorAloneAStepOvershootsAsItsTwoPolesAndItsZeroSay) {
    // e(s)/e(0) = s / (s^2 + K_P s + K_I); the area over the wanted value is that below it.
    const Poles p;
    const auto error = [&](double t_s) {
        return (p.slow * std::exp(p.slow * t_s) - p.fast * std::exp(p.fast * t_s)) / (p.slow - p.fast);
    };
    double lowest = 0.0;
    for (double t_s = 0.0; t_s < 5.0; t_s += 0.001)
        lowest = std::min(lowest, error(t_s));
    ASSERT_NEAR(lowest, -0.102, 0.001);
    Depth depth(false);
    depth.error = 0.004;
    depth.run(5.0);
    EXPECT_NEAR(depth.lowest / 0.004, lowest, 0.001);
}

TEST(PiRegulator, aSlopeIsTakenAwayAsWithTheErrorAlone) {
    const Poles p;
    for (const bool oneToOne : {true, false}) {
        Depth depth(oneToOne);
        depth.run(0.5);
        depth.drift_mPerS = 0.002;
        double time_s = 0.0;
        for (; time_s < 4.0; time_s += 0.1) {
            const double expected =
                0.002 * (std::exp(p.slow * time_s) - std::exp(p.fast * time_s)) / (p.slow - p.fast);
            EXPECT_NEAR(depth.error, expected, 2e-6) << time_s;
            depth.run(0.1);
        }
        depth.run(20.0);
        EXPECT_NEAR(depth.regulator.integral()[kZ], 0.002, 1e-8);
    }
}

TEST(PiRegulator, aChangedWishIsAStepAgain) {
    Depth depth(true);
    depth.drift_mPerS = 0.001;
    depth.run(30.0);
    ASSERT_NEAR(depth.error, 0.0, 1e-9);
    depth.error += 0.003;
    depth.regulator.expect(Vector6::Unit(kZ) * 0.003);
    depth.run(1.0);
    EXPECT_NEAR(depth.error, 0.003 * std::pow(1.0 - kProportional * kStep_s, 1000), 1e-9);
    EXPECT_NEAR(depth.regulator.integral()[kZ], 0.001, 1e-9) << "what the slope needs stays known";
}

TEST(PiRegulator, whileALimitActsNothingIsLearnedAndAfterItTheStepBeginsAnew) {
    Depth depth(true);
    depth.error = 0.004;
    depth.highest_mPerS = 0.001;
    depth.run(3.0);
    EXPECT_NEAR(depth.error, 0.001, 1e-9);
    EXPECT_NEAR(depth.regulator.integral()[kZ], 0.0, 1e-12);
    depth.highest_mPerS = 1e3;
    depth.run(1.0);
    EXPECT_NEAR(depth.error, 0.001 * std::pow(1.0 - kProportional * kStep_s, 1000), 1e-9);
    EXPECT_GE(depth.lowest, 0.0);
}

TEST(PiRegulator, withoutAProportionalPartAllOfTheErrorIsIntegrated) {
    PiRegulator regulator;
    ServoGains gains = gainsOf();
    gains.proportional.setZero();
    PiRegulator::Rows rows;
    rows.takesPart[kZ] = rows.known[kZ] = rows.oneToOne[kZ] = true;
    for (int i = 0; i < 1000; ++i)
        (void)regulator.step(Vector6::Unit(kZ) * 0.002, rows, kStep_s, gains);
    EXPECT_NEAR(regulator.integral()[kZ], kIntegral * 0.002, 1e-12);
}
