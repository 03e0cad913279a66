// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/taxel_layout.h"
#include "backend/core/data/taxel_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace teleta::core {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

std::vector<TaxelPlace> gridOf(int rows, int columns, double pitchX_m, double pitchY_m) {
    std::vector<TaxelPlace> places;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            places.push_back({column * pitchX_m, row * pitchY_m});
    return places;
}

std::vector<std::size_t> neighboursOf(const TaxelPlaces& places, std::size_t taxel) {
    std::vector<std::size_t> neighbours = places.neighbours()[taxel];
    std::ranges::sort(neighbours);
    return neighbours;
}

TEST(TaxelPlaces, joinsTheEightAroundATaxelOfAGrid) {
    for (const double pitchY_m : {0.004, 0.009}) {
        const TaxelPlaces places(gridOf(4, 5, 0.004, pitchY_m));
        EXPECT_EQ(neighboursOf(places, 6), (std::vector<std::size_t>{0, 1, 2, 5, 7, 10, 11, 12}));
        EXPECT_EQ(neighboursOf(places, 0), (std::vector<std::size_t>{1, 5, 6}));
        EXPECT_DOUBLE_EQ(places.pitch_m(), 0.004);
    }
}

TEST(TaxelPlaces, aTaxelInTrianglesHasAHexagonForACell) {
    // Seven taxels, six around one: all have the cell of the one in the middle.
    constexpr double kPitch_m = 0.004;
    std::vector<TaxelPlace> seven{{}};
    for (int i = 0; i < 6; ++i)
        seven.push_back({kPitch_m * std::cos(i * std::numbers::pi / 3.0),
                         kPitch_m * std::sin(i * std::numbers::pi / 3.0)});
    const TaxelPlaces places(seven);
    // A hexagon with its sides p / 2 from its middle: 6 triangles of height p / 2.
    const double hexagon_m2 = 6.0 * 0.5 * (kPitch_m / 2.0) * (kPitch_m / std::numbers::sqrt3);
    for (std::size_t taxel = 0; taxel < 7; ++taxel)
        EXPECT_NEAR(places.area_m2(taxel), hexagon_m2, 1e-12 * hexagon_m2) << taxel;
    const TaxelPlaces squares(gridOf(4, 5, kPitch_m, kPitch_m));
    for (std::size_t taxel = 0; taxel < 20; ++taxel)
        EXPECT_NEAR(squares.area_m2(taxel), kPitch_m * kPitch_m, 1e-12 * kPitch_m) << taxel;
}

TEST(TaxelPlaces, joinsTaxelsOfALineToTheNextOnes) {
    const TaxelPlaces places({{0.0, 0.0}, {0.004, 0.003}, {0.008, 0.006}, {0.016, 0.012}});
    EXPECT_EQ(neighboursOf(places, 1), (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(neighboursOf(places, 2), (std::vector<std::size_t>{1, 3}));
    EXPECT_DOUBLE_EQ(places.spacing_m(0), 0.005);
    EXPECT_DOUBLE_EQ(places.spacing_m(3), 0.010);
    EXPECT_DOUBLE_EQ(places.area_m2(3), 0.010 * 0.010);
}

TEST(TaxelPlaces, keepsTheFingersOfAHandApart) {
    std::vector<TaxelPlace> places = gridOf(2, 2, 0.004, 0.004);
    for (TaxelPlace other : gridOf(2, 2, 0.004, 0.004)) {
        other.x_m += 0.020;
        places.push_back(other);
    }
    const TaxelPlaces hand(places);
    EXPECT_EQ(neighboursOf(hand, 1), (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_EQ(neighboursOf(hand, 4), (std::vector<std::size_t>{5, 6, 7}));
}

TEST(TaxelPlaces, joinsTheChipsOfACross) {
    const TaxelPlaces cross({{0.0, 0.0}, {0.007, 0.0}, {-0.007, 0.0}, {0.0, 0.007}, {0.0, -0.007}});
    EXPECT_EQ(neighboursOf(cross, 0), (std::vector<std::size_t>{1, 2, 3, 4}));
    EXPECT_EQ(neighboursOf(cross, 1), (std::vector<std::size_t>{0, 3, 4}));
}

TEST(TaxelPlaces, hasASpacingForASingleTaxel) {
    const TaxelPlaces one({{0.1, -0.2}});
    EXPECT_TRUE(one.neighbours()[0].empty());
    EXPECT_EQ(one.spacing_m(0), TaxelPlaces::kLoneSpacing_m);
    EXPECT_EQ(one.pitch_m(), TaxelPlaces::kLoneSpacing_m);
}

TEST(TaxelPlaces, findsTaxelsAtTheSamePlace) {
    EXPECT_EQ(TaxelPlaces::sameOf({{0.0, 0.0}, {0.001, 0.0}, {0.001, 5e-7}}), Pair(1, 2));
    EXPECT_EQ(TaxelPlaces::sameOf({{0.0, 0.0}, {0.0, 0.0, 0.001}}), std::nullopt) << "one above the other";
    EXPECT_EQ(TaxelPlaces::sameOf({}), std::nullopt);
}

TEST(TaxelLayout, countsTheNumbersOfAFrame) {
    const TaxelLayout loads(ArrayLayout{2, 3, 0.004, 0.010});
    EXPECT_EQ(loads.values(), 6U);
    EXPECT_DOUBLE_EQ(loads.x_m(5), 0.004);
    EXPECT_DOUBLE_EQ(loads.y_m(5), 0.005);
    EXPECT_DOUBLE_EQ(loads.area_m2(5), 4e-5);
    const TaxelLayout vectors(std::make_shared<const TaxelPlaces>(gridOf(2, 3, 0.004, 0.010)), 3);
    EXPECT_EQ(vectors.taxels(), 6U);
    EXPECT_EQ(vectors.values(), 18U);
    EXPECT_FALSE(vectors.isGrid());
    EXPECT_DOUBLE_EQ(vectors.y_m(5), 0.010);
}

TEST(TaxelLayout, isTheSameWhenItsContentIs) {
    const auto places = [] { return std::make_shared<const TaxelPlaces>(gridOf(2, 2, 0.004, 0.004)); };
    EXPECT_EQ(TaxelLayout(places(), 3), TaxelLayout(places(), 3));
    EXPECT_NE(TaxelLayout(places(), 3), TaxelLayout(places(), 1));
    EXPECT_NE(TaxelLayout(places()), TaxelLayout(ArrayLayout{1, 4, 0.004}));
    TaxelLayout masked(ArrayLayout{1, 2, 0.004});
    masked.setAbsent({0, 1});
    EXPECT_NE(masked, TaxelLayout(ArrayLayout{1, 2, 0.004}));
    EXPECT_TRUE(masked.isAbsent(1));
    masked.setAbsent({0, 0});
    EXPECT_EQ(masked, TaxelLayout(ArrayLayout{1, 2, 0.004})) << "nothing is absent";
}

} // namespace
} // namespace teleta::core
