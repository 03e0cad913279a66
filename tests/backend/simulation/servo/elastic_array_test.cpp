// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/effects/border_stiffening.h"
#include "backend/simulation/servo/elastic_array.h"
#include "tests/backend/simulation/servo/servo_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace teleta::simulation {
namespace {

using test::inFront;
using test::kLayout;

constexpr double kTaxel_NPerM = 1200.0;

ElasticArray softArray(double body_NPerM = 1e15, std::vector<RimSide> rim = {}) {
    return ElasticArray(kLayout, kTaxel_NPerM, body_NPerM, {}, std::move(rim));
}

} // namespace

TEST(ElasticArray, aWallPressesEveryTaxelAsASpring) {
    const double depth_m = 0.4e-3;
    std::vector<double> load_N(kLayout.taxels());
    const ElasticArray array = softArray();
    const ArrayLoads loads = array.readLoads(inFront(-depth_m), WallSurface{}, load_N);
    for (const double taxel_N : load_N)
        EXPECT_NEAR(taxel_N, kTaxel_NPerM * depth_m, 1e-9);
    EXPECT_NEAR(loads.force_N, 84.0 * kTaxel_NPerM * depth_m, 1e-7);
    EXPECT_NEAR(loads.copX_m, 0.0, 1e-12);
    EXPECT_NEAR(loads.copY_m, 0.0, 1e-12);
    const ArrayContact contact = array.press(inFront(-depth_m), WallSurface{});
    EXPECT_NEAR(contact.energy_J, 0.5 * 84.0 * kTaxel_NPerM * depth_m * depth_m, 1e-12);
    EXPECT_NEAR(contact.wrench_Sensor.z(), -loads.force_N, 1e-9);
}

TEST(ElasticArray, aTiltedWallMovesTheCentreOfPressureAsABeamOnSprings) {
    // CoP_x = tilt * <x^2> / depth; columns of two springs have <x^2> = (n^2 - 1) c^2 / 12 with n = 28.
    const double depth_m = 0.4e-3;
    const double tilt_rad = 0.01;
    const double cell_m = 0.5 * kLayout.pitchX_m;
    const double square_m2 = (28.0 * 28.0 - 1.0) * cell_m * cell_m / 12.0;
    std::vector<double> load_N(kLayout.taxels());
    const ArrayLoads loads = softArray().readLoads(inFront(-depth_m, 0.0, tilt_rad), WallSurface{}, load_N);
    EXPECT_NEAR(std::abs(loads.copX_m), std::tan(tilt_rad) * square_m2 / depth_m, 1e-9);
    EXPECT_NEAR(loads.cocX_m, 0.0, 1e-12);
}

// What a pose has shown is kept for the next question about the same pose, and for no other.
TEST(ElasticArray, answersTheSameWhateverWasAskedBefore) {
    const ElasticArray used = softArray();
    const TouchedShape bar = BarSurface(test::straightBar());
    const TouchedShape wall = WallSurface{};
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    std::vector<double> load_N(kLayout.taxels()), freshLoad_N(kLayout.taxels());
    std::vector<PressedPoint> points, freshPoints;
    for (int i = 0; i < 60; ++i) {
        const Eigen::Isometry3d X = inFront(-4e-4 + 1e-4 * within(engine), 0.0, 0.02 * within(engine));
        const TouchedShape& shape = i % 3 == 0 ? wall : bar;
        const ElasticArray fresh = softArray();
        // Before and after the others, twice, and of the other shape at the same pose.
        for (const int question : {i % 4, 0, 1, 1, 3, 2, 0}) {
            if (question == 0) {
                const ArrayContact contact = used.press(X, shape);
                const ArrayContact expected = softArray().press(X, shape);
                EXPECT_EQ(contact.energy_J, expected.energy_J);
                EXPECT_EQ(contact.wrench_Sensor, expected.wrench_Sensor);
                EXPECT_EQ(contact.tangent_Sensor, expected.tangent_Sensor);
            } else if (question == 1) {
                EXPECT_EQ(used.readLoads(X, shape, load_N).force_N,
                          fresh.readLoads(X, shape, freshLoad_N).force_N);
                EXPECT_EQ(load_N, freshLoad_N);
            } else if (question == 2) {
                used.listPressed(X, shape, points);
                fresh.listPressed(X, shape, freshPoints);
                ASSERT_EQ(points.size(), freshPoints.size());
                for (std::size_t k = 0; k < points.size(); ++k)
                    EXPECT_EQ(points[k].force_N, freshPoints[k].force_N);
            } else {
                (void)used.press(X, i % 3 == 0 ? bar : wall);
            }
        }
    }
}

TEST(ElasticArray, aBodyAsSoftAsTheArrayHalvesTheForce) {
    const double hard_N = softArray().press(inFront(-4e-4), WallSurface{}).wrench_Sensor.z();
    const double soft_N = softArray(kTaxel_NPerM).press(inFront(-4e-4), WallSurface{}).wrench_Sensor.z();
    EXPECT_NEAR(soft_N, 0.5 * hard_N, 1e-6 * std::abs(hard_N));
}

