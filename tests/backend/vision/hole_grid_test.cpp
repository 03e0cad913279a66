// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/camera/hole_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace teleta::vision {

TEST(HoleGrid, isTheShellOfThePaperWith250HolesOnTheSkin) {
    const CylinderSurface skin;
    const std::vector<Eigen::Vector3d> holes_m = holesOnSkin_m({}, skin);
    ASSERT_EQ(holes_m.size(), 250U);
    for (const Eigen::Vector3d& hole_m : holes_m) {
        EXPECT_NEAR(hole_m.head<2>().norm(), skin.radius_m, 1e-15);
        EXPECT_GE(hole_m.z(), skin.lowest_z_m);
        EXPECT_LE(hole_m.z(), skin.highest_z_m);
    }
}

TEST(HoleGrid, goesAroundRingByRingFromTheAngleOfTheFirstHole) {
    const HoleGrid grid{.around = 4,
                        .along = 3,
                        .first_z_m = 0.01,
                        .last_z_m = 0.05,
                        .firstAngle_rad = 0.5 * std::numbers::pi};
    const std::vector<Eigen::Vector3d> holes_m = holesOnSkin_m(grid, {.radius_m = 0.02});
    ASSERT_EQ(holes_m.size(), 12U);
    EXPECT_LT((holes_m[0] - Eigen::Vector3d(0.0, 0.02, 0.01)).norm(), 1e-15);
    EXPECT_LT((holes_m[1] - Eigen::Vector3d(-0.02, 0.0, 0.01)).norm(), 1e-15);
    EXPECT_LT((holes_m[4] - Eigen::Vector3d(0.0, 0.02, 0.03)).norm(), 1e-15);
    EXPECT_LT((holes_m[11] - Eigen::Vector3d(0.02, 0.0, 0.05)).norm(), 1e-15);
    EXPECT_EQ(grid.ring(11), 2);
}

TEST(HoleGrid, mayBeOneRing) {
    const HoleGrid grid{.around = 2, .along = 1, .first_z_m = 0.03, .last_z_m = 0.09};
    EXPECT_EQ(grid.z_m(0), 0.03);
    EXPECT_EQ(holesOnSkin_m(grid, {}).size(), 2U);
}

} // namespace teleta::vision
