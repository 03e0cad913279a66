// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/information_transfer.h"
#include "backend/study/analysis/study_transfer.h"
#include "tests/backend/study/answering_people.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace teleta::study {
namespace {

/// Right with this share, and otherwise any other answer.
Shares symmetric(std::size_t patterns, double right) {
    Shares shares(patterns,
                  std::vector<double>(patterns, (1.0 - right) / (static_cast<double>(patterns) - 1.0)));
    for (std::size_t i = 0; i < patterns; ++i)
        shares[i][i] = right;
    return shares;
}

/// Shares of the cases with an interval, and of those whose interval or bound holds the truth.
struct Coverage {
    double intervals = 0.0;
    double held = 0.0;
    double corrected_bit = 0.0; ///< mean
};

Coverage coverageOf(const Design& design, const Shares& shares, int cases) {
    std::mt19937_64 random(20261123);
    const double truth_bit = trueTransfer_bit(shares);
    Coverage coverage;
    for (int i = 0; i < cases; ++i) {
        const auto transfer = studyTransfer(simulate(design, shares, random));
        coverage.intervals += transfer->interval ? 1.0 / cases : 0.0;
        coverage.held += holds(*transfer, truth_bit) ? 1.0 / cases : 0.0;
        coverage.corrected_bit += transfer->corrected_bit / cases;
    }
    return coverage;
}

std::string nameOf(const Design& design) {
    return std::to_string(design.people) + " x " + std::to_string(design.presentations) +
           ", alike: " + std::to_string(design.alike);
}

} // namespace

// Fifteen rows of 95 %, with 1500 cases each, have a standard error of 0.6 %.
TEST(StudyTransfer, intervalsHoldTheTrueTransferOfThePapersTablesAlsoWherePeopleDiffer) {
    for (const Design& design : {Design{6, 5, 0.0}, Design{6, 5, 20.0}, Design{6, 5, 5.0}, Design{12, 5, 0.0},
                                 Design{12, 5, 5.0}, Design{24, 10, 0.0}, Design{24, 10, 5.0}})
        for (const PaperTable& table : kPaperTables) {
            const Shares shares = sharesOf(table);
            const Coverage coverage = coverageOf(design, shares, 1500);
            const std::string of = table.name + ", " + nameOf(design);
            EXPECT_GE(coverage.intervals, 0.95) << of;
            EXPECT_GE(coverage.held, 0.90) << of;
            EXPECT_LE(coverage.held, 0.98) << of;
            EXPECT_NEAR(coverage.corrected_bit, trueTransfer_bit(shares), 0.03) << of;
        }
}

TEST(StudyTransfer, threePeopleWithTwoPresentationsHaveABoundThatHolds) {
    for (const double alike : {0.0, 5.0})
        for (const PaperTable& table : kPaperTables) {
            const Coverage coverage = coverageOf({3, 2, alike}, sharesOf(table), 500);
            EXPECT_EQ(coverage.intervals, 0.0);
            EXPECT_GE(coverage.held, 0.95) << table.name << alike;
        }
}

// Where nearly all is right, or nearly nothing, the jackknife sees too few different answers.
TEST(StudyTransfer, whatIsSaidAboutPeopleWhoAreNearlyAlwaysRightOrGuessHoldsToo) {
    for (const Design& design : {Design{6, 5, 0.0}, Design{12, 5, 5.0}})
        for (const double right : {1.0 / 6.0, 0.3, 0.97, 0.99, 1.0})
            EXPECT_GE(coverageOf(design, symmetric(6, right), 500).held, 0.90)
                << right << ' ' << nameOf(design);
}

