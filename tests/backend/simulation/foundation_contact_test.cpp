// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/array/foundation_contact.h"
#include "tests/backend/simulation/array_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

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

Pressed pressed(const IndenterShape& shape, const Pose& pose) {
    return press(kLayout, kStiffness_NPerM, shape, pose);
}

void expectForce(const IndenterShape& shape, const Pose& pose, double volume_m3, double tolerance) {
    const Pressed result = pressed(shape, pose);
    const double expected_N = kBed_NPerM3 * volume_m3;
    EXPECT_NEAR(result.total_N(), expected_N, tolerance * expected_N);
    EXPECT_NEAR(result.truth.force_N, result.total_N(), 1e-12 * expected_N);
}

} // namespace

TEST(FoundationContact, carriesTheVolumeOfABallBelowTheSurface) {
    for (const double radius_m : {0.002, 0.005, 0.012})
        for (const double depth_m : {0.0002, 0.001, 0.0019})
            for (const double offset_m : {0.0, 0.0009, 0.0017})
                expectForce(Sphere{radius_m}, {offset_m, -0.5 * offset_m, depth_m, 0.7},
                            sphereVolume_m3(radius_m, depth_m), 0.01);
}

TEST(FoundationContact, carriesTheVolumeOfABarAtAnyAngle) {
    for (const double angle_rad : {0.0, 0.4, -0.9, std::numbers::pi / 2.0})
        for (const double depth_m : {0.0003, 0.001})
            expectForce(Cylinder{0.004, 0.009}, {0.001, 0.0005, depth_m, angle_rad},
                        0.009 * segmentArea_m2(0.004, depth_m), 0.01);
}

TEST(FoundationContact, carriesTheVolumeOfABoxEdgeAtAnyAngle) {
    for (const double angle_rad : {0.0, 0.4, -0.9, std::numbers::pi / 2.0})
        for (const double depth_m : {0.0003, 0.001})
            expectForce(BoxEdge{0.012}, {0.001, 0.0005, depth_m, angle_rad}, 0.012 * depth_m * depth_m, 0.01);
}

TEST(FoundationContact, carriesTheVolumeOfAFlatPunchAtAnyAngle) {
    expectForce(FlatPunch{0.0068, 0.0034}, {0.0, 0.0, 0.001, 0.0}, 0.0068 * 0.0034 * 0.001, 1e-12);
    expectForce(FlatPunch{0.0071, 0.0039}, {0.0003, -0.0011, 0.001, 0.0}, 0.0071 * 0.0039 * 0.001, 1e-12);
    for (const double angle_rad : {0.3, -1.1, std::numbers::pi / 2.0})
        expectForce(FlatPunch{0.0071, 0.0039}, {0.0003, -0.0011, 0.001, angle_rad}, 0.0071 * 0.0039 * 0.001,
                    0.01);
}

TEST(FoundationContact, loadsATaxelThatIsWhollyUnderAPunchWithItsOwnStiffness) {
    const Pressed result = pressed(FlatPunch{0.1, 0.1}, {0.0, 0.0, 0.0005, 0.0});
    for (const double load_N : result.load_N)
        EXPECT_NEAR(load_N, kStiffness_NPerM * 0.0005, 1e-12);
}

TEST(FoundationContact, carriesOnlyWhatLiesOnTheArray) {
    const double border_m = 7 * kLayout.pitchX_m;
    const Pressed half = pressed(Sphere{0.006}, {border_m, 0.0, 0.001, 0.0});
    EXPECT_NEAR(half.total_N(), 0.5 * kBed_NPerM3 * sphereVolume_m3(0.006, 0.001), 0.005);
    EXPECT_EQ(pressed(Sphere{0.006}, {border_m + 0.0061, 0.0, 0.001, 0.0}).total_N(), 0.0);
    EXPECT_FALSE(pressed(Sphere{0.006}, {border_m + 0.0061, 0.0, 0.001, 0.0}).truth.copX_m);
}

