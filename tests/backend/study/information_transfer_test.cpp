// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/analysis/information_transfer.h"
#include "tests/backend/study/paper_tables.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::study {

// Expected values: R 4.2.2.
TEST(InformationTransfer, isThatOfRForAKnownMatrix) {
    const auto transfer = informationTransfer(matrixOf({{5, 0, 0, 0, 0, 0},
                                                        {0, 4, 1, 0, 0, 0},
                                                        {0, 1, 3, 1, 0, 0},
                                                        {0, 0, 1, 4, 0, 0},
                                                        {1, 0, 0, 0, 4, 0},
                                                        {0, 0, 0, 0, 2, 3}}));
    ASSERT_TRUE(transfer);
    EXPECT_NEAR(transfer->measured_bit, 1.802164386, 0.51e-9);
    EXPECT_NEAR(transfer->corrected_bit, 1.659228314, 0.51e-9);
    EXPECT_NEAR(transfer->bias_bit, 1.802164386 - 1.659228314, 1e-9);
    EXPECT_TRUE(transfer->fewTrials);
}

// Without one of two trials nothing is left to tell: 2 * 1 - 1 * 0 = 2 bit, more than was measured.
TEST(InformationTransfer, withoutBiasIsNotMoreThanMeasured) {
    EXPECT_EQ(informationTransfer(matrixOf({{1, 0}, {0, 1}}))->corrected_bit, 1.0);
    EXPECT_EQ(informationTransfer(matrixOf({{1, 0}, {0, 0}}))->corrected_bit, 0.0) << "one trial";
}

TEST(InformationTransfer, isTheEntropyOfThePatternsWhenAllIsRight) {
    ConfusionMatrix matrix(6);
    for (std::size_t i = 0; i < 6; ++i)
        matrix.add(i, i, 30);
    const auto transfer = informationTransfer(matrix);
    ASSERT_TRUE(transfer);
    EXPECT_NEAR(transfer->measured_bit, std::log2(6.0), 1e-14);
    EXPECT_NEAR(transfer->corrected_bit, std::log2(6.0), 1e-14) << "all patterns equally often";
    EXPECT_FALSE(transfer->fewTrials);
}

TEST(InformationTransfer, isZeroWhenTheAnswerIsAlwaysTheSame) {
    ConfusionMatrix matrix(5);
    for (std::size_t i = 0; i < 5; ++i)
        matrix.add(i, 1, 5);
    const auto transfer = informationTransfer(matrix);
    ASSERT_TRUE(transfer);
    EXPECT_EQ(transfer->measured_bit, 0.0);
    EXPECT_NEAR(transfer->bias_bit, 0.0, 1e-14);
}

TEST(InformationTransfer, isZeroForUniformGuesses) {
    ConfusionMatrix matrix(5);
    for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t j = 0; j < 5; ++j)
            matrix.add(i, j, 3);
    }
    EXPECT_NEAR(informationTransfer(matrix)->measured_bit, 0.0, 1e-14);
}

// One of two patterns answered, the other never: both answers tell the pattern, which is log2(2).
TEST(InformationTransfer, countsSilenceAsAnAnswer) {
    ConfusionMatrix matrix(2);
    matrix.add(0, 0, 10);
    matrix.add(1, std::nullopt, 10);
    EXPECT_NEAR(informationTransfer(matrix)->measured_bit, 1.0, 1e-14);
}

TEST(InformationTransfer, thereIsNoneWithoutTrials) {
    EXPECT_FALSE(informationTransfer(ConfusionMatrix(6)));
}

// 0.74 bit: the specification's value for a guesser of six patterns in 30 trials. Spread of the mean of 4000
// guessers is about 0.002 bit.
TEST(InformationTransfer, aGuesserOfSixPatternsShows074BitInThirtyTrials) {
    core::RandomStream random(7);
    constexpr int kGuessers = 4000;
    double sum_bit = 0.0;
    for (int g = 0; g < kGuessers; ++g) {
        ConfusionMatrix matrix(6);
        for (std::size_t trial = 0; trial < 30; ++trial)
            matrix.add(trial % 6, static_cast<std::size_t>(random.below(6)));
        sum_bit += informationTransfer(matrix)->measured_bit;
    }
    EXPECT_NEAR(sum_bit / kGuessers, 0.74, 0.01);
}

