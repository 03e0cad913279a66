// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/skin/sphere_imprint.h"
#include "backend/vision/finders/skin_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

namespace teleta::vision {
namespace {

constexpr double kRadius_m = 0.025;
constexpr double kPitch_m = 0.004;
constexpr int kAround = 39;

/// Nodes on a grid around the whole tube, and their neighbours.
struct Skin {
    std::vector<SkinNode> nodes;
    std::vector<std::vector<std::size_t>> neighbours;

    Skin() {
        const int rings = 25;
        for (int ring = 0; ring < rings; ++ring) {
            for (int i = 0; i < kAround; ++i)
                nodes.push_back({.angle_rad = 2.0 * std::numbers::pi * (i + 0.5 * (ring % 2)) / kAround,
                                 .z_m = kPitch_m * (ring + 0.5),
                                 .known = true});
        }
        neighbours.resize(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                if (i != k && distance_m(nodes[i], nodes[k].angle_rad, nodes[k].z_m) < 1.75 * kPitch_m)
                    neighbours[i].push_back(k);
            }
        }
    }
    static double distance_m(const SkinNode& node, double angle_rad, double z_m) {
        return std::hypot(kRadius_m * std::remainder(node.angle_rad - angle_rad, 2.0 * std::numbers::pi),
                          node.z_m - z_m);
    }
    void press(double angle_rad, double z_m, double depth_m, double width_m = 0.004) {
        for (SkinNode& node : nodes)
            node.inward_m +=
                depth_m * std::exp(-0.5 * std::pow(distance_m(node, angle_rad, z_m) / width_m, 2));
    }
    /// A ball's imprint alone.
    void imprint(double angle_rad, double z_m, const simulation::SphereImprint& ball) {
        for (SkinNode& node : nodes)
            node.inward_m = ball.depth_m(distance_m(node, angle_rad, z_m));
    }
    [[nodiscard]] std::vector<SkinPatch> find() const {
        return SkinPatches(SkinPatches::Settings()).find(nodes, neighbours);
    }
};

} // namespace

TEST(SkinPatches, deepenByWhatTheirOwnPointsDidThatAreKnownInBothFrames) {
    Skin skin;
    for (SkinNode& node : skin.nodes)
        node.inwardBefore_m = 0.0;
    skin.press(0.5, 0.03, 0.0005);
    for (SkinNode& node : skin.nodes)
        node.inwardBefore_m = node.inward_m;
    skin.press(0.5, 0.03, 0.0003);
    auto patches = skin.find();
    ASSERT_EQ(patches.size(), 1U);
    // Both summits have the same shape, so the deepest point has gained 3 parts of 8 of its depth.
    EXPECT_NEAR(patches[0].deepened_m, patches[0].depth_m * 3.0 / 8.0, 1e-12);
    // The deepest point was lost before, so its depth now is not a change.
    skin.nodes[patches[0].nodes.front()].inwardBefore_m = NAN;
    patches = skin.find();
    EXPECT_LT(patches[0].deepened_m, patches[0].depth_m * 3.0 / 8.0);
    EXPECT_GT(patches[0].deepened_m, 0.0);
    for (SkinNode& node : skin.nodes)
        node.inwardBefore_m = NAN;
    EXPECT_TRUE(std::isnan(skin.find()[0].deepened_m));
}

TEST(SkinPatches, haveNoDepthFromAPointThatJumpsAlone) {
    Skin skin;
    skin.press(0.5, 0.03, 0.0008);
    for (SkinNode& node : skin.nodes)
        node.inwardBefore_m = node.inward_m;
    const double depth_m = skin.find()[0].depth_m;
    const std::size_t beside = skin.find()[0].nodes[1];
    skin.nodes[beside].inward_m += 0.001; // taken for the dot of the next ring
    ASSERT_EQ(skin.find().size(), 1U);
    EXPECT_NEAR(skin.find()[0].depth_m, depth_m, 1e-12);
    EXPECT_NEAR(skin.find()[0].deepened_m, 0.0, 1e-12);
    // If others move with it, a dent grows.
    skin.press(0.5, 0.03, 0.0008);
    EXPECT_GT(skin.find()[0].depth_m, 1.5 * depth_m);
}

TEST(SkinPatches, haveNoDepthBeforeFromAPointThatHadJumpedAloneEither) {
    Skin skin;
    skin.press(0.5, 0.03, 0.0008);
    const auto nextFrame = [&] {
        for (SkinNode& node : skin.nodes)
            node.inwardBefore_m = node.inward_m;
    };
    nextFrame();
    SkinPatches patches{SkinPatches::Settings()};
    const SkinPatch before = patches.find(skin.nodes, skin.neighbours)[0];
    skin.nodes[before.nodes[1]].inward_m += 0.001; // taken for the dot of the next ring
    ASSERT_NEAR(patches.find(skin.nodes, skin.neighbours)[0].deepened_m, 0.0, 1e-12);
    // It is found again, and the dent grows by a quarter of its depth.
    nextFrame();
    skin.nodes[before.nodes[1]].inward_m -= 0.001;
    skin.press(0.5, 0.03, 0.0002);
    const SkinPatch after = patches.find(skin.nodes, skin.neighbours)[0];
    EXPECT_NEAR(after.deepened_m, 0.25 * before.depth_m, 1e-12);
    // Nothing is remembered about other nodes.
    nextFrame();
    skin.nodes[before.nodes[1]].inward_m += 0.001;
    static_cast<void>(patches.find(skin.nodes, skin.neighbours));
    patches.forget();
    nextFrame();
    EXPECT_NEAR(patches.find(skin.nodes, skin.neighbours)[0].deepened_m, 0.0, 1e-12);
}

