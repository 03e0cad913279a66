// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/comparison/effect_size.h"
#include "backend/study/comparison/paired_comparison.h"
#include "backend/study/comparison/rank_test.h"
#include "backend/study/comparison/task_comparisons.h"
#include "backend/study/comparison/time_comparisons.h"
#include "tests/backend/study/data_set_a.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace teleta::study {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Half a unit of the last digit that the reference prints, as a part of the value.
void expectDigits(double value, double expected) {
    EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected));
}

const LevelPair& pairOf(const TaskComparisons& comparisons, const std::string& first,
                        const std::string& second, const std::string& stimulus = {}) {
    const auto found = std::ranges::find_if(comparisons.pairs, [&](const LevelPair& pair) {
        return pair.first == first && pair.second == second && pair.stimulus == stimulus;
    });
    EXPECT_NE(found, comparisons.pairs.end()) << first << ' ' << second;
    return *found;
}

struct ExpectedPair {
    const char* first;
    const char* second;
    double difference;
    double t;
    double p;
    double pHolm;
    double dz;
    double rankP;
    double rankHolm;
    double biserial;
};

} // namespace

// Expected values here and below: R 4.2.2.
TEST(TaskComparisons, pairsOfPatternsOfDataSetAAreThoseOfR) {
    const TaskComparisons comparisons = taskComparisons(dataSetA());
    for (const ExpectedPair& expected : std::array<ExpectedPair, 6>{{
             {"P2", "P3", .275, 11, 1.137615e-05, 1.706423e-04, 3.889087, .0078125, .1171875, 1},
             {"P1", "P3", .325, 7.890701, 9.950731e-05, 1.393102e-03, 2.789784, .0078125, .1171875, 1},
             {"P1", "P6", .3375, 4.103850, .004550953, .05916239, 1.450930, .0234375, .3046875, .9166667},
             {"P4", "P6", .1375, 2.582497, .03633984, .3633984, .9130506, .0625, .625, 1},
             {"P5", "P6", .225, 2.552889, .03794329, .3633984, .9025825, .0625, .625, .8},
             {"P2", "P5", .0625, 1.049109, .3289933, .9869799, .3709159, .4375, 1, .4242424},
         }}) {
        SCOPED_TRACE(std::string(expected.first) + '-' + expected.second);
        const LevelPair& pair = pairOf(comparisons, expected.first, expected.second);
        ASSERT_TRUE(pair.comparison.test && pair.ranks && pair.pHolm && pair.ranksHolm);
        EXPECT_EQ(pair.comparison.participants, 8U);
        EXPECT_EQ(pair.family, 15U);
        expectDigits(*pair.comparison.difference, expected.difference);
        expectDigits(pair.comparison.test->t, expected.t);
        expectDigits(pair.comparison.test->p, expected.p);
        expectDigits(*pair.pHolm, expected.pHolm);
        expectDigits(pair.comparison.test->dz, expected.dz);
        EXPECT_TRUE(pair.ranks->isExact);
        expectDigits(pair.ranks->p, expected.rankP);
        expectDigits(*pair.ranksHolm, expected.rankHolm);
        expectDigits(pair.ranks->rankBiserial, expected.biserial);
    }
}

TEST(TaskComparisons, conditionsOfDataSetAHaveTheEffectSizesOfR) {
    const LevelPair pair = pairOf(taskComparisons(dataSetA()), "dynamic", "static");
    ASSERT_TRUE(pair.comparison.test && pair.ranks);
    const PairedTest& test = *pair.comparison.test;
    expectDigits(*pair.comparison.difference, .1083333333);
    expectDigits(test.interval.low, .0492177);
    expectDigits(test.interval.high, .1674489);
    expectDigits(test.t, 4.333333);
    EXPECT_EQ(test.df, 7.0);
    expectDigits(test.dz, 1.532065);
    ASSERT_TRUE(test.dzInterval && test.dav && test.hedges);
    expectDigits(test.dzInterval->low, .4623735);
    expectDigits(test.dzInterval->high, 2.557654);
    expectDigits(*test.dav, .7788881);
    expectDigits(*test.hedges, .8882029);
    expectDigits(*test.gz(), 1.360784);
    EXPECT_EQ(pair.ranks->positive, 35.0);
    EXPECT_EQ(pair.ranks->negative, 1.0);
    EXPECT_EQ(pair.ranks->p, .015625);
    expectDigits(pair.ranks->rankBiserial, .9444444);
    // A family of one.
    EXPECT_EQ(pair.family, 1U);
    EXPECT_EQ(pair.pHolm, test.p);
}

