// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene/place_raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

using namespace teleta;
using core::TaxelPlace;
using core::TaxelPlaces;
using view3d::PlaceRaster;

namespace {

/// The cell in which a point lies.
std::size_t cellAt(const core::ArrayLayout& grid, double x_m, double y_m) {
    const auto line = [](double place_m, double pitch_m, int count) {
        return static_cast<std::size_t>(
            std::clamp(static_cast<int>(std::floor(place_m / pitch_m + 0.5 * count)), 0, count - 1));
    };
    return line(y_m, grid.pitchY_m, grid.rows) * static_cast<std::size_t>(grid.columns) +
           line(x_m, grid.pitchX_m, grid.columns);
}

/// Of a frame in which each taxel bears its number and 1 more, and is a contact.
pipeline::TouchSnapshot numbered(const std::shared_ptr<const TaxelPlaces>& places) {
    pipeline::TouchSnapshot snapshot;
    snapshot.layout = core::TaxelLayout(places);
    for (std::size_t i = 0; i < places->size(); ++i) {
        snapshot.load_N.push_back(static_cast<float>(i + 1));
        snapshot.labels.push_back(static_cast<std::int32_t>(i + 1));
        snapshot.dead.push_back(0);
    }
    return snapshot;
}

} // namespace

TEST(PlaceRaster, givesEachTaxelTheCellsOfItsDisc) {
    const auto places = std::make_shared<const TaxelPlaces>(
        std::vector<TaxelPlace>{{-0.005, -0.004}, {0.005, -0.004}, {0.0, 0.006}});
    const PlaceRaster raster(*places);
    const core::ArrayLayout& grid = raster.layout().grid();
    const pipeline::TouchSnapshot drawn = raster.drawn(numbered(places));
    ASSERT_EQ(drawn.load_N.size(), grid.taxels());
    for (std::size_t taxel = 0; taxel < places->size(); ++taxel) {
        const TaxelPlace& place = (*places)[taxel];
        const double inside_m = 0.35 * places->spacing_m(taxel);
        for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
            const std::size_t cell =
                cellAt(grid, place.x_m + inside_m * std::cos(angle), place.y_m + inside_m * std::sin(angle));
            EXPECT_EQ(drawn.load_N[cell], static_cast<float>(taxel + 1));
            EXPECT_EQ(drawn.labels[cell], static_cast<std::int32_t>(taxel + 1));
            EXPECT_EQ(drawn.dead[cell], 0);
            EXPECT_FALSE(raster.layout().isAbsent(cell));
        }
    }
    const std::size_t corner = cellAt(grid, 0.009, 0.010);
    EXPECT_TRUE(raster.layout().isAbsent(corner));
    EXPECT_EQ(drawn.labels[corner], 0);
    EXPECT_EQ(drawn.dead[corner], 0) << "no taxel is no dead one";
    EXPECT_EQ(drawn.load_N[corner], 0.0F);
}

TEST(PlaceRaster, keepsAnyLayoutSmallAndShowsEachTaxel) {
    const std::vector<std::vector<TaxelPlace>> layouts{
        {{0.0, 0.0}},
        {{-1.0, 0.0}, {-0.999, 0.0}, {1.0, 0.0}, {0.0, 0.3}},
        {{-0.01, 0.0}, {0.0, 0.0}, {0.01, 0.0}},
    };
    for (const auto& list : layouts) {
        const auto places = std::make_shared<const TaxelPlaces>(list);
        const PlaceRaster raster(*places);
        EXPECT_LE(raster.layout().grid().rows, PlaceRaster::kMostSide);
        EXPECT_LE(raster.layout().grid().columns, PlaceRaster::kMostSide);
        const pipeline::TouchSnapshot drawn = raster.drawn(numbered(places));
        // The first two of the second layout share a cell, which one of them gets.
        std::size_t shown = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            shown += std::ranges::find(drawn.load_N, static_cast<float>(i + 1)) != drawn.load_N.end() ? 1 : 0;
        EXPECT_EQ(shown, list.size() == 4 ? 3U : list.size());
    }
}

TEST(PlaceRaster, leavesOutTheShearAndKeepsDeadTaxelsDead) {
    const auto places =
        std::make_shared<const TaxelPlaces>(std::vector<TaxelPlace>{{-0.005, 0.0}, {0.005, 0.001}});
    pipeline::TouchSnapshot snapshot = numbered(places);
    snapshot.layout = core::TaxelLayout(places, 3);
    snapshot.shearX_N = {1.0F, 2.0F};
    snapshot.shearY_N = {1.0F, 2.0F};
    snapshot.dead = {1, 0};
    const PlaceRaster raster(*places);
    const pipeline::TouchSnapshot drawn = raster.drawn(snapshot);
    EXPECT_TRUE(drawn.shearX_N.empty());
    EXPECT_FALSE(drawn.layout.isVector());
    EXPECT_EQ(drawn.dead[cellAt(raster.layout().grid(), -0.005, 0.0)], 1);
    EXPECT_EQ(drawn.dead[cellAt(raster.layout().grid(), 0.005, 0.001)], 0);
}