TEST(SkinPatches, countSeveralPointsThatAreLostAtOnceAsAJump) {
    Skin skin;
    skin.press(0.5, 0.03, 0.0008);
    for (SkinNode& node : skin.nodes)
        node.inwardBefore_m = node.inward_m;
    const std::vector<std::size_t> nodes = skin.find()[0].nodes;
    ASSERT_GE(nodes.size(), 6U);
    const SkinPatches::Settings settings;
    for (std::size_t lost = 1; lost <= settings.leastLost; ++lost) {
        skin.nodes[nodes[2 * lost - 1]].known = false;
        EXPECT_NEAR(skin.find()[0].deepened_m, lost < settings.leastLost ? 0.0 : settings.jump_m, 1e-12);
    }
}

TEST(SkinPatches, haveTheCentreOfASmoothSummitBetweenTheirPointsAlsoAtTheSeam) {
    for (const double angle_rad : {0.0, 0.03, 1.234, std::numbers::pi, -3.1}) {
        for (const double z_m : {0.03, 0.0313, 0.0327}) {
            Skin skin;
            skin.press(angle_rad, z_m, 0.001);
            const auto patches = skin.find();
            ASSERT_EQ(patches.size(), 1U);
            EXPECT_NEAR(std::remainder(patches[0].angle_rad - angle_rad, 2.0 * std::numbers::pi) * kRadius_m,
                        0.0, 1e-4);
            EXPECT_NEAR(patches[0].z_m, z_m, 1e-4);
            EXPECT_GT(patches[0].depth_m, 0.0007);
            EXPECT_LE(patches[0].depth_m, 0.001);
        }
    }
}

/// A ball that rolls from one point to the next must not appear to move back and forth.
TEST(SkinPatches, haveACentreThatHardlyDependsOnWhereAPressLiesBetweenThePoints) {
    Skin skin;
    constexpr int kSteps = 8;
    double squares_m2 = 0.0;
    double worst_m = 0.0;
    int presses = 0;
    for (const double radius_m : {0.006, 0.008, 0.012}) {
        for (const double depth_m : {0.0006, 0.0008, 0.0012, 0.0016}) {
            const simulation::SphereImprint ball(radius_m, depth_m, 0.0015);
            for (int step = 0; step < kSteps * kSteps; ++step) {
                // The grid repeats after one point around and two rings.
                const double angle_rad =
                    0.3 + 2.0 * std::numbers::pi / kAround * (step % kSteps) / static_cast<double>(kSteps);
                const double z_m =
                    0.048 + 2.0 * kPitch_m * static_cast<double>(step / kSteps) / static_cast<double>(kSteps);
                skin.imprint(angle_rad, z_m, ball);
                const auto patches = skin.find();
                ASSERT_EQ(patches.size(), 1U) << radius_m << " " << depth_m << " " << step;
                const double error_m = std::hypot(
                    kRadius_m * std::remainder(patches[0].angle_rad - angle_rad, 2.0 * std::numbers::pi),
                    patches[0].z_m - z_m);
                squares_m2 += error_m * error_m;
                worst_m = std::max(worst_m, error_m);
                ++presses;
            }
        }
    }
    const double rms_m = std::sqrt(squares_m2 / presses);
    std::cout << "centre off by " << 1e3 * rms_m << " mm rms, " << 1e3 * worst_m << " mm at most\n";
    EXPECT_LT(rms_m, 0.0001);
    EXPECT_LT(worst_m, 0.00025);
}

TEST(SkinPatches, separateTwoContactsThatMeetAndMergeOnesThatHardlyRise) {
    Skin apart;
    apart.press(0.0, 0.05, 0.001, 0.003);
    apart.press(0.64, 0.05, 0.0012, 0.003);
    const auto two = apart.find();
    ASSERT_EQ(two.size(), 2U);
    EXPECT_NEAR(two[0].angle_rad, 0.64, 0.06); // the stronger one first
    EXPECT_NEAR(two[1].angle_rad, 0.0, 0.06);
    Skin together;
    together.press(0.0, 0.05, 0.001, 0.004);
    together.press(0.3, 0.05, 0.001, 0.004);
    EXPECT_EQ(together.find().size(), 1U);
}

TEST(SkinPatches, areNoneOnSkinAtRestAndBelowTheThreshold) {
    Skin skin;
    EXPECT_TRUE(skin.find().empty());
    skin.press(0.0, 0.05, 0.0001);
    EXPECT_TRUE(skin.find().empty());
}

TEST(SkinPatches, passOverPointsThatAreNotKnownAndSinglePoints) {
    Skin skin;
    skin.nodes[500].inward_m = 0.002;
    EXPECT_TRUE(skin.find().empty());
    skin.press(0.0, 0.05, 0.001);
    for (SkinNode& node : skin.nodes)
        node.known = false;
    EXPECT_TRUE(skin.find().empty());
}

} // namespace teleta::vision
