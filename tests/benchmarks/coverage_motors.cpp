// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_fit.h"
#include "tests/backend/motors/measured_motor.h"
#include "tests/benchmarks/coverage_rows.h"

namespace teleta::benchmarks {

namespace {

constexpr double kNormal95 = 1.96;

void count(CoverageRow& row, double value_s, double error_s, double truth_s) {
    row.add(std::abs(value_s - truth_s) < kNormal95 * error_s, true, 2.0 * kNormal95 * error_s / truth_s);
}

void rowsOf(const std::string& name, const test::ReadingTimes& untilNext_s, int cases, const TakeRow& take) {
    CoverageRow rise("motors", "rise, " + name);
    CoverageRow fall("motors", "fall, " + name);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < cases; ++i) {
        const simulated::SimulatedMotor motor{.rise_s = 0.015 + 0.045 * share(random),
                                              .fall_s = 0.02 + 0.06 * share(random),
                                              .start = 0.2 + 0.2 * share(random)};
        const auto fit = motors::fitMotor(test::measuredAt(motor, 0.5, static_cast<std::uint64_t>(i) + 1,
                                                           motors::stairsAndPulses(), untilNext_s));
        if (!fit) {
            rise.addRefused();
            fall.addRefused();
            continue;
        }
        count(rise, fit->profile.riseTime_s, fit->riseError_s, test::rise90_s(motor));
        count(fall, fit->profile.fallTime_s, fit->fallError_s, test::fall10_s(motor));
    }
    take(rise);
    take(fall);
}

} // namespace

void motorRows(int cases, const TakeRow& take) {
    const auto onTime = [](std::mt19937_64& random) {
        return 1e-3 * std::uniform_real_distribution<double>(0.9, 1.1)(random);
    };
    const auto late = [onTime](std::mt19937_64& random) {
        std::uniform_real_distribution<double> share(0.0, 1.0);
        return share(random) < 0.03 ? 1e-3 + 25e-3 * share(random) : onTime(random);
    };
    rowsOf("readings on time", onTime, cases, take);
    rowsOf("readings up to 26 ms late", late, cases, take);
}

} // namespace teleta::benchmarks
