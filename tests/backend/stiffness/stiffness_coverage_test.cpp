// SPDX-License-Identifier: GPL-3.0-or-later
// 200 random touches for each disturbance: the interval holds the truth, or the answer says that it is not
// reliable, or there is none.
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/backend/stiffness/coverage_of_touches.h"

#include <gtest/gtest.h>

using namespace teleta::stiffness;
using namespace teleta::stiffness::test;

namespace {

constexpr int kCases = 200;

class DisturbedTouches : public testing::TestWithParam<DisturbanceName> {};

} // namespace

TEST_P(DisturbedTouches, areCoveredOrFlaggedInNinetyPercent) {
    const auto coverage = coverageOf(GetParam(), kCases, 5000);
    EXPECT_GE(coverage.honest(), 0.9 * kCases)
        << GetParam().name << ": " << coverage.covered() << " covered, " << coverage.flagged() << " flagged, "
        << coverage.refused() << " refused";
}

INSTANTIATE_TEST_SUITE_P(StiffnessCoverage, DisturbedTouches, testing::ValuesIn(kDisturbances),
                         [](const auto& row) { return "row" + std::to_string(row.index); });

TEST(StiffnessCoverage, undisturbedTouchesAreCoveredAndReliable) {
    constexpr int kMany = 1000;
    const auto coverage = coverageOf(kDisturbances.front(), kMany, 9000, true);
    EXPECT_GE(coverage.covered(), 0.92 * kMany);
    EXPECT_LE(coverage.covered(), 0.98 * kMany);
    EXPECT_LE(coverage.flagged() + coverage.refused(), 0.05 * kMany);
    EXPECT_LE(coverage.medianWidth(), 1.5) << "over the width that white noise alone has";
}

TEST(StiffnessCoverage, aHeldTouchOfAStandardLinearSolidGivesItsStaticStiffness) {
    int fitted = 0;
    int held = 0;
    for (int seed = 0; seed < kCases; ++seed) {
        const DisturbedTouch touch =
            disturbedTouch(Disturbance::standardSolidHeld, 7000U + static_cast<std::uint64_t>(seed));
        const auto answer = estimateStiffness(touch.log, settingsOf(touch));
        if (!answer || !answer->solid)
            continue;
        ++fitted;
        const auto holds = [](const Interval95& interval, double truth) {
            return interval.lower <= truth && truth <= interval.upper;
        };
        // The generator's branch is as stiff as its static spring and decays in 0.1 s.
        held += holds(answer->solid->static_NPerM, touch.truth_NPerM) ? 1 : 0;
        EXPECT_NEAR(answer->solid->ratio.value, 1.0, 0.15);
        EXPECT_NEAR(answer->solid->relaxation_s.value, 0.1, 0.015);
        EXPECT_FALSE(answer->reliable) << "the value is that of one rate";
        EXPECT_TRUE(answer->has(TouchWarning::rateDependent));
    }
    EXPECT_GE(fitted, kCases / 2);
    EXPECT_GE(held, 0.9 * fitted);
}
