// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/probing_plan.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace teleta::simulation {
namespace {

scene::Probing probing() {
    scene::Probing probing;
    probing.around = 20;
    probing.along = 10;
    probing.first_z_m = 0.01;
    probing.last_z_m = 0.09;
    probing.depth_m = 0.001;
    return probing;
}

} // namespace

TEST(ProbingPlan, visitsAGridOnTheSkinRingByRing) {
    const ProbingPlan plan(probing(), {}, 1);
    ASSERT_EQ(plan.holes().size(), 200U);
    EXPECT_EQ(plan.duration_s(), 200.0);
    EXPECT_LT((plan.holes()[0].p_Sensor_Noted_m - Eigen::Vector3d(0.025, 0.0, 0.01)).norm(), 1e-12);
    EXPECT_LT((plan.holes()[5].p_Sensor_Noted_m - Eigen::Vector3d(0.0, 0.025, 0.01)).norm(), 1e-12);
    EXPECT_NEAR(plan.holes()[199].p_Sensor_Noted_m.z(), 0.09, 1e-12);
    for (const ProbedHole& hole : plan.holes()) {
        EXPECT_FALSE(hole.mistaken);
        const Eigen::Vector3d truly(0.025 * std::cos(hole.truly.angle_rad),
                                    0.025 * std::sin(hole.truly.angle_rad), hole.truly.z_m);
        EXPECT_LT((truly - hole.p_Sensor_Noted_m).norm(), 1e-12);
    }
    EXPECT_EQ(plan.holeAt(-1.0), 0U);
    EXPECT_EQ(plan.holeAt(7.9), 7U);
    EXPECT_EQ(plan.holeAt(1e9), 199U);
}

TEST(ProbingPlan, mistakesAHoleForItsNeighbourAsOftenAsAsked) {
    scene::Probing careless = probing();
    careless.wrongShare = 0.2;
    careless.around = 100;
    const ProbingPlan plan(careless, {}, 1);
    const auto mistaken = std::ranges::count_if(plan.holes(), &ProbedHole::mistaken);
    // 1000 holes: 200 with a standard deviation of 12.6.
    EXPECT_NEAR(static_cast<double>(mistaken), 200.0, 50.0);
    for (const ProbedHole& hole : plan.holes()) {
        const Eigen::Vector3d truly(0.025 * std::cos(hole.truly.angle_rad),
                                    0.025 * std::sin(hole.truly.angle_rad), hole.truly.z_m);
        const double off_m = (truly - hole.p_Sensor_Noted_m).norm();
        if (hole.mistaken) {
            EXPECT_GT(off_m, 0.0015);
        } else {
            EXPECT_LT(off_m, 1e-12);
        }
        EXPECT_LT(off_m, 0.01);
    }
}

TEST(ProbingPlan, isTheSameForTheSameSeedAndMistakesChangeNothingElse) {
    scene::Probing shaky = probing();
    shaky.play_m = 0.0001;
    const ProbingPlan a(shaky, {}, 4);
    const ProbingPlan b(shaky, {}, 4);
    shaky.wrongShare = 0.3;
    const ProbingPlan c(shaky, {}, 4);
    int mistaken = 0;
    for (std::size_t i = 0; i < a.holes().size(); ++i) {
        EXPECT_EQ(a.holes()[i].truly.angle_rad, b.holes()[i].truly.angle_rad);
        mistaken += c.holes()[i].mistaken ? 1 : 0;
        if (!c.holes()[i].mistaken) {
            EXPECT_EQ(a.holes()[i].truly.z_m, c.holes()[i].truly.z_m);
        }
    }
    EXPECT_GT(mistaken, 0);
}

TEST(ProbingPlan, movesAStickThatTouchesAtEachHoleAndIsLiftedBetweenThem) {
    scene::Scene scene = test::cameraScene(false);
    scene.rate_Hz = 10.0;
    scene.camera().camera = {.width_px = 410, .height_px = 308, .focalLength_px = 146.0};
    scene.camera().probing = probing();
    auto tube = SimulatedTube::make(scene, 1);
    ASSERT_TRUE(tube) << describe(tube.error());
    ASSERT_TRUE((*tube)->probing());
    cv::Mat1b frame;
    for (int i = 0; i < 3; ++i) {
        for (int step = 1; step <= 10; ++step) {
            (*tube)->next({}, frame);
            const FingerTruth& stick = (*tube)->truth().back();
            const Eigen::Vector3d& noted =
                (*tube)->probing()->holes()[static_cast<std::size_t>(i)].p_Sensor_Noted_m;
            if (step >= 3 && step <= 8) {
                EXPECT_TRUE(stick.touches) << i << ' ' << step;
                EXPECT_NEAR(stick.press.depth_m, 0.001, 1e-9);
                EXPECT_LT((stick.p_Sensor_Centre_m - noted).norm(), 1e-9);
            }
            if (step == 10) {
                EXPECT_FALSE(stick.touches);
            }
        }
    }
}

TEST(ProbingPlan, isRefusedWithNumbersThatAreNoProbing) {
    for (const auto& spoil : std::vector<void (*)(scene::Probing&)>{
             [](scene::Probing& p) { p.around = 0; }, [](scene::Probing& p) { p.along = 1'000'000; },
             [](scene::Probing& p) { p.depth_m = 0.0; }, [](scene::Probing& p) { p.depth_m = 0.02; },
             [](scene::Probing& p) { p.hole_s = NAN; }, [](scene::Probing& p) { p.wrongShare = 1.5; }}) {
        scene::Scene scene = test::cameraScene(false);
        scene.camera().probing = probing();
        EXPECT_TRUE(checkCameraScene(scene));
        spoil(*scene.camera().probing);
        EXPECT_FALSE(checkCameraScene(scene));
    }
}

} // namespace teleta::simulation
