// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/repeated_anova.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace teleta::study {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Correct of 5 of eight participants, patterns P1..P6 static, then dynamic.
ParticipantCells dataSetA() {
    ParticipantCells cells;
    for (const std::string row : {"552555443555", "242141533232", "443221542142", "443351554443",
                                  "432242542352", "442423543552", "554534554545", "543332453544"}) {
        std::vector<double> values;
        for (const char digit : row)
            values.push_back(digit - '0');
        cells.push_back(values);
    }
    return cells;
}

/// Half a unit of the last digit that the reference prints.
struct Printed {
    double value;
    double halfUnit;
};

void expectPrinted(double value, Printed printed) {
    EXPECT_NEAR(value, printed.value, printed.halfUnit * 1.02);
}

} // namespace

// Expected values: R 4.2.2.
TEST(TwoWayAnova, conditionOfDataSetAIsThatOfR) {
    const auto table = twoWayAnova(dataSetA(), 2, 6);
    ASSERT_TRUE(table && table->first);
    const AnovaEffect& effect = *table->first;
    EXPECT_EQ(table->participants, 8U);
    EXPECT_EQ(effect.df1, 1.0);
    EXPECT_EQ(effect.df2, 7.0);
    expectPrinted(effect.f, {18.77777778, 0.5e-8});
    expectPrinted(effect.p, {0.003423860, 0.5e-9});
    EXPECT_EQ(effect.epsilonGg, 1.0);
    expectPrinted(effect.pGg, {0.003423860, 0.5e-9});
    EXPECT_EQ(effect.epsilonHf, 1.0);
    expectPrinted(effect.partialEta2, {0.72844828, 0.5e-8});
    expectPrinted(effect.generalizedEta2, {0.06751898, 0.5e-8});
}

TEST(TwoWayAnova, patternOfDataSetAIsThatOfR) {
    const auto table = twoWayAnova(dataSetA(), 2, 6);
    ASSERT_TRUE(table && table->second);
    const AnovaEffect& effect = *table->second;
    EXPECT_EQ(effect.df1, 5.0);
    EXPECT_EQ(effect.df2, 35.0);
    expectPrinted(effect.f, {7.85446, 0.5e-5});
    expectPrinted(effect.p, {4.8232e-05, 0.5e-9});
    expectPrinted(effect.epsilonGg, {0.46106707, 0.5e-8});
    expectPrinted(effect.pGg, {0.0031684, 0.5e-7});
    expectPrinted(effect.epsilonHf.value(), {0.70048381, 0.5e-8});
    // The reference cuts 0.000483447556 off after its ninth digit.
    expectPrinted(effect.pHf.value(), {0.000483447, 1.0e-9});
    expectPrinted(effect.partialEta2, {0.52876106, 0.5e-8});
    expectPrinted(effect.generalizedEta2, {0.29057751, 0.5e-8});
}

TEST(TwoWayAnova, interactionOfDataSetAIsThatOfR) {
    const auto table = twoWayAnova(dataSetA(), 2, 6);
    ASSERT_TRUE(table && table->interaction);
    const AnovaEffect& effect = *table->interaction;
    EXPECT_EQ(effect.df1, 5.0);
    EXPECT_EQ(effect.df2, 35.0);
    expectPrinted(effect.f, {0.40039, 0.5e-5});
    expectPrinted(effect.p, {0.8451842, 0.5e-7});
    expectPrinted(effect.epsilonGg, {0.63897237, 0.5e-8});
    expectPrinted(effect.pGg, {0.7658334, 0.5e-7});
    expectPrinted(effect.epsilonHf.value(), {1.23826752, 0.5e-8});
    EXPECT_DOUBLE_EQ(effect.pHf.value(), effect.p);
    expectPrinted(effect.partialEta2, {0.05410448, 0.5e-8});
    expectPrinted(effect.generalizedEta2, {0.01227253, 0.5e-8});
}

TEST(TwoWayAnova, leavesOutParticipantsWithAMissingCellAndNamesThem) {
    ParticipantCells cells = dataSetA();
    cells.insert(cells.begin() + 2, std::vector<double>(12, 3.0));
    cells[2][7] = kMissing;
    const auto table = twoWayAnova(cells, 2, 6);
    ASSERT_TRUE(table && table->first);
    EXPECT_EQ(table->dropped, (std::vector<std::size_t>{2}));
    EXPECT_EQ(table->participants, 8U);
    EXPECT_NEAR(table->first->f, 18.77777778, 1e-8);
}

