// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/contour_explorer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta;
using pipeline::ContourExplorer;

namespace {

Eigen::Vector3d onCircle(int index, int count, double radius_m, double z_m) {
    const double angle_rad = 2.0 * std::numbers::pi * index / count;
    return {0.4 + radius_m * std::cos(angle_rad), 0.1 + radius_m * std::sin(angle_rad), z_m};
}

} // namespace

TEST(ContourExplorer, tellsACircleFromTouchesAroundIt) {
    ContourExplorer explorer;
    for (int i = 0; i < 24; ++i)
        ASSERT_TRUE(explorer.add(onCircle(i, 24, 0.05, i % 2 == 0 ? 0.09 : 0.11)));
    const auto& contour = explorer.contour();
    EXPECT_EQ(contour.revision, 24U);
    EXPECT_EQ(contour.points_m.size(), 24U);
    EXPECT_NEAR(contour.height_m, 0.1, 1e-12);
    ASSERT_TRUE(contour.recognition);
    EXPECT_EQ(contour.recognition->shape, contour::Shape::circle);
    ASSERT_TRUE(contour.recognition->circle);
    EXPECT_NEAR(contour.recognition->circle->radius_m, 0.05, 1e-6);
    // Interpolating spline of a circle through 24 points: 0.00114 % off (Table 3 gives 0.02095 % with 12).
    ASSERT_EQ(contour.curve_m.size(), 24U * 12U + 1U);
    for (const contour::Point& p : contour.curve_m)
        EXPECT_NEAR((p - contour::Point(0.4, 0.1)).norm(), 0.05, 0.0002 * 0.05);
    EXPECT_LT((contour.curve_m.front() - contour.curve_m.back()).norm(), 1e-12) << "closed";
}

TEST(ContourExplorer, isDefinedForFewPoints) {
    ContourExplorer explorer;
    EXPECT_EQ(explorer.contour().revision, 0U);
    EXPECT_FALSE(explorer.contour().recognition);
    explorer.add({0.1, 0.2, 0.3});
    EXPECT_FALSE(explorer.contour().recognition) << "every object has a point";
    EXPECT_TRUE(explorer.contour().curve_m.empty());
    EXPECT_EQ(explorer.contour().height_m, 0.3);
    explorer.add({0.2, 0.2, 0.3});
    EXPECT_FALSE(explorer.contour().recognition) << "two points are on a line, whatever was touched";
    ASSERT_EQ(explorer.contour().curve_m.size(), 13U);
    EXPECT_NEAR(explorer.contour().curve_m.back().x(), 0.2, 1e-12);
    explorer.add({0.3, 0.2, 0.3});
    EXPECT_EQ(explorer.contour().recognition->shape, contour::Shape::line);
}

TEST(ContourExplorer, neighbouringTouchesAreAPointOnlyAfterMany) {
    ContourExplorer explorer;
    for (std::size_t i = 0; i < pipeline::ExploredContour::kLeastOfAPoint; ++i) {
        EXPECT_FALSE(explorer.contour().recognition);
        explorer.add({0.1, 0.2, 0.3});
    }
    EXPECT_EQ(explorer.contour().recognition->shape, contour::Shape::point);
}

TEST(ContourExplorer, countsATouchAtAPlaceThatIsKnown) {
    ContourExplorer explorer;
    for (int lap = 0; lap < 2; ++lap)
        for (int i = 0; i < 24; ++i)
            explorer.add(onCircle(i, 24, 0.05, 0.1));
    EXPECT_EQ(explorer.contour().points_m.size(), 48U);
    EXPECT_EQ(explorer.contour().recognition->shape, contour::Shape::circle);
    for (int again = 0; again < 3; ++again)
        explorer.add(onCircle(23, 24, 0.05, 0.1));
    EXPECT_EQ(explorer.contour().points_m.size(), 51U);
    for (const contour::Point& p : explorer.contour().curve_m)
        ASSERT_TRUE(p.allFinite());
}

TEST(ContourExplorer, refusesPointsThatAreNoNumbers) {
    ContourExplorer explorer;
    explorer.add({0.1, 0.2, 0.3});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Eigen::Vector3d& bad :
         {Eigen::Vector3d(nan, 0, 0), Eigen::Vector3d(0, 0, nan), Eigen::Vector3d(0, 1e200, 0)})
        EXPECT_FALSE(explorer.add(bad));
    EXPECT_EQ(explorer.contour().revision, 1U);
    EXPECT_EQ(explorer.contour().points_m.size(), 1U);
}

TEST(ContourExplorer, forgetsTheOldestBeyondItsLimit) {
    ContourExplorer explorer({.recognition = {}, .maximumPoints = 10});
    for (int i = 0; i < 25; ++i)
        explorer.add({0.01 * i, 0.0, 1.0 * i});
    ASSERT_EQ(explorer.contour().points_m.size(), 10U);
    EXPECT_NEAR(explorer.contour().points_m.front().x(), 0.15, 1e-12);
    EXPECT_NEAR(explorer.contour().height_m, 19.5, 1e-12) << "mean of 15 .. 24";
}

TEST(ContourExplorer, growsItsRevisionWithAReset) {
    ContourExplorer explorer;
    explorer.reset();
    EXPECT_EQ(explorer.contour().revision, 0U);
    explorer.add({0.1, 0.2, 0.3});
    explorer.add({0.2, 0.2, 0.3});
    explorer.reset();
    EXPECT_EQ(explorer.contour().revision, 3U);
    EXPECT_TRUE(explorer.contour().points_m.empty());
    EXPECT_TRUE(explorer.contour().curve_m.empty());
    EXPECT_FALSE(explorer.contour().recognition);
    explorer.add({0.2, 0.2, 0.5});
    EXPECT_EQ(explorer.contour().height_m, 0.5);
}
