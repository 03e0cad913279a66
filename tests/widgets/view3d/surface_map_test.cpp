// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/mesh/surface_map.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace teleta;
using view3d::cylinderThatFits;
using view3d::Surface;
using view3d::SurfaceMap;

namespace {

constexpr double kRadius_m = 0.025;
constexpr double kTolerance_m = 1e-15;

} // namespace

TEST(SurfaceMap, aPlateLeavesThePointsWhereTheyAre) {
    const SurfaceMap map;
    EXPECT_EQ(map.point(0.01, -0.02, 0.003), Eigen::Vector3d(0.01, -0.02, 0.003));
    EXPECT_EQ(map.normal(0.5), Eigen::Vector3d::UnitZ());
}

TEST(SurfaceMap, theCentreOfTheArrayIsOnTopOfTheCylinder) {
    const SurfaceMap map(Surface::cylinder, kRadius_m);
    EXPECT_LT((map.point(0.0, 0.0, 0.0) - Eigen::Vector3d(0, 0, kRadius_m)).norm(), kTolerance_m);
    EXPECT_LT((map.normal(0.0) - Eigen::Vector3d::UnitZ()).norm(), kTolerance_m);
}

TEST(SurfaceMap, aQuarterOfTheCircumferenceIsAQuarterTurnTowardPositiveY) {
    const SurfaceMap map(Surface::cylinder, kRadius_m);
    const double quarter_m = 0.5 * std::numbers::pi * kRadius_m;
    EXPECT_LT((map.point(0.01, quarter_m, 0.002) - Eigen::Vector3d(0.01, kRadius_m + 0.002, 0)).norm(),
              kTolerance_m);
    EXPECT_LT((map.point(0.01, -quarter_m, 0.002) - Eigen::Vector3d(0.01, -kRadius_m - 0.002, 0)).norm(),
              kTolerance_m);
}

TEST(SurfaceMap, lengthsOnTheSurfaceAreKept) {
    // Arc length of a line on the surface, summed over short chords, against its length in the array's plane.
    const SurfaceMap map(Surface::cylinder, kRadius_m);
    const Eigen::Vector2d from(-0.03, -0.04), to(0.02, 0.05);
    constexpr int kSteps = 20000;
    double length_m = 0.0;
    Eigen::Vector3d before = map.point(from.x(), from.y(), 0.0);
    for (int i = 1; i <= kSteps; ++i) {
        const Eigen::Vector2d p = from + (to - from) * (static_cast<double>(i) / kSteps);
        const Eigen::Vector3d now = map.point(p.x(), p.y(), 0.0);
        length_m += (now - before).norm();
        before = now;
    }
    EXPECT_NEAR(length_m, (to - from).norm(), 1e-9);
}

TEST(SurfaceMap, heightsAreAlongTheNormalAndTheFrameIsRightHanded) {
    const SurfaceMap map(Surface::cylinder, kRadius_m);
    for (const double y_m : {-0.07, -0.01, 0.0, 0.033, 0.078}) {
        const Eigen::Vector3d foot = map.point(0.004, y_m, 0.0);
        const Eigen::Vector3d top = map.point(0.004, y_m, 0.006);
        EXPECT_LT((top - foot - 0.006 * map.normal(y_m)).norm(), kTolerance_m);
        constexpr double kStep_m = 1e-7;
        const Eigen::Vector3d alongX = (map.point(0.004 + kStep_m, y_m, 0.0) - foot) / kStep_m;
        const Eigen::Vector3d alongY = (map.point(0.004, y_m + kStep_m, 0.0) - foot) / kStep_m;
        EXPECT_LT((alongX.cross(alongY) - map.normal(y_m)).norm(), 1e-5);
    }
}

TEST(SurfaceMap, theCylinderGrowsOnlyWhenTheArrayDoesNotFit) {
    const view3d::CylinderSize nominal;
    EXPECT_EQ(cylinderThatFits(nominal, {.rows = 6, .columns = 14, .pitchX_m = 0.0034}), nominal);
    // 64 columns of 3.4 mm are 217.6 mm long; 60 rows are 204 mm around.
    const view3d::CylinderSize grown =
        cylinderThatFits(nominal, {.rows = 60, .columns = 64, .pitchX_m = 0.0034});
    EXPECT_DOUBLE_EQ(grown.length_m, 0.2176);
    EXPECT_DOUBLE_EQ(grown.radius_m, 0.204 / (2.0 * std::numbers::pi));
}