TEST(TwoWayAnova, saysWhyThereIsNoTable) {
    EXPECT_EQ(twoWayAnova({}, 2, 6).error(), Refusal::noData);
    EXPECT_EQ(twoWayAnova(dataSetA(), 1, 12).error(), Refusal::tooFewLevels);
    EXPECT_EQ(twoWayAnova(dataSetA(), 2, 5).error(), Refusal::badShape);
    EXPECT_EQ(twoWayAnova({dataSetA().front()}, 2, 6).error(), Refusal::oneParticipant);
    ParticipantCells cells = dataSetA();
    cells[3][3] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(twoWayAnova(cells, 2, 6).error(), Refusal::notFinite);
}

TEST(TwoWayAnova, hasNoFWhenEverybodyIsAlwaysRight) {
    const auto table = twoWayAnova(ParticipantCells(6, std::vector<double>(12, 1.0)), 2, 6);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->first.error(), Refusal::noVariance);
    EXPECT_EQ(table->second.error(), Refusal::noVariance);
    EXPECT_EQ(table->interaction.error(), Refusal::noVariance);
}

TEST(TwoWayAnova, hasNoInfiniteFWhenAllParticipantsShowTheSameEffect) {
    ParticipantCells cells;
    for (int i = 0; i < 6; ++i)
        cells.push_back({0.2 + 0.1 * i, 0.2 + 0.1 * i, 0.4 + 0.1 * i, 0.4 + 0.1 * i});
    const auto table = twoWayAnova(cells, 2, 2);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->first.error(), Refusal::noErrorVariance);
    EXPECT_EQ(table->second.error(), Refusal::noVariance);
}

TEST(TwoWayAnova, twoParticipantsHaveNoHuynhFeldtForMoreThanOneContrast) {
    const ParticipantCells all = dataSetA();
    const auto table = twoWayAnova({all[0], all[1]}, 2, 6);
    ASSERT_TRUE(table && table->first && table->second);
    EXPECT_EQ(table->first->epsilonHf, 1.0);
    EXPECT_NEAR(table->second->epsilonGg, 0.2, 1e-12);
    EXPECT_FALSE(table->second->epsilonHf);
    EXPECT_FALSE(table->second->pHf);
}

// Differences 1, 2, 3, 4: mean 2.5, deviation sqrt(5/3), t = 2.5 / sqrt(5/12), F = t^2 = 15 with 1 and 3
// degrees of freedom; p = 1 - P(|t_3| < sqrt(15)), in closed form.
TEST(OneWayAnova, ofTwoLevelsIsThePairedTTest) {
    const auto table = oneWayAnova({{5, 6}, {1, 3}, {4, 7}, {0, 4}});
    ASSERT_TRUE(table && table->effect);
    EXPECT_NEAR(table->effect->f, 15.0, 1e-12);
    EXPECT_EQ(table->effect->df2, 3.0);
    const double theta = std::atan(std::sqrt(15.0 / 3.0));
    const double p = 1.0 - 2.0 / std::acos(-1.0) * (theta + std::sin(theta) * std::cos(theta));
    EXPECT_NEAR(table->effect->p, p, 1e-12);
}

TEST(IncompleteParticipants, areThoseWithAMissingCell) {
    EXPECT_EQ(incompleteParticipants({{1, 2}, {kMissing, 3}, {4, 5}, {6, kMissing}}),
              (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(incompleteParticipants({}).empty());
}

TEST(OneWayAnova, saysWhyThereIsNoEffect) {
    EXPECT_EQ(oneWayAnova({}).error(), Refusal::noData);
    EXPECT_EQ(oneWayAnova({{1}, {2}}).error(), Refusal::tooFewLevels);
    EXPECT_EQ(oneWayAnova({{1, 2}}).error(), Refusal::oneParticipant);
    EXPECT_EQ(oneWayAnova({{1, 2}, {kMissing, 3}}).error(), Refusal::oneParticipant);
    EXPECT_EQ(oneWayAnova({{1, 1}, {2, 2}, {3, 3}})->effect.error(), Refusal::noVariance);
    EXPECT_EQ(oneWayAnova({{1, 2}, {2, 3}, {3, 4}})->effect.error(), Refusal::noErrorVariance);
}

} // namespace teleta::study
