// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/paired_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace teleta::scene_run {

TEST(PairedMeanTest, countsTheSignsThatAreAsFarFromZero) {
    using Values = std::vector<double>;
    EXPECT_EQ(pairedMeanTest(Values{1, 2, 3}), 2.0 / 8.0) << "only all plus and all minus";
    EXPECT_EQ(pairedMeanTest(Values{1, 2, -3}), 1.0);
    // 8 + 4 + 2 - 1 = 13 and more: 13 and 15, of either sign.
    EXPECT_EQ(pairedMeanTest(Values{8, 4, 2, -1}), 4.0 / 16.0);
    EXPECT_EQ(pairedMeanTest(Values(6, 0.3)), 2.0 / 64.0);
    EXPECT_EQ(pairedMeanTest(Values(8, 0.0)), 1.0);
    EXPECT_EQ(pairedMeanTest(Values{0.1, 0.2, 0.3}), pairedMeanTest(Values{1e12, 2e12, 3e12}));
}

TEST(PairedMeanTest, isUnknownForOneDifferenceAndForWhatIsNotFinite) {
    EXPECT_TRUE(std::isnan(pairedMeanTest({})));
    EXPECT_TRUE(std::isnan(pairedMeanTest(std::vector{1.0})));
    EXPECT_TRUE(std::isnan(pairedMeanTest(std::vector{1.0, std::numeric_limits<double>::infinity()})));
}

// 20 differences of 1: a sum of at least 10 means at most 5 or at least 15 minus signs,
// 2 sum_{i=0}^{5} C(20, i) / 2^20 = 0.0414; drawn 20 000 times, with a standard error of 0.0014.
TEST(PairedMeanTest, drawsTheSignsOfManyDifferences) {
    std::vector<double> differences(20, 1.0);
    for (int i = 0; i < 5; ++i)
        differences[static_cast<std::size_t>(i)] = -1.0;
    EXPECT_NEAR(pairedMeanTest(differences), 0.0414, 0.006);
    EXPECT_EQ(pairedMeanTest(differences), pairedMeanTest(differences));
}

TEST(PairedSpreadTest, seesNoDifferenceInAShiftAndOneInAScale) {
    const std::vector<double> values{-4, -3, -2, -1, 1, 2, 3, 4};
    std::vector<double> shifted;
    std::vector<double> narrow;
    for (const double value : values) {
        shifted.push_back(value + 100.0);
        narrow.push_back(0.01 * value);
    }
    EXPECT_EQ(pairedSpreadTest(values, shifted), 1.0);
    EXPECT_EQ(pairedSpreadTest(values, narrow), 2.0 / 256.0);
    EXPECT_EQ(pairedSpreadTest(narrow, values), 2.0 / 256.0);
    EXPECT_TRUE(std::isnan(pairedSpreadTest(values, std::vector{1.0, 2.0})));
    EXPECT_TRUE(std::isnan(pairedSpreadTest({}, {})));
}

// Without a difference p < 0.05 in about 5 %: 2000 cases have a standard error of 0.5 %.
TEST(PairedSpreadTest, seldomFindsADifferenceWhereThereIsNone) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
        std::vector<double> a(8);
        std::vector<double> b(8);
        for (std::size_t j = 0; j < 8; ++j) {
            const double world = normal(random);
            a[j] = world + normal(random);
            b[j] = world + normal(random);
        }
        found += pairedSpreadTest(a, b) < 0.05 ? 1 : 0;
    }
    EXPECT_LE(found, 130);
    EXPECT_GE(found, 40);
}

} // namespace teleta::scene_run