TEST(ElasticArray, aBarAlongTheRowsPressesAsTheIntegralOfItsDepth) {
    const double radius_m = 0.003;
    const double depth_m = 0.4e-3;
    // Depth R - hypot(v, R - d) along the normal, whose share along z is (R - d)/hypot; by a fine sum.
    const double half_m = std::sqrt(depth_m * (2.0 * radius_m - depth_m));
    double area_m2 = 0.0;
    constexpr int kParts = 20000;
    for (int i = 0; i < kParts; ++i) {
        const double v_m = half_m * (2.0 * (i + 0.5) / kParts - 1.0);
        const double distance_m = std::hypot(v_m, radius_m - depth_m);
        area_m2 += (radius_m - distance_m) * (radius_m - depth_m) / distance_m * 2.0 * half_m / kParts;
    }
    const double expected_N = kTaxel_NPerM / kLayout.taxelArea_m2() * area_m2 * 14.0 * kLayout.pitchX_m;
    double sum_N = 0.0;
    constexpr int kPlaces = 32;
    for (int i = 0; i < kPlaces; ++i) {
        Eigen::Isometry3d X = inFront(-depth_m);
        X.translation().y() = kLayout.pitchX_m * i / kPlaces;
        const double force_N = -softArray().press(X, BarSurface(test::straightBar())).wrench_Sensor.z();
        // Four springs a taxel sample the bar's width: their force waves by a few percent about the integral.
        EXPECT_NEAR(force_N, expected_N, 0.06 * expected_N) << i;
        sum_N += force_N / kPlaces;
    }
    EXPECT_NEAR(sum_N, expected_N, 0.005 * expected_N);
}

TEST(ElasticArray, theWrenchIsTheSlopeOfTheEnergyForEveryBody) {
    const ElasticArray array = softArray(1e5, housingRim({.stiffness_NPerM = 2e5}, kLayout));
    const std::vector<TouchedShape> shapes{BarSurface(test::bentBar()), BallSurface{0.012}, EdgeSurface{},
                                           WallSurface{}};
    for (const TouchedShape& shape : shapes) {
        Eigen::Isometry3d X = inFront(-0.9e-3, 0.3, 0.02);
        X.translation().x() = 0.0131;
        X.translation().y() = 0.0022;
        const ArrayContact contact = array.press(X, shape);
        ASSERT_GT(contact.springs, 0);
        constexpr double kStep = 1e-8;
        for (int i = 0; i < 6; ++i) {
            servo::Twist twist = servo::Twist::Zero();
            twist[i] = kStep;
            // The array moves by the twist: the body moves the other way.
            const double ahead_J = array.press(servo::expSE3(twist).inverse() * X, shape).energy_J;
            const double behind_J = array.press(servo::expSE3(twist) * X, shape).energy_J;
            EXPECT_NEAR(contact.wrench_Sensor[i], -(ahead_J - behind_J) / (2.0 * kStep),
                        2e-3 * contact.wrench_Sensor.norm())
                << "shape " << shape.index() << " component " << i;
        }
    }
}

TEST(ElasticArray, theHousingCarriesWhatIsDeeperThanItsRecessAndSensesNothing) {
    const scene::HousingRimSpec spec{.stiffness_NPerM = 2e5, .recess_m = 0.0005};
    const ElasticArray array = softArray(1e15, housingRim(spec, kLayout));
    std::vector<double> load_N(kLayout.taxels());
    EXPECT_EQ(array.readLoads(inFront(-0.49e-3), WallSurface{}, load_N).rim_N, 0.0);
    const ArrayLoads loads = array.readLoads(inFront(-0.6e-3), WallSurface{}, load_N);
    // Two sides of 25 mm and two of 47.6 mm, 2e5 N/m a pitch, 0.1 mm deep.
    EXPECT_NEAR(loads.rim_N, 2e5 * (2.0 * 0.025 + 2.0 * 0.0476) / kLayout.pitchX_m * 0.1e-3, 1e-6);
    EXPECT_NEAR(loads.force_N, 84.0 * kTaxel_NPerM * 0.6e-3, 1e-7);
}

TEST(ElasticArray, aStifferBorderCarriesMore) {
    const std::vector<double> factors = borderStiffness({.share = 0.5}, kLayout);
    const ElasticArray array(kLayout, kTaxel_NPerM, 1e15, factors, {});
    std::vector<double> load_N(kLayout.taxels());
    array.readLoads(inFront(-1e-4), WallSurface{}, load_N);
    EXPECT_NEAR(load_N[0] / load_N[20], 2.0, 1e-9); // corner
    EXPECT_NEAR(load_N[5] / load_N[20], 1.5, 1e-9); // side
}

TEST(ElasticArray, readsTheCentreOfABallWhereItIs) {
    std::vector<double> load_N(kLayout.taxels());
    for (const double x_m : {-0.007, 0.0, 0.0013}) {
        for (const double y_m : {-0.003, 0.0, 0.0019}) {
            Eigen::Isometry3d X = inFront(-1e-3);
            X.translation().head<2>() << x_m, y_m;
            const ArrayLoads loads = softArray().readLoads(X, BallSurface{0.012}, load_N);
            EXPECT_NEAR(loads.copX_m, x_m, 0.1e-3);
            EXPECT_NEAR(loads.copY_m, y_m, 0.05e-3);
        }
    }
}

