// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/drawn_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using teleta::core::ArrayLayout;
using teleta::view3d::DrawnGrid;

TEST(DrawnGrid, aSmallArrayIsDrawnTaxelByTaxel) {
    const ArrayLayout layout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
    const DrawnGrid grid(layout);
    ASSERT_EQ(grid.block(), 1);
    ASSERT_EQ(grid.cells(), 6U);
    const std::vector<float> load = {0, 1, 2, 3, 4, 5};
    std::vector<float> cell(6);
    grid.pool(load, {}, cell);
    EXPECT_EQ(cell, load);
    const DrawnGrid::Edges corner = grid.edges(0, 0);
    EXPECT_DOUBLE_EQ(corner.x0_m, -0.015);
    EXPECT_DOUBLE_EQ(corner.x1_m, -0.005);
    EXPECT_DOUBLE_EQ(corner.y0_m, -0.010);
    EXPECT_DOUBLE_EQ(corner.y1_m, 0.0);
}

TEST(DrawnGrid, aLargeArrayIsDrawnInBlocksThatCoverItExactly) {
    const ArrayLayout layout{.rows = 300, .columns = 257, .pitchX_m = 0.001};
    const DrawnGrid grid(layout);
    EXPECT_EQ(grid.block(), 3); // 300 / 128, rounded up
    EXPECT_EQ(grid.rows(), 100);
    EXPECT_EQ(grid.columns(), 86);
    EXPECT_DOUBLE_EQ(grid.edges(0, 0).x0_m, -0.1285);
    EXPECT_NEAR(grid.edges(99, 85).x1_m, 0.1285, 1e-15);
    EXPECT_NEAR(grid.edges(99, 85).y1_m, 0.150, 1e-15);
    for (int column = 1; column < grid.columns(); ++column) {
        EXPECT_NEAR(grid.edges(0, column).x0_m, grid.edges(0, column - 1).x1_m, 1e-15);
    }
}

TEST(DrawnGrid, aPeakOfOneTaxelSurvivesTheBlocks) {
    const ArrayLayout layout{.rows = 1024, .columns = 1024, .pitchX_m = 0.001};
    const DrawnGrid grid(layout);
    EXPECT_EQ(grid.cells(), 128U * 128U);
    std::vector<float> load(layout.taxels(), 0.25F);
    load.at(1023 * 1024 + 17) = 9.0F;
    std::vector<float> cell(grid.cells());
    grid.pool(load, {}, cell);
    EXPECT_EQ(cell.at(grid.cellOf(1023, 17)), 9.0F);
    EXPECT_EQ(cell.at(grid.cellOf(0, 0)), 0.25F);
}

TEST(DrawnGrid, aBlockIsDeadOnlyWhenAllItsTaxelsAre) {
    const ArrayLayout layout{.rows = 2, .columns = 256, .pitchX_m = 0.001};
    const DrawnGrid grid(layout);
    ASSERT_EQ(grid.block(), 2);
    std::vector<float> load(layout.taxels(), 1.0F);
    std::vector<std::uint8_t> dead(layout.taxels(), 0);
    dead.at(0) = dead.at(1) = dead.at(256) = dead.at(257) = 1; // all of the first block
    dead.at(2) = 1;                                            // one of the second
    load.at(4) = std::numeric_limits<float>::infinity();
    load.at(6) = -3.0F;
    std::vector<float> cell(grid.cells());
    grid.pool(load, dead, cell);
    EXPECT_TRUE(std::isnan(cell.at(0)));
    EXPECT_EQ(cell.at(1), 1.0F);
    EXPECT_EQ(cell.at(2), 1.0F);
    EXPECT_EQ(cell.at(3), 1.0F);
}

TEST(DrawnGrid, oneTaxelThatIsNegativeShowsNoLoad) {
    const DrawnGrid grid(ArrayLayout{.rows = 1, .columns = 1, .pitchX_m = 0.0034});
    std::vector<float> cell(1);
    grid.pool(std::vector<float>{-2.0F}, {}, cell);
    EXPECT_EQ(cell.at(0), 0.0F);
    grid.pool(std::vector<float>{std::numeric_limits<float>::quiet_NaN()}, {}, cell);
    EXPECT_TRUE(std::isnan(cell.at(0)));
}