// [[9, 1], [1, 9]] and [[1, 1], [1, 1]], so h = 24/20 and 24/4; T, T_-1 and T_-2 are of [[10, 2], [2, 10]],
// [[1, 1], [1, 1]] and [[9, 1], [1, 9]].
TEST(StudyTransfer, weighsParticipantsByTheirTrials) {
    const auto binary_bit = [](double right) {
        return 1.0 + right * std::log2(right) + (1.0 - right) * std::log2(1.0 - right);
    };
    const auto transfer = studyTransfer(std::vector{matrixOf({{9, 1}, {1, 9}}), matrixOf({{1, 1}, {1, 1}})});
    ASSERT_TRUE(transfer);
    const double measured_bit = binary_bit(10.0 / 12.0);
    EXPECT_NEAR(transfer->measured_bit, measured_bit, 1e-14);
    EXPECT_NEAR(transfer->corrected_bit,
                2.0 * measured_bit - (1.0 - 20.0 / 24.0) * 0.0 - (1.0 - 4.0 / 24.0) * binary_bit(0.9), 1e-14);
    EXPECT_EQ(transfer->doubt, TransferDoubt::fewParticipants);
}

TEST(StudyTransfer, ofOneParticipantIsThatOfTheMatrix) {
    const ConfusionMatrix matrix = matrixOf(kPaperTables[1].counts);
    const auto transfer = studyTransfer(std::vector{matrix, ConfusionMatrix(6)});
    ASSERT_TRUE(transfer) << "who has no trials does not count";
    EXPECT_EQ(transfer->corrected_bit, informationTransfer(matrix)->corrected_bit);
    EXPECT_EQ(transfer->doubt, TransferDoubt::fewParticipants);
    EXPECT_GT(transfer->atMost_bit, transfer->measured_bit);
    EXPECT_FALSE(studyTransfer({}));
    EXPECT_FALSE(studyTransfer(std::vector(3, ConfusionMatrix(6))));
}

// All of 180 right: at least Fano's bound with e = 1 - 0.05^(1/180) wrong.
TEST(StudyTransfer, ofPeopleWhoAreAlwaysRightIsAtLeastFanosBound) {
    ConfusionMatrix person(6);
    for (std::size_t i = 0; i < 6; ++i)
        person.add(i, i, 5);
    const auto transfer = studyTransfer(std::vector(6, person));
    ASSERT_TRUE(transfer && transfer->atLeast_bit);
    const double e = 1.0 - std::pow(0.05, 1.0 / 180.0);
    EXPECT_EQ(transfer->doubt, TransferDoubt::fewDifferent);
    EXPECT_NEAR(*transfer->atLeast_bit,
                std::log2(6.0) + e * std::log2(e) + (1.0 - e) * std::log2(1.0 - e) - e * std::log2(5.0),
                1e-12);
    EXPECT_FALSE(transfer->interval);
    EXPECT_FALSE(transfer->atMost_bit);
}

TEST(StudyTransfer, saysWhyThereIsOnlyABound) {
    const auto doubtOf = [](const std::vector<ConfusionMatrix>& people, std::size_t alternatives = 0) {
        return studyTransfer(people, alternatives)->doubt;
    };
    ConfusionMatrix same(2);
    same.add(0, 0, 20);
    same.add(1, 0, 20);
    EXPECT_EQ(doubtOf(std::vector(6, same)), TransferDoubt::likeGuessing) << "always the same answer";
    EXPECT_EQ(doubtOf(std::vector(6, matrixOf({{5, 5}, {5, 5}}))), TransferDoubt::likeGuessing);
    const ConfusionMatrix good = matrixOf({{9, 1}, {1, 9}});
    EXPECT_EQ(doubtOf(std::vector(3, good)), TransferDoubt::fewParticipants);
    EXPECT_EQ(doubtOf(std::vector(5, good)), TransferDoubt::none);
    EXPECT_EQ(doubtOf(std::vector(5, good), 6), TransferDoubt::fewTrials) << "100 of 4 6^2";
    EXPECT_EQ(doubtOf(std::vector(4, good)), TransferDoubt::fewDifferent);
    for (const TransferDoubt doubt : {TransferDoubt::fewParticipants, TransferDoubt::fewTrials,
                                      TransferDoubt::fewDifferent, TransferDoubt::likeGuessing}) {
        EXPECT_FALSE(explain(doubt).empty());
        EXPECT_STRNE(toString(doubt), "");
    }
    EXPECT_TRUE(explain(TransferDoubt::none).empty());
}

} // namespace teleta::study