TEST(ElasticArray, isFreeWithoutContact) {
    const ArrayContact contact = softArray().press(inFront(1e-6), WallSurface{});
    EXPECT_EQ(contact.springs, 0);
    EXPECT_EQ(contact.energy_J, 0.0);
    EXPECT_TRUE(contact.wrench_Sensor.isZero());
}

// The sums of the class comment over every spring, one after the other.
TEST(ElasticArray, sumsEverySpringThatIsInTheBody) {
    constexpr core::ArrayLayout kLayout{6, 14, 0.0034};
    constexpr double kStiffness_NPerM = 2000.0;
    constexpr double kBody_NPerM = 30000.0;
    const double series_NPerM = kStiffness_NPerM * kBody_NPerM / (kStiffness_NPerM + kBody_NPerM) / 8.0;
    const ElasticArray array(kLayout, kStiffness_NPerM, kBody_NPerM, {}, {});
    std::mt19937 random(9);
    std::uniform_real_distribution<double> way_m(-0.004, 0.004);
    std::uniform_real_distribution<double> turn_rad(-0.2, 0.2);
    int pressedAll = 0;
    for (const TouchedShape& shape :
         {TouchedShape(BarSurface(test::straightBar())), TouchedShape(BarSurface(test::bentBar())),
          TouchedShape(EdgeSurface{}), TouchedShape(BallSurface{0.012}), TouchedShape(WallSurface{})})
        for (int trial = 0; trial < 40; ++trial) {
            Eigen::Isometry3d X_Sensor_Object =
                Eigen::Translation3d(way_m(random), way_m(random), 0.25 * way_m(random) + 0.0005) *
                Eigen::AngleAxisd(std::numbers::pi + turn_rad(random), Eigen::Vector3d::UnitX()) *
                Eigen::AngleAxisd(turn_rad(random), Eigen::Vector3d::UnitZ());
            const Eigen::Isometry3d X_Object_Sensor = X_Sensor_Object.inverse();
            double energy_J = 0.0;
            servo::Wrench wrench = servo::Wrench::Zero();
            servo::Matrix6 tangent = servo::Matrix6::Zero();
            int springs = 0;
            for (int i = 0; i < 28; ++i)
                for (int j = 0; j < 24; ++j) {
                    const Eigen::Vector3d p_Sensor((i - 13.5) * 0.0017, (j - 11.5) * 0.00085, 0.0);
                    const Depth depth = std::visit(
                        [&](const auto& body) { return depthIn(body, X_Object_Sensor * p_Sensor); }, shape);
                    if (!(depth.depth_m > 0.0))
                        continue;
                    const Eigen::Vector3d normal = X_Sensor_Object.linear() * depth.normal;
                    servo::Wrench screw;
                    screw << normal, p_Sensor.cross(normal);
                    energy_J += 0.5 * series_NPerM * depth.depth_m * depth.depth_m;
                    wrench += series_NPerM * depth.depth_m * screw;
                    tangent += series_NPerM * screw * screw.transpose();
                    ++springs;
                }
            const ArrayContact contact = array.press(X_Sensor_Object, shape);
            ASSERT_EQ(contact.springs, springs);
            ASSERT_NEAR(contact.energy_J, energy_J, 1e-12 * energy_J);
            ASSERT_LE((contact.wrench_Sensor - wrench).norm(), 1e-12 * wrench.norm());
            ASSERT_LE((contact.tangent_Sensor - tangent).norm(), 1e-12 * tangent.norm());
            ASSERT_EQ(contact.tangent_Sensor, contact.tangent_Sensor.transpose());
            pressedAll += springs;
        }
    EXPECT_GT(pressedAll, 5000);
}

TEST(TouchedShape, theMiddleOfABallHasANormal) {
    const Depth depth = depthIn(BallSurface{0.01}, {0.0, 0.0, -0.01});
    EXPECT_EQ(depth.depth_m, 0.01);
    EXPECT_EQ(depth.normal, Eigen::Vector3d::UnitZ());
}

TEST(TouchedShape, theBarsSurfaceIsARadiusFromItsAxisAndItsLineOnIt) {
    const BarSurface bar(test::bentBar());
    for (double u_m = -0.05; u_m < 0.3; u_m += 0.01) {
        const Eigen::Vector3d line = bar.lineAt(u_m);
        EXPECT_NEAR(depthIn(bar, line).depth_m, 0.0, 2e-6) << u_m;
        EXPECT_NEAR(bar.lineDistance_m(line), 0.0, 1e-9) << u_m;
        EXPECT_NEAR(depthIn(bar, line).normal.dot(bar.tangentAt(u_m)), 0.0, 1e-3) << u_m;
    }
    // Quadratic fall: slope tan(22 deg) after the bend of 150 mm.
    EXPECT_NEAR(bar.tangentAt(0.2).z() / bar.tangentAt(0.2).x(), -std::tan(0.384), 1e-12);
}

} // namespace teleta::simulation