TEST(FoundationContact, hasItsCentreOfPressureUnderASymmetricBody) {
    for (const IndenterShape& shape :
         {IndenterShape(Sphere{0.006}), IndenterShape(Cylinder{0.004, 0.01}), IndenterShape(BoxEdge{0.01}),
          IndenterShape(FlatPunch{0.008, 0.004})}) {
        for (const Pose& pose :
             {Pose{0.0, 0.0, 0.001, 0.0}, Pose{0.0051, 0.0017, 0.001, std::numbers::pi / 2.0},
              Pose{-0.0041, 0.0012, 0.0013, 0.5}}) {
            const Pressed result = pressed(shape, pose);
            ASSERT_TRUE(result.truth.copX_m && result.truth.copY_m);
            EXPECT_NEAR(*result.truth.copX_m, pose.x_m, 0.01 * kLayout.pitchX_m);
            EXPECT_NEAR(*result.truth.copY_m, pose.y_m, 0.01 * kLayout.pitchX_m);
        }
    }
}

TEST(FoundationContact, loadsTheTaxelsAsSymmetricallyAsTheBodyLies) {
    const Pressed result = pressed(Cylinder{0.004, 0.02}, {0.0, 0.0, 0.001, 0.6});
    const std::size_t count = result.load_N.size();
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_NEAR(result.load_N[i], result.load_N[count - 1 - i], 1e-12);
    const Pressed mirrored = pressed(Cylinder{0.004, 0.02}, {0.0, 0.0, 0.001, -0.6});
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 14; ++column)
            EXPECT_NEAR(result.load_N[static_cast<std::size_t>(row * 14 + column)],
                        mirrored.load_N[static_cast<std::size_t>((5 - row) * 14 + column)], 1e-12);
}

TEST(FoundationContact, addsBodiesThatAreApartAndPressesOnceWhereTheyOverlap) {
    FoundationContact contact(kLayout, kStiffness_NPerM);
    std::vector<double> load_N(kLayout.taxels());
    std::vector<IndenterLoad> truth(2);
    std::vector<RigidIndenter> bodies{RigidIndenter(Sphere{0.005}), RigidIndenter(Sphere{0.005})};
    const double one_N = pressed(Sphere{0.005}, {-0.012, 0.0, 0.001, 0.0}).total_N();

    bodies[0].moveTo({-0.012, 0.0, 0.001, 0.0});
    bodies[1].moveTo({0.012, 0.0, 0.0, 0.0});
    contact.press(bodies, load_N, truth);
    EXPECT_DOUBLE_EQ(truth[0].force_N, one_N);
    EXPECT_EQ(truth[1].force_N, 0.0);

    bodies[1].moveTo({0.012, 0.0, 0.001, 0.0});
    contact.press(bodies, load_N, truth);
    EXPECT_NEAR(truth[0].force_N + truth[1].force_N, 2.0 * one_N, 1e-12);

    bodies[1].moveTo({-0.012, 0.0, 0.001, 0.0});
    contact.press(bodies, load_N, truth);
    EXPECT_NEAR(truth[0].force_N + truth[1].force_N, one_N, 1e-12);
}

// A body whose depth is at most d, moved by s, changes a taxel's load by at most k' d times the area that its
// outline sweeps in the taxel, which is at most s times the taxel's extent across the motion on either side.
TEST(FoundationContact, changesLoadsSmoothlyWhileABodyMoves) {
    constexpr double kStep_m = 1e-6;
    constexpr double kDepth_m = 0.001;
    const double limit_N = 2.0 * kBed_NPerM3 * kDepth_m * kStep_m * std::numbers::sqrt2 * kLayout.pitchX_m;
    for (const IndenterShape& shape :
         {IndenterShape(Sphere{0.006}), IndenterShape(Sphere{0.0012}), IndenterShape(Cylinder{0.004, 0.01}),
          IndenterShape(BoxEdge{0.01}), IndenterShape(FlatPunch{0.008, 0.004})}) {
        std::vector<double> before_N;
        double largest_N = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const double way_m = i * kStep_m;
            const Pressed now = pressed(shape, {0.8 * way_m, 0.6 * way_m, kDepth_m, 0.3});
            for (std::size_t taxel = 0; taxel < before_N.size(); ++taxel)
                largest_N = std::max(largest_N, std::abs(now.load_N[taxel] - before_N[taxel]));
            before_N = now.load_N;
        }
        EXPECT_GT(largest_N, 0.0);
        EXPECT_LE(largest_N, limit_N) << "shape " << shape.index();
    }
}
