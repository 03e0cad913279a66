// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/confusion_matrix.h"
#include "tests/backend/study/paper_tables.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::study {

TEST(ConfusionMatrix, isEmptyAtFirstAndHasNoPercentThen) {
    const ConfusionMatrix matrix(6);
    EXPECT_EQ(matrix.total(), 0);
    EXPECT_EQ(matrix.correct(), 0);
    EXPECT_FALSE(matrix.accuracy());
    EXPECT_FALSE(matrix.rowPercent(0, 0));
}

TEST(ConfusionMatrix, countsATrialWithoutAnswerInItsOwnColumn) {
    ConfusionMatrix matrix(5);
    matrix.add(2, std::nullopt);
    matrix.add(2, 2);
    matrix.add(2, 3);
    matrix.add(2, 2);
    EXPECT_EQ(matrix.count(2, matrix.noneColumn()), 1);
    EXPECT_EQ(matrix.unanswered(), 1);
    EXPECT_EQ(matrix.rowTotal(2), 4);
    EXPECT_EQ(matrix.columnTotal(2), 2);
    EXPECT_EQ(matrix.correct(), 2);
    EXPECT_DOUBLE_EQ(*matrix.accuracy(), 0.5);
    EXPECT_DOUBLE_EQ(*matrix.rowPercent(2, matrix.noneColumn()), 25.0);
}

TEST(ConfusionMatrix, refusesAPatternThatDoesNotExist) {
    ConfusionMatrix matrix(5);
    EXPECT_THROW(matrix.add(5, 0), std::out_of_range);
}

TEST(ConfusionMatrix, addsTheTrialsOfAnother) {
    ConfusionMatrix sum = matrixOf(kPaperTables[0].counts);
    sum.add(matrixOf(kPaperTables[1].counts));
    EXPECT_EQ(sum.total(), 360);
    EXPECT_EQ(sum.count(0, 0), 48);
    EXPECT_EQ(sum.count(4, 3), 6);
}

TEST(ConfusionMatrix, givesTheTablesOfThePaperFromTheirCounts) {
    for (const PaperTable& table : kPaperTables) {
        const ConfusionMatrix matrix = matrixOf(table.counts);
        for (std::size_t i = 0; i < table.percent.size(); ++i) {
            EXPECT_EQ(matrix.rowTotal(i), 30) << table.name << " row " << i;
            for (std::size_t j = 0; j < table.percent.size(); ++j)
                EXPECT_DOUBLE_EQ(std::round(*matrix.rowPercent(i, j) * 10.0) / 10.0, table.percent[i][j])
                    << table.name << " row " << i << " column " << j;
        }
    }
}

} // namespace teleta::study
