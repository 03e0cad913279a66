// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/frontier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace teleta::cost;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

RungCost rung(const std::string& name, double time_s, double error) {
    RungCost made;
    made.name = name;
    made.timeMedian_s = time_s;
    made.timeP99_s = 2.0 * time_s;
    made.errorMean = error;
    return made;
}

std::string onFront(std::vector<RungCost> rungs) {
    markFrontier(rungs);
    std::string names;
    for (const RungCost& one : rungs)
        if (one.pareto)
            names += one.name;
    return names;
}

std::string best(const std::vector<RungCost>& rungs, double budget_s) {
    const RungCost* found = bestWithin(rungs, budget_s);
    return found == nullptr ? "none" : found->name;
}

} // namespace

TEST(Frontier, keepsWhatNoOtherRungBeatsInBoth) {
    EXPECT_EQ(onFront({rung("a", 1.0, 9.0), rung("b", 2.0, 5.0), rung("c", 3.0, 6.0), rung("d", 4.0, 1.0)}),
              "abd");
}

TEST(Frontier, aSingleRungIsOnItAndNoneHasNone) {
    EXPECT_EQ(onFront({rung("a", 1.0, 1.0)}), "a");
    EXPECT_EQ(onFront({}), "");
}

TEST(Frontier, oneThatIsBestInBothStandsAlone) {
    EXPECT_EQ(onFront({rung("a", 2.0, 3.0), rung("b", 1.0, 1.0), rung("c", 5.0, 1.5)}), "b");
}

TEST(Frontier, rungsThatAreAlikeAreOnItTogether) {
    EXPECT_EQ(onFront({rung("a", 1.0, 1.0), rung("b", 1.0, 1.0)}), "ab");
}

TEST(Frontier, aTieInOneIsDecidedByTheOther) {
    EXPECT_EQ(onFront({rung("a", 1.0, 2.0), rung("b", 1.0, 1.0)}), "b");
    EXPECT_EQ(onFront({rung("a", 1.0, 2.0), rung("b", 3.0, 2.0)}), "a");
}

TEST(Frontier, aRungWithoutATimeOrAnErrorIsNotOnItAndBeatsNone) {
    EXPECT_EQ(onFront({rung("a", kNan, 0.1), rung("b", 0.1, kNan), rung("c", 1.0, 1.0)}), "c");
    EXPECT_EQ(onFront({rung("a", kNan, kNan)}), "");
}

TEST(Frontier, anExactRungWithoutErrorIsOnIt) {
    EXPECT_EQ(onFront({rung("a", 1.0, 1.0), rung("b", 2.0, 0.0)}), "ab");
}

// By the definition itself: sorted by time, the front's errors fall, and every other rung has one on the
// front that is no worse.
TEST(Frontier, holdsForRandomRungsInAnyOrder) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> few(1, 12);
    for (int run = 0; run < 200; ++run) {
        std::vector<RungCost> rungs;
        for (int i = 0; i < 30; ++i)
            rungs.push_back(rung(std::to_string(i), few(random), few(random)));
        markFrontier(rungs);
        for (const RungCost& one : rungs) {
            const bool reached = std::ranges::any_of(rungs, [&](const RungCost& other) {
                return other.pareto && other.timeMedian_s <= one.timeMedian_s &&
                       other.errorMean <= one.errorMean;
            });
            EXPECT_TRUE(reached);
            for (const RungCost& other : rungs) {
                if (one.pareto && other.pareto) {
                    EXPECT_EQ(one.timeMedian_s<other.timeMedian_s, one.errorMean> other.errorMean);
                }
            }
        }
        std::vector<RungCost> shuffled = rungs;
        std::ranges::shuffle(shuffled, random);
        markFrontier(shuffled);
        for (const RungCost& one : shuffled)
            EXPECT_EQ(one.pareto, std::ranges::find(rungs, one.name, &RungCost::name)->pareto);
    }
}

TEST(BestWithin, takesTheMostExactRungWhoseSlowCallsFitTheBudget) {
    const std::vector<RungCost> rungs{rung("a", 0.001, 9.0), rung("b", 0.002, 5.0), rung("c", 0.005, 1.0)};
    EXPECT_EQ(best(rungs, 0.020), "c");
    EXPECT_EQ(best(rungs, 0.010), "c") << "a call of exactly the budget fits";
    EXPECT_EQ(best(rungs, 0.0099), "b") << "the median fits, the 99 % quantile does not";
    EXPECT_EQ(best(rungs, 0.002), "a");
}

TEST(BestWithin, isNoneWhereNoRungFits) {
    const std::vector<RungCost> rungs{rung("a", 0.001, 9.0)};
    for (const double budget_s : {0.0019, 0.0, -1.0, kNan})
        EXPECT_EQ(best(rungs, budget_s), "none") << budget_s;
    EXPECT_EQ(best({}, 1.0), "none");
    EXPECT_EQ(best(rungs, std::numeric_limits<double>::infinity()), "a");
}

TEST(BestWithin, leavesOutRefusedRungsAndPrefersTheQuickerOfTwoThatAreAsExact) {
    EXPECT_EQ(best({rung("a", kNan, 0.1), rung("b", 1.0, kNan), rung("c", 1.0, 5.0)}, 9.0), "c");
    EXPECT_EQ(best({rung("a", 2.0, 1.0), rung("b", 1.0, 1.0)}, 9.0), "b");
}

TEST(OverLimit, namesTheQuickestRungBesideTheLimit) {
    const std::vector<RungCost> rungs{rung("exact", 0.004, 1.0), rung("quick", 0.003, 2.0),
                                      rung("limit", 0.001, kNan)};
    const auto over = overLimit(rungs);
    ASSERT_TRUE(over);
    EXPECT_EQ(over->fastest->name, "quick");
    EXPECT_EQ(over->limit->name, "limit");
    EXPECT_DOUBLE_EQ(over->times, 3.0);
}

TEST(OverLimit, isNoneWithoutALimitOrATime) {
    EXPECT_FALSE(overLimit({}));
    EXPECT_FALSE(overLimit(std::vector{rung("a", 1.0, 1.0)}));
    EXPECT_FALSE(overLimit(std::vector{rung("limit", 1.0, kNan)}));
    EXPECT_FALSE(overLimit(std::vector{rung("a", kNan, 1.0), rung("limit", 1.0, kNan)}));
    EXPECT_FALSE(overLimit(std::vector{rung("a", 1.0, 1.0), rung("limit", kNan, kNan)}));
    EXPECT_FALSE(overLimit(std::vector{rung("a", 1.0, 1.0), rung("limit", 0.0, kNan)}));
}

TEST(Frontier, hasNoLimit) {
    std::vector<RungCost> rungs{rung("a", 1.0, 1.0), rung("limit", 0.1, kNan)};
    markFrontier(rungs);
    EXPECT_TRUE(rungs[0].pareto);
    EXPECT_FALSE(rungs[1].pareto);
}
