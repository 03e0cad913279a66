// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/vision/gel/marker_layout.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace teleta::vision {
namespace {

struct Printed {
    std::vector<Eigen::Vector2d> places_px;
    std::vector<GridPlace> grid;
};

/// A grid that is turned, uneven, bent as a lens bends it and misprinted.
Printed printed(int rows, int columns, double alongV, double turn_rad) {
    Printed result;
    core::RandomStream random(2);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            Eigen::Vector2d place(30.0 * (column - 0.5 * (columns - 1)),
                                  alongV * 30.0 * (row - 0.5 * (rows - 1)));
            place *= 1.0 - 2e-6 * place.squaredNorm();
            place = Eigen::Rotation2Dd(turn_rad) * place;
            place += Eigen::Vector2d(random.normal(), random.normal());
            result.places_px.push_back(place + Eigen::Vector2d(200.0, 200.0));
            result.grid.push_back({row, column});
        }
    }
    return result;
}

void expectSame(const std::vector<GridPlace>& found, const std::vector<GridPlace>& wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].row, wanted[i].row) << i;
        EXPECT_EQ(found[i].column, wanted[i].column) << i;
    }
}

} // namespace

TEST(MarkerLayout, numbersABentTurnedAndUnevenGrid) {
    for (const double alongV : {0.7, 1.0, 1.4}) {
        for (const double turn_rad : {-0.5, 0.0, 0.3}) {
            const Printed grid = printed(8, 10, alongV, turn_rad);
            expectSame(gridPlaces(grid.places_px, MarkerGrid::rectangular, 8, 10), grid.grid);
        }
    }
}

TEST(MarkerLayout, leavesOutMissingMarkersAndWhatIsNoneOfTheGrid) {
    Printed grid = printed(8, 10, 1.0, 0.1);
    for (const std::ptrdiff_t missing : {63, 44, 12, 0}) {
        grid.places_px.erase(grid.places_px.begin() + missing);
        grid.grid.erase(grid.grid.begin() + missing);
    }
    grid.places_px.emplace_back(200.0, 201.0); // between four markers
    grid.grid.push_back({-1, -1});
    grid.places_px.emplace_back(500.0, 200.0);
    grid.grid.push_back({-1, -1});
    expectSame(gridPlaces(grid.places_px, MarkerGrid::rectangular, 8, 10), grid.grid);
}

TEST(MarkerLayout, hasNoPlacesInAFreeGridOrWithoutMarkers) {
    const Printed grid = printed(4, 4, 1.0, 0.0);
    for (const GridPlace& place : gridPlaces(grid.places_px, MarkerGrid::free, 0, 0))
        EXPECT_EQ(place.row, -1);
    EXPECT_TRUE(gridPlaces({}, MarkerGrid::rectangular, 4, 4).empty());
    const std::vector<Eigen::Vector2d> one{{1.0, 2.0}};
    EXPECT_EQ(gridPlaces(one, MarkerGrid::rectangular, 4, 4).front().row, -1);
    EXPECT_EQ(nearestDistance_px(one), 0.0);
    EXPECT_TRUE(markerNeighbours(one).front().empty());
}

TEST(MarkerLayout, findsTheEightNeighboursOfASquareGrid) {
    std::vector<Eigen::Vector2d> places;
    for (int i = 0; i < 25; ++i)
        places.emplace_back(10.0 * (i % 5), 10.0 * (i / 5)); // NOLINT(bugprone-integer-division)
    const auto neighbours = markerNeighbours(places);
    EXPECT_EQ(neighbours[12].size(), 8U);
    EXPECT_EQ(neighbours[0].size(), 3U);
    EXPECT_EQ(neighbours[2].size(), 5U);
    EXPECT_NEAR(nearestDistance_px(places), 10.0, 1e-12);
}

} // namespace teleta::vision
