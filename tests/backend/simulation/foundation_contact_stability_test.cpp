// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/foundation_contact.h"
#include "tests/backend/simulation/array_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace teleta::simulation;
using namespace teleta::simulation::test;
using teleta::core::ArrayLayout;
using teleta::scene::BoxEdge;
using teleta::scene::Cylinder;
using teleta::scene::FlatPunch;
using teleta::scene::IndenterShape;
using teleta::scene::Sphere;

namespace {

const ArrayLayout kLayout{6, 14, 0.0034};
constexpr double kStiffness_NPerM = 1200.0;
const double kBed_NPerM3 = kStiffness_NPerM / kLayout.taxelArea_m2();

const std::vector<IndenterShape> kShapes{Sphere{0.006}, Cylinder{0.004, 0.01}, BoxEdge{0.01},
                                         FlatPunch{0.008, 0.004}};

double total_N(const IndenterShape& shape, const Pose& pose) {
    return press(kLayout, kStiffness_NPerM, shape, pose).total_N();
}

} // namespace

TEST(FoundationContactStability, hasNoForceAtDepthZeroOrAbove) {
    for (const IndenterShape& shape : kShapes) {
        EXPECT_EQ(total_N(shape, {0.0, 0.0, 0.0, 0.3}), 0.0);
        EXPECT_EQ(total_N(shape, {0.0, 0.0, -1e-300, 0.3}), 0.0);
        EXPECT_EQ(total_N(shape, {0.0, 0.0, -1e300, 0.3}), 0.0);
    }
}

TEST(FoundationContactStability, followsTheClosedFormDownToTheSmallestDepths) {
    for (double depth_m = 1e-3; depth_m > 1e-16; depth_m *= 0.1) {
        // acos loses what the segment's small height needs: its leading terms instead, relative error d/R.
        const double segment_m2 = 4.0 / 3.0 * depth_m * std::sqrt(2.0 * 0.004 * depth_m);
        const Pose pose{0.0003, 0.0011, depth_m, 0.0};
        // The edge's width is found beside its position, which is rounded: the condition number is
        // position/width.
        const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * 0.0011 / depth_m;
        EXPECT_NEAR(total_N(Sphere{0.006}, pose) / (kBed_NPerM3 * sphereVolume_m3(0.006, depth_m)), 1.0,
                    0.01);
        EXPECT_NEAR(total_N(BoxEdge{0.01}, pose) / (kBed_NPerM3 * 0.01 * depth_m * depth_m), 1.0,
                    1e-12 + rounding);
        EXPECT_NEAR(total_N(FlatPunch{0.008, 0.004}, pose) / (kBed_NPerM3 * 0.008 * 0.004 * depth_m), 1.0,
                    1e-12);
        if (depth_m < 1e-4) {
            EXPECT_NEAR(total_N(Cylinder{0.004, 0.01}, pose) / (kBed_NPerM3 * 0.01 * segment_m2), 1.0, 0.01);
        }
    }
}

TEST(FoundationContactStability, followsTheClosedFormForTheSmallestRadii) {
    for (double radius_m = 1e-3; radius_m > 1e-10; radius_m *= 0.1) {
        for (const double depth : {0.01, 0.5, 0.999, 1.0, 1.001, 10.0, 1e6}) {
            const double depth_m = depth * radius_m;
            const Pose pose{0.0003, 0.0011, depth_m, 0.0};
            EXPECT_NEAR(total_N(Sphere{radius_m}, pose) / (kBed_NPerM3 * sphereVolume_m3(radius_m, depth_m)),
                        1.0, 0.02)
                << radius_m << " " << depth;
            EXPECT_NEAR(total_N(Cylinder{radius_m, 0.01}, pose) /
                            (kBed_NPerM3 * 0.01 * segmentArea_m2(radius_m, depth_m)),
                        1.0, 0.02)
                << radius_m << " " << depth;
        }
    }
}

