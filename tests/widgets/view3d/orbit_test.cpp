// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/orbit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace teleta::view3d;

namespace {

constexpr double kTolerance = 1e-12;

void expectNear(const Eigen::Vector3d& actual, const Eigen::Vector3d& expected) {
    EXPECT_LT((actual - expected).norm(), kTolerance)
        << actual.transpose() << " instead of " << expected.transpose();
}

Eigen::Vector3d right(const Orbit& orbit) {
    return orbit.up().cross(orbit.direction());
}

} // namespace

TEST(Orbit, presetsLookAlongTheAxesWithTheExpectedSideUp) {
    const Orbit front = orbitOf(CameraPreset::front);
    expectNear(front.direction(), {0, -1, 0});
    expectNear(front.up(), {0, 0, 1});
    expectNear(right(front), {1, 0, 0});
    const Orbit top = orbitOf(CameraPreset::top);
    expectNear(top.direction(), {0, 0, 1});
    expectNear(top.up(), {0, 1, 0});
    expectNear(right(top), {1, 0, 0});
    const Orbit side = orbitOf(CameraPreset::side);
    expectNear(side.direction(), {1, 0, 0});
    expectNear(side.up(), {0, 0, 1});
    expectNear(right(side), {0, 1, 0});
    expectNear(orbitOf(CameraPreset::isometric).direction(), Eigen::Vector3d(1, -1, 1).normalized());
}

TEST(Orbit, directionAndUpAreOrthonormalEverywhere) {
    for (double azimuth = -7.0; azimuth < 7.0; azimuth += 0.37) {
        for (double elevation = -1.57; elevation < 1.58; elevation += 0.157) {
            const Orbit orbit = Orbit{}.turned(azimuth, elevation);
            EXPECT_NEAR(orbit.direction().norm(), 1.0, kTolerance);
            EXPECT_NEAR(orbit.up().norm(), 1.0, kTolerance);
            EXPECT_NEAR(orbit.direction().dot(orbit.up()), 0.0, kTolerance);
            EXPECT_GE(orbit.up().z(), -kTolerance) << "z must not point down on the screen";
        }
    }
}

TEST(Orbit, turningStopsAtThePolesAndGoesAroundThem) {
    const Orbit pole = orbitOf(CameraPreset::side).turned(0.0, 100.0);
    expectNear(pole.direction(), {0, 0, 1});
    expectNear(pole.turned(0.5 * std::numbers::pi, 0.0).direction(), {0, 0, 1});
    expectNear(pole.turned(0.5 * std::numbers::pi, -0.5 * std::numbers::pi).direction(), {0, 1, 0});
}

TEST(Orbit, theFitOfACubeFromTheFrontIsTheOneOfItsNearFace) {
    // Corners at +-1: the near face is 1 in front of the focal point, half its height over the tangent away.
    std::vector<Eigen::Vector3d> corners;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) {
                corners.emplace_back(x, y, z);
            }
        }
    }
    const double angle = std::numbers::pi / 6.0;
    const Orbit front = orbitOf(CameraPreset::front);
    const CameraFit square = fitCamera(front, Eigen::Vector3d::Zero(), corners, angle, 1.0, 1.0, 1e-9);
    EXPECT_NEAR(square.distance_m, 1.0 + 1.0 / std::tan(0.5 * angle), 1e-12);
    EXPECT_NEAR(square.parallelHalfHeight_m, 1.0, 1e-12);
    const CameraFit narrow = fitCamera(front, Eigen::Vector3d::Zero(), corners, angle, 0.5, 0.8, 1e-9);
    EXPECT_NEAR(narrow.distance_m, 1.0 + 1.0 / (0.8 * 0.5 * std::tan(0.5 * angle)), 1e-12);
    EXPECT_NEAR(narrow.parallelHalfHeight_m, 1.0 / (0.8 * 0.5), 1e-12);
}

TEST(Orbit, theFitOfNothingOrOfOnePointIsFiniteAndPositive) {
    const std::array<Eigen::Vector3d, 1> one = {Eigen::Vector3d::Zero()};
    for (const auto corners : {std::span<const Eigen::Vector3d>(), std::span<const Eigen::Vector3d>(one)}) {
        const CameraFit fit = fitCamera(Orbit{}, Eigen::Vector3d::Zero(), corners, 0.5, 1.5, 0.9, 0.01);
        EXPECT_TRUE(std::isfinite(fit.distance_m));
        EXPECT_GT(fit.distance_m, 0.01);
        EXPECT_GE(fit.parallelHalfHeight_m, 0.01);
    }
}
