// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/trial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

namespace teleta::study {

namespace {

std::string digits(const std::vector<std::size_t>& order) {
    std::string text;
    for (const std::size_t pattern : order)
        text += static_cast<char>('1' + pattern);
    return text;
}

} // namespace

// Golden orders of the specification.
TEST(TrialOrder, isTheGoldenOneForTheGoldenSeeds) {
    EXPECT_EQ(digits(trialOrder(OrderMethod::fullRandom, 6, 5, 42)), "655264362432433261645115421531");
    EXPECT_EQ(digits(trialOrder(OrderMethod::fullRandom, 6, 5, 1)), "422526365216164146452313354153");
}

TEST(TrialOrder, hasEachPatternAsOftenAsAsked) {
    for (const OrderMethod method : {OrderMethod::fullRandom, OrderMethod::blockedRandom}) {
        std::vector<std::size_t> order = trialOrder(method, 5, 7, 9);
        EXPECT_EQ(order.size(), 35U);
        for (std::size_t pattern = 0; pattern < 5; ++pattern)
            EXPECT_EQ(std::count(order.begin(), order.end(), pattern), 7);
    }
}

TEST(TrialOrder, blockedHasEachPatternOnceInEachRepetition) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const std::vector<std::size_t> order = trialOrder(OrderMethod::blockedRandom, 6, 5, seed);
        for (std::size_t repetition = 0; repetition < 5; ++repetition) {
            const auto first = order.begin() + static_cast<std::ptrdiff_t>(6 * repetition);
            EXPECT_EQ(std::set<std::size_t>(first, first + 6).size(), 6U);
        }
    }
}

TEST(TrialOrder, isEmptyWithoutRepetitions) {
    EXPECT_TRUE(trialOrder(OrderMethod::fullRandom, 6, 0, 1).empty());
}

// All 6 orders of 3 patterns: 1000 each expected of 6000, standard deviation 29; five of them are 145.
TEST(TrialOrder, givesAllOrdersEquallyOften) {
    std::map<std::string, int> counts;
    for (std::uint64_t seed = 0; seed < 6000; ++seed)
        ++counts[digits(trialOrder(OrderMethod::fullRandom, 3, 1, seed))];
    EXPECT_EQ(counts.size(), 6U);
    for (const auto& [order, count] : counts)
        EXPECT_NEAR(count, 1000, 145) << order;
}

TEST(WilliamsSquare, ofTwoConditionsIsAbBa) {
    EXPECT_EQ(williamsSquare(2), (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 0}}));
}

TEST(WilliamsSquare, ofOneConditionIsOneRow) {
    EXPECT_EQ(williamsSquare(1), (std::vector<std::vector<std::size_t>>{{0}}));
}

TEST(WilliamsSquare, balancesPositionsAndPredecessors) {
    for (std::size_t n = 2; n <= 9; ++n) {
        const auto rows = williamsSquare(n);
        EXPECT_EQ(rows.size(), n % 2 == 0 ? n : 2 * n);
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> atPosition;
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> follows;
        for (const auto& row : rows) {
            EXPECT_EQ(std::set<std::size_t>(row.begin(), row.end()).size(), n);
            for (std::size_t i = 0; i < n; ++i) {
                ++atPosition[{row[i], i}];
                if (i > 0)
                    ++follows[{row[i - 1], row[i]}];
            }
        }
        EXPECT_EQ(atPosition.size(), n * n);
        EXPECT_EQ(follows.size(), n * (n - 1));
        for (const auto& [key, count] : atPosition)
            EXPECT_EQ(count, rows.size() / n);
        for (const auto& [key, count] : follows)
            EXPECT_EQ(count, rows.size() / n);
    }
}

// First outputs of SplitMix64 with the seeds 0 and 1234567, from its authors' reference code.
TEST(DerivedSeed, isSplitMix64) {
    EXPECT_EQ(derivedSeed(0, 0), 0xE220A8397B1DCDAFU);
    EXPECT_EQ(derivedSeed(1234567, 0), 6457827717110365317U);
    EXPECT_EQ(derivedSeed(1234567, 1), 3203168211198807973U);
}

} // namespace teleta::study
