// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_plane.h"

#include <gtest/gtest.h>

#include <vector>

namespace teleta::vision {
namespace {

MarkerGelFile plain() {
    MarkerGelFile file;
    file.grid = MarkerGrid::free;
    return file;
}

const std::vector<Eigen::Vector2d> kMarkers{{10.0, 20.0}, {42.0, 20.0}};

} // namespace

TEST(GelPlane, scalesByMmPerPixel) {
    MarkerGelFile file = plain();
    file.plane.mmPerPx = 0.0634;
    const auto plane = GelPlane::make(file, 320, 240, {});
    ASSERT_TRUE(plane);
    EXPECT_TRUE(plane->surface_m({100.0, 50.0}).isApprox(Eigen::Vector2d(0.00634, 0.00317), 1e-12));
    EXPECT_NEAR(plane->scale_m({10.0, 20.0}), 0.0634e-3, 1e-12);
}

TEST(GelPlane, scalesByThePitchOfTheMarkers) {
    MarkerGelFile file = plain();
    file.plane.pitch_mm = 2.0;
    const auto plane = GelPlane::make(file, 320, 240, kMarkers);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(plane->surface_m({32.0, 0.0}).x(), 0.002, 1e-12);
}

TEST(GelPlane, mapsByAHomography) {
    MarkerGelFile file = plain();
    // x = (0.001 u + 0.01) / (0.001 u + 1), y = 0.002 v / (0.001 u + 1)
    file.plane.homography = {0.001, 0.0, 0.01, 0.0, 0.002, 0.0, 0.001, 0.0, 1.0};
    const auto plane = GelPlane::make(file, 320, 240, kMarkers);
    ASSERT_TRUE(plane);
    EXPECT_TRUE(plane->surface_m({100.0, 50.0}).isApprox(Eigen::Vector2d(0.11 / 1.1, 0.1 / 1.1), 1e-12));
    file.plane.homography[6] = -0.01; // the denominator is 0 at u = 100
    EXPECT_FALSE(GelPlane::make(file, 320, 240, kMarkers));
}

TEST(GelPlane, takesTheLensAway) {
    MarkerGelFile file = plain();
    file.plane.mmPerPx = 1000.0; // places in m are pixels
    file.lens = MarkerGelFile::Lens{.fx_px = 300.0,
                                    .fy_px = 310.0,
                                    .cx_px = 160.0,
                                    .cy_px = 118.0,
                                    .k1 = -0.2,
                                    .k2 = 0.03,
                                    .p1 = 0.002,
                                    .p2 = -0.001};
    const auto plane = GelPlane::make(file, 320, 240, kMarkers);
    ASSERT_TRUE(plane);
    // OpenCV's model, written out: where a straight place is seen.
    const double x = 0.3, y = -0.2, s = x * x + y * y;
    const double q = 1.0 - 0.2 * s + 0.03 * s * s;
    const double seenX = q * x + 2.0 * 0.002 * x * y - 0.001 * (s + 2.0 * x * x);
    const double seenY = q * y + 0.002 * (s + 2.0 * y * y) - 2.0 * 0.001 * x * y;
    const Eigen::Vector2d straight = plane->surface_m({300.0 * seenX + 160.0, 310.0 * seenY + 118.0});
    EXPECT_NEAR(straight.x(), 300.0 * x + 160.0, 1e-8);
    EXPECT_NEAR(straight.y(), 310.0 * y + 118.0, 1e-8);
    file.lens->k1 = -3.0; // folds at r = 0.33
    file.lens->k2 = 0.0;
    EXPECT_FALSE(GelPlane::make(file, 320, 240, kMarkers));
    // Without a fold within the picture the far outside still shows nothing.
    file.lens->k1 = -0.2;
    const auto narrow = GelPlane::make(file, 320, 240, kMarkers);
    ASSERT_TRUE(narrow);
    EXPECT_FALSE(narrow->surface_m({3000.0, 118.0}).allFinite());
}

// Newton's method without bounds leaps away from such corners, though the lens shows each place once.
TEST(GelPlane, findsPlacesOfAStrongLens) {
    MarkerGelFile file = plain();
    file.plane.mmPerPx = 1000.0; // places in m are pixels
    for (const double k1 : {-0.6, -0.3, 1.0, 10.0, 100.0}) {
        file.lens =
            MarkerGelFile::Lens{.fx_px = 300.0, .fy_px = 300.0, .cx_px = 160.0, .cy_px = 120.0, .k1 = k1};
        const auto plane = GelPlane::make(file, 320, 240, kMarkers);
        if (!plane)
            continue;
        for (const double v : {0.0, 60.0, 120.0}) {
            const Eigen::Vector2d straight = plane->surface_m({320.0, v});
            const double x = (straight.x() - 160.0) / 300.0, y = (straight.y() - 120.0) / 300.0;
            const double q = 1.0 + k1 * (x * x + y * y);
            EXPECT_NEAR(300.0 * q * x + 160.0, 320.0, 1e-6) << k1;
            EXPECT_NEAR(300.0 * q * y + 120.0, v, 1e-6) << k1;
        }
    }
}

TEST(GelPlane, takesTheLensFromThePitch) {
    MarkerGelFile file = plain();
    file.plane.pitch_mm = 2.0;
    file.lens =
        MarkerGelFile::Lens{.fx_px = 300.0, .fy_px = 300.0, .cx_px = 160.0, .cy_px = 120.0, .k1 = -0.3};
    // Seen at 0.3 (1 - 0.3 0.09) and 0.4 (1 - 0.3 0.16) of the focal length: 30 px apart without the lens.
    const std::vector<Eigen::Vector2d> seen{{160.0 + 300.0 * 0.2919, 120.0}, {160.0 + 300.0 * 0.3808, 120.0}};
    const auto plane = GelPlane::make(file, 320, 240, seen);
    ASSERT_TRUE(plane);
    EXPECT_NEAR((plane->surface_m(seen[1]) - plane->surface_m(seen[0])).x(), 0.002, 1e-9);
}

} // namespace teleta::vision
