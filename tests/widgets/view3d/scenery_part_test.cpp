// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/marks/scenery_part.h"

#include <gtest/gtest.h>

#include <limits>

namespace teleta::view3d {
namespace {

SceneryItem square(double z_m) {
    return {QStringLiteral("box"), {{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.0, 0.1}}, z_m};
}

} // namespace

TEST(SceneryPart, solidsReachAboveAndBelowTheirOutline) {
    SceneryPart scenery;
    EXPECT_TRUE(scenery.box_m().isEmpty());
    EXPECT_TRUE(scenery.set(std::vector{square(0.3)}));
    EXPECT_FALSE(scenery.set(std::vector{square(0.3)})) << "nothing changed";
    const Eigen::AlignedBox3d box = scenery.box_m();
    EXPECT_LT((box.min() - Eigen::Vector3d(0.0, 0.0, 0.285)).norm(), 1e-12);
    EXPECT_LT((box.max() - Eigen::Vector3d(0.2, 0.1, 0.315)).norm(), 1e-12);
    scenery.setVisible(false);
    EXPECT_TRUE(scenery.box_m().isEmpty());
    scenery.setVisible(true);
    EXPECT_TRUE(scenery.set({}));
    EXPECT_TRUE(scenery.box_m().isEmpty());
}

TEST(SceneryPart, leavesOutWhatIsNoSolid) {
    SceneryPart scenery;
    SceneryItem line = square(0.0);
    line.outline_m.resize(2);
    SceneryItem broken = square(0.0);
    broken.outline_m[1].x() = std::numeric_limits<double>::quiet_NaN();
    SceneryItem nowhere = square(std::numeric_limits<double>::infinity());
    EXPECT_TRUE(scenery.set(std::vector{line, broken, nowhere, square(0.1)}));
    EXPECT_EQ(scenery.items().size(), 1U);
}

TEST(SceneryPart, roundBodiesReachARadiusBeyondTheirAxis) {
    SceneryPart scenery;
    SceneryItem bar{
        .name = QStringLiteral("bar"), .axis_m = {{0.1, 0.0, 0.2}, {0.5, 0.0, 0.2}}, .radius_m = 0.01};
    SceneryItem ball{.name = QStringLiteral("ball"), .axis_m = {{0.0, 0.3, 0.0}}, .radius_m = 0.05};
    SceneryItem thin = bar;
    thin.radius_m = 0.0;
    SceneryItem broken = ball;
    broken.axis_m[0].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(scenery.set(std::vector{bar, ball, thin, broken}));
    EXPECT_EQ(scenery.items().size(), 2U);
    const Eigen::AlignedBox3d box = scenery.box_m();
    EXPECT_LT((box.min() - Eigen::Vector3d(-0.05, -0.01, -0.05)).norm(), 1e-12);
    EXPECT_LT((box.max() - Eigen::Vector3d(0.51, 0.35, 0.21)).norm(), 1e-12);
    EXPECT_EQ(SceneryPart::placeOfName_m(bar), Eigen::Vector3d(0.5, 0.0, 0.2));
}

} // namespace teleta::view3d