TEST(TaskComparisons, conditionsWithinPatternsAreOneFamily) {
    const TaskComparisons comparisons = taskComparisons(dataSetA());
    const std::array<std::array<double, 2>, 6> expected{{{.2168375, .6818826},
                                                         {.6845283, .6845283},
                                                         {.1970221, .6818826},
                                                         {.0949765, .4776121},
                                                         {.1704707, .6818826},
                                                         {.0796020, .4776121}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const std::string pattern = "P" + std::to_string(i + 1);
        SCOPED_TRACE(pattern);
        const LevelPair& pair = pairOf(comparisons, "dynamic", "static", pattern);
        ASSERT_TRUE(pair.comparison.test);
        EXPECT_EQ(pair.family, 6U);
        EXPECT_NEAR(pair.comparison.test->p, expected[i][0], 0.6e-7);
        EXPECT_NEAR(pair.pHolm.value(), expected[i][1], 0.6e-7);
        EXPECT_EQ(patternPHolm(comparisons, pattern), pair.pHolm);
    }
    EXPECT_FALSE(patternPHolm(comparisons, "P7"));
}

TEST(TaskComparisons, friedmanOfThePatternsOfDataSetAIsThatOfR) {
    const TaskComparisons comparisons = taskComparisons(dataSetA());
    ASSERT_EQ(comparisons.effects.size(), 9U);
    EXPECT_FALSE(comparisons.effects[0].friedman) << "two conditions are a pair";
    ASSERT_TRUE(comparisons.effects[1].friedman && *comparisons.effects[1].friedman);
    const FriedmanTest& test = **comparisons.effects[1].friedman;
    expectDigits(test.chi2, 19.54724);
    EXPECT_EQ(test.df, 5.0);
    expectDigits(test.p, .001519286);
    expectDigits(test.w, .4886811);
}

TEST(TaskComparisons, partialEtaSquaredHasAnIntervalOnlyWithSphericity) {
    const TaskComparisons comparisons = taskComparisons(dataSetA());
    ASSERT_TRUE(comparisons.effects[0].partialEta2);
    expectDigits(comparisons.effects[0].partialEta2->low, .1594881);
    expectDigits(comparisons.effects[0].partialEta2->high, .8532594);
    for (const std::size_t effect : {1U, 2U}) {
        EXPECT_FALSE(comparisons.effects[effect].partialEta2);
        EXPECT_EQ(comparisons.effects[effect].note, "eps GG < 0.75");
    }
}

TEST(EffectSize, partialEtaSquaredWithSphericityIsThatOfR) {
    const auto pattern = partialEta2Interval(7.854460093896714, 5, 35);
    ASSERT_TRUE(pattern);
    expectDigits(pattern->low, .2116342);
    expectDigits(pattern->high, .6338109);
    const TaskResults task = dataSetA();
    ASSERT_TRUE(task.anova[2].row);
    const auto interaction = partialEta2Interval(task.anova[2].row->f, 5, 35);
    ASSERT_TRUE(interaction);
    EXPECT_EQ(interaction->low, 0.0);
    expectDigits(interaction->high, .1092253);
    EXPECT_FALSE(partialEta2Interval(-1.0, 1, 7));
    EXPECT_FALSE(partialEta2Interval(kNoNumber, 1, 7));
}

TEST(EffectSize, anIntervalOfTheOppositeDifferenceIsItsMirror) {
    const auto one = standardizedDifferenceInterval(4.333333333, 8);
    const auto other = standardizedDifferenceInterval(-4.333333333, 8);
    ASSERT_TRUE(one && other);
    EXPECT_EQ(other->low, -one->high);
    EXPECT_EQ(other->high, -one->low);
    const auto none = standardizedDifferenceInterval(0.0, 8);
    ASSERT_TRUE(none);
    EXPECT_NEAR(none->low, -none->high, 1e-9);
    EXPECT_FALSE(standardizedDifferenceInterval(1.0, 1));
    EXPECT_FALSE(standardizedDifferenceInterval(std::numeric_limits<double>::infinity(), 8));
}

TEST(PairedComparison, equalDifferencesAreRefusedAndShown) {
    // 0.6 - 0.4 and 0.8 - 0.6 differ by rounding.
    const std::array first{0.6, 0.8, 1.0};
    const std::array second{0.4, 0.6, 0.8};
    const PairedComparison same = comparePaired(first, second);
    EXPECT_NEAR(same.difference.value(), 0.2, 1e-15);
    ASSERT_FALSE(same.test);
    EXPECT_EQ(same.test.error(), Refusal::noErrorVariance);
    const PairedComparison none = comparePaired(first, first);
    EXPECT_EQ(none.difference, 0.0);
    ASSERT_FALSE(none.test);
    EXPECT_EQ(none.test.error(), Refusal::noVariance);
}

TEST(PairedComparison, missingValuesLeaveTheirRowOut) {
    const std::array first{0.6, kNoNumber, 1.0, 0.5};
    const std::array second{0.4, 0.6, kNoNumber, 0.1};
    const PairedComparison two = comparePaired(first, second);
    EXPECT_EQ(two.participants, 2U);
    ASSERT_TRUE(two.test);
    EXPECT_NEAR(two.test->t, 3.0, 1e-12); // differences .2, .4
    // J needs more than one degree of freedom.
    EXPECT_FALSE(two.test->gz());
    const PairedComparison one = comparePaired(std::array{0.5, kNoNumber}, std::array{0.25, 0.5});
    EXPECT_EQ(one.participants, 1U);
    EXPECT_EQ(one.difference, 0.25);
    EXPECT_EQ(one.test.error(), Refusal::oneParticipant);
    EXPECT_FALSE(comparePaired({}, {}).difference);
    const std::array infinite{std::numeric_limits<double>::infinity(), 1.0};
    EXPECT_EQ(comparePaired(infinite, std::array{0.0, 1.0}).test.error(), Refusal::notFinite);
}

// R: p.adjust(c(.01, .04, NA, .03), "holm").
TEST(Holm, missingValuesAreNoMembersOfTheFamily) {
    const std::array<std::optional<double>, 4> p{.01, .04, std::nullopt, .03};
    const auto adjusted = holm(p);
    EXPECT_DOUBLE_EQ(adjusted[0].value(), .03);
    EXPECT_DOUBLE_EQ(adjusted[1].value(), .06);
    EXPECT_FALSE(adjusted[2]);
    EXPECT_DOUBLE_EQ(adjusted[3].value(), .06);
    EXPECT_TRUE(holm({}).empty());
}

// Counts 7, 5, 3 of 10 less 5 are 2, 0, -2: one zero of rank 1, two ties of rank 2.5.
TEST(SignedRankTest, zerosAreRankedAndLeftOut) {
    const auto test = signedRankTest(std::array{.7, .5, .3}, std::array{.5, .5, .5});
    ASSERT_TRUE(test);
    EXPECT_EQ(test->participants, 3U);
    EXPECT_EQ(test->zeros, 1U);
    EXPECT_EQ(test->positive, 2.5);
    EXPECT_EQ(test->negative, 2.5);
    EXPECT_EQ(test->p, 1.0);
    EXPECT_EQ(test->rankBiserial, 0.0);
}

TEST(SignedRankTest, nothingButZerosIsRefused) {
    const std::array same{.1, .2};
    EXPECT_EQ(signedRankTest(same, same).error(), Refusal::noVariance);
    EXPECT_EQ(signedRankTest({}, {}).error(), Refusal::noData);
}

// All of n positive differences: 2 of the 2^n signs are as far out.
TEST(SignedRankTest, itIsExactUpTo25DifferencesAndNormalAbove) {
    std::vector<double> rising(25);
    std::iota(rising.begin(), rising.end(), 1.0);
    const std::vector<double> zero(26, 0.0);
    const auto exact = signedRankTest(rising, std::span(zero).first(25));
    ASSERT_TRUE(exact);
    EXPECT_TRUE(exact->isExact);
    EXPECT_DOUBLE_EQ(exact->p, std::ldexp(1.0, -24));
    rising.push_back(26.0);
    const auto normal = signedRankTest(rising, zero);
    ASSERT_TRUE(normal);
    EXPECT_FALSE(normal->isExact);
    // R: z <- 175.5 / sqrt(sum((1:26)^2) / 4); 2 * pnorm(-z)
    EXPECT_NEAR(normal->p, 8.2980e-06, 0.6e-09);
}

TEST(FriedmanTest, refusesWhatHasNoRanks) {
    EXPECT_EQ(friedmanTest({}).error(), Refusal::noData);
    EXPECT_EQ(friedmanTest({{1.0}, {2.0}}).error(), Refusal::tooFewLevels);
    EXPECT_EQ(friedmanTest({{1.0, 2.0, 3.0}}).error(), Refusal::oneParticipant);
    EXPECT_EQ(friedmanTest({{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}).error(), Refusal::noVariance);
    EXPECT_EQ(friedmanTest({{1.0, 2.0}, {2.0}}).error(), Refusal::badShape);
}

TEST(TimeComparisons, conditionsAreComparedAsARatio) {
    const std::array fixedTimes{1.42, 1.10, 1.85, 1.31, .98, 1.66, 1.25, 1.47};
    const std::array movingTimes{1.71, 1.22, 1.93, 1.62, 1.05, 2.10, 1.31, 1.80};
    TaskResults task;
    task.patterns = {"A", "B"};
    for (const char* condition : {"dynamic", "static"}) {
        GroupSummary group{condition, ConfusionMatrix(2)};
        for (std::size_t i = 0; i < fixedTimes.size(); ++i) {
            ConfusionMatrix matrix(2);
            matrix.add(0, 0);
            const double time_s = group.condition == "static" ? fixedTimes[i] : movingTimes[i];
            task.participants.push_back({"P" + std::to_string(i), condition, matrix, time_s, {time_s}});
            group.matrix.add(matrix);
        }
        task.groups.push_back(group);
    }
    const TimeComparisons times = timeComparisons(task);
    EXPECT_EQ(times.participants.size(), 16U);
    ASSERT_EQ(times.pairs.size(), 1U);
    const TimePair& pair = times.pairs.front();
    ASSERT_TRUE(pair.logs.test && pair.ratio() && pair.ratioInterval());
    expectDigits(*pair.ratio(), 1.147062);
    expectDigits(pair.ratioInterval()->low, 1.072840);
    expectDigits(pair.ratioInterval()->high, 1.226419);
    expectDigits(pair.logs.test->t, 4.849935);
    expectDigits(pair.logs.test->p, .001856459);
    EXPECT_EQ(pair.pHolm, pair.logs.test->p);
}

TEST(TimeComparisons, aTimeOfZeroHasNoLogarithm) {
    EXPECT_DOUBLE_EQ(geometricMean(std::array{1.0, 4.0}).value(), 2.0);
    EXPECT_FALSE(geometricMean(std::array{1.0, 0.0}));
    EXPECT_FALSE(geometricMean({}));
}

} // namespace teleta::study