TEST(BootstrapTransfer, needsTwoParticipants) {
    const std::vector<ConfusionMatrix> one{matrixOf(kPaperTables[0].counts)};
    EXPECT_FALSE(bootstrapTransfer(one, 100, 1));
    EXPECT_FALSE(bootstrapTransfer({}, 100, 1));
    const std::vector<ConfusionMatrix> empty(2, ConfusionMatrix(6));
    EXPECT_FALSE(bootstrapTransfer(empty, 100, 1));
}

TEST(BootstrapTransfer, hasNoWidthWhenAllParticipantsAreTheSame) {
    const std::vector<ConfusionMatrix> same(6, matrixOf(kPaperTables[1].counts));
    const auto interval = bootstrapTransfer(same, 200, 1);
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->high - interval->low, 0.0, 1e-13);
    EXPECT_NEAR(interval->low, informationTransfer(same.front())->measured_bit, 1e-13);
}

// Two participants: a resample is twice the first, twice the second, or both, with 1/4, 1/4, 1/2; the 2.5 %
// and 97.5 % quantiles are therefore the two participants' own values.
TEST(BootstrapTransfer, ofTwoParticipantsReachesFromOneToTheOther) {
    ConfusionMatrix right(2);
    right.add(0, 0, 10);
    right.add(1, 1, 10);
    ConfusionMatrix silent(2);
    silent.add(0, std::nullopt, 10);
    silent.add(1, std::nullopt, 10);
    const auto interval = bootstrapTransfer(std::vector{right, silent}, 1000, 3);
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, 0.0, 1e-14);
    EXPECT_NEAR(interval->high, 1.0, 1e-14);
}

// Two trials of different patterns: the guesses agree or not, with 0 or 1 bit, equally likely.
TEST(GuesserTransfer, isThatOfAllGuessesWhereTheyCanBeCounted) {
    ConfusionMatrix matrix(2);
    matrix.add(0, 0);
    EXPECT_NEAR(guesserTransfer(matrix).value(), 0.0, 1e-14);
    matrix.add(1, 0);
    EXPECT_NEAR(guesserTransfer(matrix).value(), 0.5, 1e-14);
}

// All 3^6 ways to guess six trials of three patterns.
TEST(GuesserTransfer, isTheMeanOverAllGuesses) {
    double sum_bit = 0.0;
    ConfusionMatrix matrix(3);
    for (int guesses = 0; guesses < 729; ++guesses) {
        matrix = ConfusionMatrix(3);
        int rest = guesses;
        for (std::size_t trial = 0; trial < 6; ++trial, rest /= 3)
            matrix.add(trial / 2, static_cast<std::size_t>(rest % 3));
        sum_bit += informationTransfer(matrix)->measured_bit;
    }
    EXPECT_NEAR(guesserTransfer(matrix).value(), sum_bit / 729.0, 1e-12);
}

TEST(GuesserTransfer, of30TrialsOfSixPatternsIsWhatTheSpecificationSays) {
    ConfusionMatrix matrix(6);
    for (std::size_t i = 0; i < 6; ++i)
        matrix.add(i, i, 5);
    EXPECT_NEAR(guesserTransfer(matrix).value(), 0.74, 0.005);
    EXPECT_FALSE(guesserTransfer(ConfusionMatrix(6)));
}

TEST(GuesserTransfer, ofPatternsThatWereNotSeenIsThatOfTheMatrixWithThem) {
    ConfusionMatrix seen(2);
    ConfusionMatrix whole(6);
    for (std::size_t i = 0; i < 2; ++i) {
        seen.add(i, i, 15);
        whole.add(i, i, 15);
    }
    EXPECT_NEAR(guesserTransfer(seen, 6).value(), guesserTransfer(whole).value(), 1e-14);
    EXPECT_NE(guesserTransfer(seen), guesserTransfer(whole));
    EXPECT_EQ(guesserTransfer(whole, 2), guesserTransfer(whole));
    EXPECT_FALSE(informationTransfer(seen)->fewTrials) << "30 of 5 2^2";
    EXPECT_TRUE(informationTransfer(seen, 6)->fewTrials) << "30 of 5 6^2";
    EXPECT_EQ(informationTransfer(seen, 6)->measured_bit, informationTransfer(seen)->measured_bit);
}

// With many trials it is Miller's bias, (R-1)(C-1) / (2 n ln 2).
TEST(GuesserTransfer, comesToMillersBiasWithManyTrials) {
    ConfusionMatrix matrix(5);
    for (std::size_t i = 0; i < 5; ++i)
        matrix.add(i, i, 100'000);
    EXPECT_NEAR(guesserTransfer(matrix).value() / (16.0 / (2.0 * 500'000.0 * std::log(2.0))), 1.0, 1e-3);
}

} // namespace teleta::study