// A ball that is flat over the whole array: the mean of r^2 over a rectangle W x H is (W^2 + H^2)/12.
TEST(FoundationContactStability, followsTheClosedFormForTheLargestRadii) {
    const double width_m = 14 * kLayout.pitchX_m;
    const double height_m = 6 * kLayout.pitchX_m;
    for (double radius_m = 1e2; radius_m < 1e13; radius_m *= 10.0) {
        constexpr double kDepth_m = 1e-3;
        const double mean_m = kDepth_m - (width_m * width_m + height_m * height_m) / 12.0 / (2.0 * radius_m);
        EXPECT_NEAR(total_N(Sphere{radius_m}, {0, 0, kDepth_m, 0}) / (84 * kStiffness_NPerM * mean_m), 1.0,
                    1e-6);
        const double meanAcross_m = kDepth_m - height_m * height_m / 12.0 / (2.0 * radius_m);
        EXPECT_NEAR(total_N(Cylinder{radius_m, 1.0}, {0, 0, kDepth_m, 0}) /
                        (84 * kStiffness_NPerM * meanAcross_m),
                    1.0, 1e-6);
    }
}

TEST(FoundationContactStability, growsInProportionToAHugeDepth) {
    for (const double depth_m : {1.0, 1e3, 1e9}) {
        for (const IndenterShape& shape : kShapes) {
            const double force_N = total_N(shape, {0.001, 0.0, depth_m, 0.2});
            const double twice_N = total_N(shape, {0.001, 0.0, 2.0 * depth_m, 0.2});
            EXPECT_TRUE(std::isfinite(force_N));
            // A box edge that deep covers the whole array; the others have walls and keep their outline.
            EXPECT_NEAR(twice_N / force_N, 2.0, 0.03) << depth_m << " shape " << shape.index();
        }
    }
}

TEST(FoundationContactStability, scalesExactlyWithStiffnessAndWithSize) {
    for (const IndenterShape& shape : kShapes) {
        const Pose pose{0.0013, -0.0021, 0.0012, 0.4};
        const std::vector<double> soft_N = press(kLayout, 1.0, shape, pose).load_N;
        for (double stiffness_NPerM = 1.0; stiffness_NPerM < 1.1e9; stiffness_NPerM *= 10.0) {
            const std::vector<double> load_N = press(kLayout, stiffness_NPerM, shape, pose).load_N;
            for (std::size_t i = 0; i < load_N.size(); ++i)
                EXPECT_NEAR(load_N[i], stiffness_NPerM * soft_N[i],
                            8.0 * std::numeric_limits<double>::epsilon() * load_N[i]);
        }
    }
    // Powers of two scale without rounding: lengths times s give loads times s.
    const std::vector<double> load_N =
        press(kLayout, kStiffness_NPerM, Cylinder{0.004, 0.01}, {0.001, 0.002, 0.001, 0.4}).load_N;
    for (const double s : {0x1p-40, 0x1p-10, 0x1p10, 0x1p40}) {
        const std::vector<double> scaled_N =
            press({6, 14, s * 0.0034}, kStiffness_NPerM, Cylinder{s * 0.004, s * 0.01},
                  {s * 0.001, s * 0.002, s * 0.001, 0.4})
                .load_N;
        for (std::size_t i = 0; i < load_N.size(); ++i)
            EXPECT_EQ(scaled_N[i], s * load_N[i]);
    }
}

TEST(FoundationContactStability, takesTheSmallestAndTheLargestArray) {
    const Pressed one = press({1, 1, 0.01}, 500.0, FlatPunch{1.0, 1.0}, {0, 0, 0.002, 0});
    EXPECT_NEAR(one.total_N(), 1.0, 1e-12);
    const ArrayLayout large{1024, 1024, 0.001};
    const Pressed result = press(large, 100.0, Sphere{0.02}, {0.3, -0.2, 0.004, 0});
    EXPECT_NEAR(result.total_N() / (100.0 / 1e-6 * sphereVolume_m3(0.02, 0.004)), 1.0, 0.001);
    EXPECT_EQ(press(large, 100.0, Sphere{0.02}, {1e12, -1e12, 0.004, 0}).total_N(), 0.0);
}
