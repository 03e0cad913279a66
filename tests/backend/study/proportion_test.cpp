// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/proportion.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace teleta::study {

namespace {

constexpr double kSixDigits = 0.51e-6;

void expectNear(const std::optional<Interval>& interval, double low, double high) {
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, low, kSixDigits);
    EXPECT_NEAR(interval->high, high, kSixDigits);
}

} // namespace

// Expected values: R 4.2.2, prop.test(correct = FALSE) and binom.test.
TEST(Proportion, wilsonIntervalIsThatOfR) {
    expectNear(wilsonInterval(0, 5), 0.0, 0.434482);
    expectNear(wilsonInterval(10, 30), 0.192305, 0.512199);
    expectNear(wilsonInterval(23, 30), 0.590717, 0.882076);
    expectNear(wilsonInterval(30, 30), 0.886487, 1.0);
}

TEST(Proportion, clopperPearsonIntervalIsThatOfR) {
    expectNear(clopperPearsonInterval(0, 5), 0.0, 0.521824);
    expectNear(clopperPearsonInterval(10, 30), 0.172874, 0.528120);
    expectNear(clopperPearsonInterval(23, 30), 0.577163, 0.900662);
    expectNear(clopperPearsonInterval(30, 30), 0.884297, 1.0);
}

TEST(Proportion, intervalsReachExactlyZeroAndOne) {
    EXPECT_EQ(wilsonInterval(0, 7)->low, 0.0);
    EXPECT_EQ(wilsonInterval(7, 7)->high, 1.0);
    EXPECT_EQ(clopperPearsonInterval(0, 7)->low, 0.0);
    EXPECT_EQ(clopperPearsonInterval(7, 7)->high, 1.0);
}

TEST(Proportion, thereIsNoIntervalWithoutTrialsOrOfImpossibleCounts) {
    EXPECT_FALSE(wilsonInterval(0, 0));
    EXPECT_FALSE(wilsonInterval(-1, 5));
    EXPECT_FALSE(wilsonInterval(6, 5));
    EXPECT_FALSE(wilsonInterval(1, 5, 1.0));
    EXPECT_FALSE(wilsonInterval(1, 5, std::nan("")));
    EXPECT_FALSE(clopperPearsonInterval(0, 0));
    EXPECT_FALSE(clopperPearsonInterval(6, 5));
    EXPECT_FALSE(clopperPearsonInterval(1, 5, 0.0));
}

TEST(Proportion, chanceProbabilityIsTheBinomialTail) {
    EXPECT_EQ(*chanceProbability(0, 3, 0.5), 1.0);
    EXPECT_NEAR(*chanceProbability(2, 3, 0.5), 0.5, 1e-15);
    EXPECT_NEAR(*chanceProbability(3, 3, 0.5), 0.125, 1e-15);
    EXPECT_EQ(*chanceProbability(1, 3, 0.0), 0.0);
    EXPECT_EQ(*chanceProbability(3, 3, 1.0), 1.0);
    EXPECT_FALSE(chanceProbability(0, 0, 0.5));
    EXPECT_FALSE(chanceProbability(1, 2, 1.5));
}

TEST(Proportion, aboveChanceAreTenOfThirtyForSixAndNineOfTwentyFiveForFivePatterns) {
    EXPECT_LE(*chanceProbability(10, 30, 1.0 / 6.0), 0.05);
    EXPECT_GT(*chanceProbability(9, 30, 1.0 / 6.0), 0.05);
    EXPECT_LE(*chanceProbability(9, 25, 1.0 / 5.0), 0.05);
    EXPECT_GT(*chanceProbability(8, 25, 1.0 / 5.0), 0.05);
}

// Expected values: t(0.975; 4) = 2.776445 from tables; mean and deviation of 1..5 in closed form.
TEST(Proportion, groupMeanHasTheIntervalOfStudentsT) {
    constexpr std::array values = {1.0, 2.0, 3.0, 4.0, 5.0};
    const std::optional<GroupMean> group = groupMean(values);
    ASSERT_TRUE(group && group->interval);
    EXPECT_DOUBLE_EQ(group->mean, 3.0);
    EXPECT_DOUBLE_EQ(*group->standardDeviation, std::sqrt(2.5));
    EXPECT_NEAR(group->interval->low, 3.0 - 2.776445105 * std::sqrt(0.5), 1e-8);
    EXPECT_NEAR(group->interval->high, 3.0 + 2.776445105 * std::sqrt(0.5), 1e-8);
}

TEST(Proportion, oneParticipantHasAMeanButNoInterval) {
    constexpr std::array one = {0.7};
    const std::optional<GroupMean> group = groupMean(one);
    ASSERT_TRUE(group);
    EXPECT_EQ(group->mean, 0.7);
    EXPECT_FALSE(group->standardDeviation);
    EXPECT_FALSE(group->interval);
    EXPECT_FALSE(groupMean({}));
    constexpr std::array notANumber = {0.7, std::numeric_limits<double>::quiet_NaN()};
    EXPECT_FALSE(groupMean(notANumber));
}

TEST(Proportion, participantsWhoAgreeHaveAnIntervalWithoutWidth) {
    constexpr std::array same = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
    const std::optional<GroupMean> group = groupMean(same);
    ASSERT_TRUE(group && group->interval);
    EXPECT_EQ(*group->standardDeviation, 0.0);
    EXPECT_EQ(group->interval->low, 0.1);
    EXPECT_EQ(group->interval->high, 0.1);
}

TEST(Proportion, medianIsTheMiddleOrTheMeanOfTheMiddleTwo) {
    EXPECT_FALSE(median({}));
    constexpr std::array odd = {9.0, 1.0, 2.0};
    constexpr std::array even = {9.0, 1.0, 2.0, 4.0};
    constexpr std::array infinite = {9.0, std::numeric_limits<double>::infinity()};
    EXPECT_EQ(median(odd), 2.0);
    EXPECT_EQ(median(even), 3.0);
    EXPECT_FALSE(median(infinite));
}

} // namespace teleta::study
