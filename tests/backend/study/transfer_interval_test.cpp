// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/transfer_interval.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace teleta::study {
namespace {

/// [[a, b], [b, a]]
ConfusionMatrix symmetric(std::int64_t a, std::int64_t b) {
    ConfusionMatrix matrix(2);
    for (std::size_t i = 0; i < 2; ++i) {
        matrix.add(i, i, a);
        matrix.add(i, 1 - i, b);
    }
    return matrix;
}

} // namespace

// [[9, 1], [1, 9]]: logarithms l1 = log2 1.8 with weight 0.9 and l2 = log2 0.2 with weight 0.1, so
// T = 0.531004, variance of the logarithm 0.9 * 0.1 * log2(9)^2 = 0.904358, se = sqrt(0.904358 / 20) =
// 0.212645.
TEST(AsymptoticTransfer, isThatOfAHandComputedTable) {
    const double l1 = std::log2(1.8), l2 = std::log2(0.2);
    const double t = 0.9 * l1 + 0.1 * l2;
    const double se = std::sqrt(0.09 * (l1 - l2) * (l1 - l2) / 20.0);
    EXPECT_NEAR(t, 0.531004, 1e-6);
    EXPECT_NEAR(se, 0.212645, 1e-6);
    const auto interval = asymptoticTransfer(symmetric(9, 1), TransferBias::none);
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, t - 1.959963984540054 * se, 1e-12);
    EXPECT_NEAR(interval->high, t + 1.959963984540054 * se, 1e-12);
    // Miller: (2-1)(2-1) / (2 * 20 ln 2) = 0.036067.
    const auto corrected = asymptoticTransfer(symmetric(9, 1), TransferBias::miller);
    EXPECT_NEAR(interval->high - corrected->high, 1.0 / (40.0 * std::log(2.0)), 1e-12);
}

TEST(AsymptoticTransfer, hasNoWidthWhereAllAnswersTellAsMuch) {
    const auto perfect = asymptoticTransfer(symmetric(10, 0), TransferBias::none);
    EXPECT_NEAR(perfect->low, 1.0, 1e-12);
    EXPECT_NEAR(perfect->high, 1.0, 1e-12);
    const auto guesses = asymptoticTransfer(symmetric(5, 5), TransferBias::miller);
    EXPECT_EQ(guesses->low, 0.0);
    EXPECT_EQ(guesses->high, 0.0) << "not below zero";
}

TEST(AsymptoticTransfer, isNoneWithoutTrialsOrConfidence) {
    EXPECT_FALSE(asymptoticTransfer(ConfusionMatrix(3), TransferBias::none));
    for (const double confidence : {0.0, 1.0, -1.0, std::nan("")})
        EXPECT_FALSE(asymptoticTransfer(symmetric(9, 1), TransferBias::none, confidence));
}

// One trial a row: T = 1 bit. Without either trial one row and one column are left: T_-i = 0. 2 * 1 - 1 * 0
// = 2.
TEST(JackknifeTransfer, isThatOfTwoTrials) {
    EXPECT_NEAR(*jackknifeTransfer(symmetric(1, 0)), 2.0, 1e-12);
    EXPECT_FALSE(jackknifeTransfer(ConfusionMatrix(2)));
}

// For many trials the jackknife's bias is Miller's, since both are of first order in 1/n.
TEST(JackknifeTransfer, agreesWithMillerForManyTrials) {
    const ConfusionMatrix matrix = symmetric(7000, 3000);
    const double bias_bit = transferBias(matrix, TransferBias::miller);
    EXPECT_NEAR(bias_bit, 1.0 / (40'000.0 * std::log(2.0)), 1e-12);
    EXPECT_NEAR(*measuredTransfer(matrix) - *jackknifeTransfer(matrix), bias_bit, 0.01 * bias_bit);
}

// G(2n+1) = G(2n), so of [[2, 1], [1, 2]] the G(3) of the columns cancel the G(2) of the cells but for
//   ln 2 + (G(1) - G(2)) / 3 = ln 2 - 2/3,  since G(2) - G(1) = 2.
TEST(TransferBias, ofGrassbergerIsThatOfATableWithAClosedForm) {
    const ConfusionMatrix matrix = symmetric(2, 1);
    EXPECT_NEAR(*measuredTransfer(matrix) - transferBias(matrix, TransferBias::grassberger),
                1.0 - 2.0 / 3.0 / std::log(2.0), 1e-14);
    EXPECT_NEAR(transferBias(symmetric(1, 0), TransferBias::grassberger), 0.0, 1e-14);
}

// Three rows, three columns, five cells that occur, ten trials: (5-3-3+1) / (20 ln 2) = 0, and Miller's 4 /
// (20 ln 2).
TEST(TransferBias, overOccupiedCellsLeavesOutThoseThatNobodyGave) {
    ConfusionMatrix matrix(3);
    matrix.add(0, 0, 4);
    matrix.add(1, 1, 2);
    matrix.add(1, 2, 1);
    matrix.add(2, 2, 2);
    matrix.add(2, 1, 1);
    EXPECT_EQ(transferBias(matrix, TransferBias::occupied), 0.0);
    EXPECT_NEAR(transferBias(matrix, TransferBias::miller), 4.0 / (20.0 * std::log(2.0)), 1e-14);
    EXPECT_EQ(transferBias(matrix, TransferBias::none), 0.0);
    EXPECT_EQ(transferBias(ConfusionMatrix(3), TransferBias::miller), 0.0);
}

TEST(CorrectedBootstrapTransfer, liesTwoBiasesBelowTheMeasuredOne) {
    const std::array participants{symmetric(9, 1), symmetric(8, 2), symmetric(7, 3), symmetric(9, 2)};
    const auto measured = *bootstrapTransfer(participants, 200, 3);
    const auto corrected = *correctedBootstrapTransfer(participants, 200, 3);
    // 82 trials in a table of two rows and two columns.
    const double shift_bit = 2.0 * 1.0 / (2.0 * 82.0 * std::log(2.0));
    EXPECT_NEAR(measured.high - corrected.high, shift_bit, 1e-12);
    EXPECT_NEAR(measured.low - corrected.low, shift_bit, 1e-12);
    EXPECT_FALSE(correctedBootstrapTransfer(std::span(participants).first(1), 200, 3));
}

} // namespace teleta::study
