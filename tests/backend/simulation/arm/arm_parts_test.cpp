// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/hanging_posture.h"
#include "backend/simulation/arm/outline_geometry.h"
#include "backend/simulation/arm/skin_sheet.h"
#include "backend/simulation/arm/smooth_move.h"
#include "backend/simulation/base/arm_inertia.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace teleta::simulation {

namespace {

using arm::JointVector;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

OutlineGeometry outlineOf(const scene::Outline& outline, double angle_rad = 0.0) {
    return OutlineGeometry({.name = "o",
                            .outline = outline,
                            .x_m = 0.2,
                            .y_m = -0.1,
                            .z_m = 0.05,
                            .angle_rad = angle_rad,
                            .stiffness_NPerM = 1.0});
}

const std::array<JointVector, 4> kPostures{JointVector(0.0, 0.0, 0.0, 0.0), JointVector(0.4, -0.7, 0.9, 1.2),
                                           JointVector(-1.3, 1.1, -0.2, 2.4),
                                           JointVector(1.5708, 0.0, 0.0, 2.2)};

} // namespace

TEST(OutlineGeometry, tellsTheDistanceOfEveryShape) {
    const Vector2d centre(0.2, -0.1);
    const OutlineGeometry round = outlineOf(scene::RoundOutline{0.04});
    EXPECT_NEAR(round.distance(centre + Vector2d(0.03, 0.04)).distance_m, 0.01, 1e-15);
    EXPECT_NEAR(round.distance(centre).distance_m, -0.04, 1e-15);
    EXPECT_NEAR(round.distance(centre).normal.norm(), 1.0, 1e-15);

    const OutlineGeometry box = outlineOf(scene::RectangleOutline{0.08, 0.04});
    EXPECT_NEAR(box.distance(centre + Vector2d(0.05, 0.0)).distance_m, 0.01, 1e-15);
    EXPECT_NEAR(box.distance(centre + Vector2d(0.0, -0.05)).distance_m, 0.03, 1e-15);
    EXPECT_NEAR(box.distance(centre + Vector2d(0.043, 0.024)).distance_m, 0.005,
                1e-15); // 3, 4, 5 at a corner
    EXPECT_NEAR(box.distance(centre + Vector2d(0.01, 0.015)).distance_m, -0.005, 1e-15);
    EXPECT_TRUE(box.distance(centre + Vector2d(0.01, 0.015)).normal.isApprox(Vector2d(0.0, 1.0)));
    const OutlineGeometry turned = outlineOf(scene::RectangleOutline{0.08, 0.04}, 0.5 * kPi);
    EXPECT_NEAR(turned.distance(centre + Vector2d(0.0, 0.05)).distance_m, 0.01, 1e-15);

    // The circle in an equilateral triangle of side a has the radius a / (2 sqrt 3).
    const OutlineGeometry triangle = outlineOf(scene::TriangleOutline{0.06});
    EXPECT_NEAR(triangle.distance(centre).distance_m, -0.06 / (2.0 * std::sqrt(3.0)), 1e-15);
    EXPECT_NEAR(triangle.distance(centre + Vector2d(0.06 / std::sqrt(3.0) + 0.01, 0.0)).distance_m, 0.01,
                1e-15);

    const OutlineGeometry wall = outlineOf(scene::WallOutline{}, 0.5 * kPi);
    EXPECT_NEAR(wall.distance(centre + Vector2d(3.0, 0.02)).distance_m, 0.02, 1e-15);
    EXPECT_NEAR(wall.distance(centre + Vector2d(-7.0, -0.02)).distance_m, -0.02, 1e-15);
}

TEST(AxisDistance, findsTheNearestPointOfAnAxis) {
    const OutlineGeometry round = outlineOf(scene::RoundOutline{0.04});
    // Level with the outline, 0.1 m beside its centre: a line and a circle.
    const AxisDistance level = axisDistance(round, {0.0, 0.0, 0.05}, Vector3d::UnitX(), 0.5);
    EXPECT_NEAR(level.distance_m, 0.06, 1e-14);
    EXPECT_NEAR(level.along_m, 0.2, 1e-9);
    EXPECT_TRUE(level.normal.isApprox(Vector3d(0.0, 1.0, 0.0), 1e-9));
    // Above it: the nearest point of the rim is aside and below.
    const AxisDistance above = axisDistance(round, {0.0, 0.0, 0.13}, Vector3d::UnitX(), 0.5);
    EXPECT_NEAR(above.distance_m, 0.1, 1e-14); // 0.06 aside, 0.08 up
    // Too short to come near: its end counts.
    const AxisDistance end = axisDistance(round, {0.0, -0.1, 0.05}, Vector3d::UnitX(), 0.1);
    EXPECT_NEAR(end.distance_m, 0.06, 1e-15);
    EXPECT_EQ(end.along_m, 0.1);
    // Upright beside it, and through it.
    EXPECT_NEAR(axisDistance(round, {0.25, -0.1, 0.2}, -Vector3d::UnitZ(), 0.3).distance_m, 0.01, 1e-15);
    const AxisDistance through = axisDistance(round, {0.23, -0.1, 0.2}, -Vector3d::UnitZ(), 0.3);
    EXPECT_NEAR(through.distance_m, -0.01, 1e-15);
    EXPECT_NEAR(through.along_m, 0.15, 1e-15);
    EXPECT_TRUE(through.normal.isApprox(Vector3d(1.0, 0.0, 0.0)));
}

TEST(AxisDistance, isTheLeastOfAllPointsOfTheAxis) {
    for (const scene::Outline& shape :
         {scene::Outline(scene::RoundOutline{0.04}), scene::Outline(scene::RectangleOutline{0.08, 0.03}),
          scene::Outline(scene::TriangleOutline{0.07})}) {
        const OutlineGeometry outline = outlineOf(shape, 0.3);
        for (int i = 0; i < 40; ++i) {
            const Vector3d start_m(0.3 * std::sin(1.7 * i), 0.3 * std::cos(2.3 * i), 0.2 * std::sin(0.9 * i));
            const Vector3d direction =
                Vector3d(std::cos(1.1 * i), std::sin(1.9 * i), std::sin(0.7 * i + 0.3)).normalized();
            const AxisDistance found = axisDistance(outline, start_m, direction, 0.27);
            double least_m = 1e9;
            for (int k = 0; k <= 2700; ++k) {
                const Vector3d point_m = start_m + 1e-4 * k * direction;
                least_m = std::min(least_m,
                                   std::hypot(std::max(outline.distance(point_m.head<2>()).distance_m, 0.0),
                                              point_m.z() - outline.height_m()));
            }
            EXPECT_LE(found.distance_m, least_m + 1e-12);
            if (found.distance_m > 0.0) {
                EXPECT_NEAR(found.distance_m, least_m, 1e-4);
            }
            EXPECT_NEAR(found.normal.norm(), 1.0, 1e-12);
        }
    }
}

TEST(AxisDistance, nothingThatIsBeyondADistanceIsNearer) {
    for (const scene::Outline& shape :
         {scene::Outline(scene::RoundOutline{0.04}), scene::Outline(scene::RectangleOutline{0.08, 0.03}),
          scene::Outline(scene::TriangleOutline{0.07}), scene::Outline(scene::WallOutline{})}) {
        const OutlineGeometry outline = outlineOf(shape, 0.3);
        int beyond = 0;
        for (int i = 0; i < 400; ++i) {
            const Vector3d start_m(0.3 * std::sin(1.7 * i), 0.3 * std::cos(2.3 * i), 0.2 * std::sin(0.9 * i));
            const Vector3d direction =
                Vector3d(std::cos(1.1 * i), std::sin(1.9 * i), std::sin(0.7 * i + 0.3)).normalized();
            if (!isBeyond(outline, start_m, direction, 0.27, 0.03))
                continue;
            ++beyond;
            EXPECT_GT(axisDistance(outline, start_m, direction, 0.27).distance_m, 0.03);
        }
        // A wall has no end; most of the others are far away.
        EXPECT_EQ(beyond > 100, std::isfinite(outline.reach_m())) << beyond;
    }
    const OutlineGeometry round = outlineOf(scene::RoundOutline{0.04});
    const Vector3d beside_m = round.centre_m().homogeneous() + Vector3d(0.071, 0.0, round.height_m() - 1.0);
    EXPECT_TRUE(isBeyond(round, beside_m, Vector3d::UnitZ(), 0.27, 0.03));
    EXPECT_FALSE(isBeyond(round, beside_m, Vector3d::UnitZ(), 0.27, 0.0311));
}

TEST(HangingPosture, hangsTheForearmStraightDown) {
    const arm::ArmDimensions dimensions;
    const arm::Arm4Kinematics kinematics(dimensions);
    for (const Vector2d& elbow_m :
         {Vector2d(0.2, 0.0), Vector2d(0.1, 0.15), Vector2d(0.12, -0.2), Vector2d(0.29, 0.01)}) {
        const JointVector q_rad = hangingPosture(dimensions, elbow_m);
        const Vector3d p_Base_Elbow = kinematics.p_Base_Point(arm::Link::forearm, q_rad, Vector3d::Zero());
        EXPECT_NEAR((p_Base_Elbow.head<2>() - elbow_m).norm(), 0.0, 1e-14);
        EXPECT_NEAR(p_Base_Elbow.z(), -std::sqrt(0.09 - elbow_m.squaredNorm()), 1e-14);
        const Vector3d p_Base_Tip = kinematics.p_Base_Point(arm::Link::forearm, q_rad, {0.27, 0.0, 0.0});
        EXPECT_NEAR((p_Base_Tip - p_Base_Elbow - Vector3d(0.0, 0.0, -0.27)).norm(), 0.0, 1e-14);
    }
    // Out of reach: as far as it goes.
    const JointVector far_rad = hangingPosture(dimensions, {3.0, 0.0});
    EXPECT_NEAR(kinematics.p_Base_Point(arm::Link::forearm, far_rad, Vector3d::Zero()).x(), 0.98 * 0.3,
                1e-14);
    EXPECT_TRUE(hangingPosture(dimensions, {0.0, 0.0}).allFinite());
}

TEST(ArmInertia, isThatOfUniformBars) {
    const scene::ArmBody body;
    const ArmInertia inertia(body);
    const double h2_m2 = body.halfThickness_m * body.halfThickness_m;
    const double across_kgm2 =
        body.forearmMass_kg * (3.0 * h2_m2 + body.forearmLength_m * body.forearmLength_m) / 12.0;
    for (const JointVector& q_rad : kPostures) {
        const MassMatrix mass = inertia.massMatrix(q_rad);
        EXPECT_TRUE(mass.isApprox(mass.transpose()));
        EXPECT_EQ(mass.llt().info(), Eigen::Success);
        // Elbow: parallel axes.
        EXPECT_NEAR(mass(3, 3),
                    body.jointInertia_kgm2 + across_kgm2 +
                        0.25 * body.forearmMass_kg * body.forearmLength_m * body.forearmLength_m,
                    1e-15);
    }
    // Stretched, the roll turns both bars about their axes.
    EXPECT_NEAR(inertia.massMatrix(kPostures[0])(0, 0),
                body.jointInertia_kgm2 + 0.5 * (body.upperArmMass_kg + body.forearmMass_kg) * h2_m2, 1e-15);
}

TEST(ArmInertia, derivesItsTorquesFromItsEnergies) {
    const scene::ArmBody body;
    const ArmInertia inertia(body);
    const arm::Arm4Kinematics kinematics(dimensionsOf(body));
    const auto height_J = [&](const JointVector& q_rad) {
        const Vector3d upperArm_m =
            kinematics.p_Base_Point(arm::Link::upperArm, q_rad, {0.5 * body.upperArmLength_m, 0.0, 0.0});
        const Vector3d forearm_m =
            kinematics.p_Base_Point(arm::Link::forearm, q_rad, {0.5 * body.forearmLength_m, 0.0, 0.0});
        return 9.80665 * (body.upperArmMass_kg * upperArm_m.z() + body.forearmMass_kg * forearm_m.z());
    };
    const JointVector rate(0.7, -1.1, 0.5, 1.9);
    constexpr double kStep = 1e-5;
    for (const JointVector& q_rad : kPostures) {
        // Lagrange: c = dM/dt v - d(v^T M v / 2)/dq, by differences.
        JointVector expected =
            (inertia.massMatrix(q_rad + kStep * rate) - inertia.massMatrix(q_rad - kStep * rate)) * rate /
            (2.0 * kStep);
        JointVector weight;
        for (int j = 0; j < 4; ++j) {
            const JointVector step = kStep * JointVector::Unit(j);
            const MassMatrix change = inertia.massMatrix(q_rad + step) - inertia.massMatrix(q_rad - step);
            expected[j] -= 0.5 * rate.dot(change * rate) / (2.0 * kStep);
            weight[j] = (height_J(q_rad + step) - height_J(q_rad - step)) / (2.0 * kStep);
        }
        EXPECT_NEAR((inertia.velocityTorque(q_rad, rate) - expected).norm(), 0.0, 1e-8);
        EXPECT_NEAR((inertia.weightTorque(q_rad) - weight).norm(), 0.0, 1e-8);
    }
}

TEST(SkinSheet, sumsToTheLoadAroundItsCentre) {
    const core::ArrayLayout layout{20, 24, 0.0094};
    const core::SkinPlacement placement{0.14, 1.0, 0.03};
    const SkinSheet sheet(layout, placement);
    for (int i = 0; i < 50; ++i) {
        const double distance_m = 0.14 + 0.08 * std::sin(1.3 * i);
        const double side_rad = 1.0 + 2.2 * std::sin(2.1 * i) + 2.0 * kPi * (i % 3);
        std::vector<double> load_N(layout.taxels(), 0.0);
        sheet.press(distance_m, side_rad, 0.5, load_N);
        double sum_N = 0.0, x_m = 0.0, y_m = 0.0;
        for (int r = 0; r < layout.rows; ++r) {
            for (int c = 0; c < layout.columns; ++c) {
                const double value_N = load_N[static_cast<std::size_t>(r * layout.columns + c)];
                EXPECT_GE(value_N, 0.0);
                sum_N += value_N;
                x_m += value_N * layout.x_m(c);
                y_m += value_N * layout.y_m(r);
            }
        }
        EXPECT_NEAR(sum_N, 0.5, 1e-14);
        EXPECT_NEAR(placement.distance_m(x_m / sum_N), distance_m, 1e-14);
        EXPECT_NEAR(std::remainder(placement.side_rad(y_m / sum_N) - side_rad, 2.0 * kPi), 0.0, 1e-12);
    }
    std::vector<double> load_N(layout.taxels(), 0.0);
    sheet.press(1.0, 0.0, 0.5, load_N);
    sheet.press(std::nan(""), 0.0, 0.5, load_N);
    EXPECT_EQ(std::accumulate(load_N.begin(), load_N.end(), 0.0), 0.0);
}

TEST(SkinSheet, isWholeInOneLayerWhereItOverlaps) {
    // Four rows longer than the circumference of 20 rows; the middle of the overlap is opposite its centre.
    const double radius_m = 20.0 * 0.0094 / (2.0 * kPi);
    const core::ArrayLayout layout{24, 24, 0.0094};
    const SkinSheet sheet(layout, {0.14, 0.0, radius_m});
    for (double side_rad = -kPi; side_rad < kPi; side_rad += 0.01) {
        std::vector<double> load_N(layout.taxels(), 0.0);
        sheet.press(0.14, side_rad, 1.0, load_N);
        // Layers do not meet in one row: sum the rows of either half.
        const auto half = load_N.begin() + 12 * layout.columns;
        const double low_N = std::accumulate(load_N.begin(), half, 0.0);
        const double high_N = std::accumulate(half, load_N.end(), 0.0);
        if (std::abs(side_rad) > 0.6 * kPi) {
            EXPECT_NEAR(std::max(low_N, high_N), 1.0, 1e-12) << side_rad;
        } else {
            EXPECT_NEAR(low_N + high_N, 1.0, 1e-12) << side_rad;
        }
    }
}

TEST(SmoothMove, restsAtBothEndsAndIsAsFastAsItWasTold) {
    EXPECT_EQ(SmoothMove::shareAt(-1.0, 2.0), 0.0);
    EXPECT_EQ(SmoothMove::shareAt(2.0, 2.0), 1.0);
    EXPECT_EQ(SmoothMove::shareAt(0.0, 0.0), 1.0);
    EXPECT_NEAR(SmoothMove::shareAt(1.0, 2.0), 0.5, 1e-15);
    SmoothMove move = SmoothMove::at(0.3, 0.1);
    double fastest = 0.0, before = 0.0;
    bool arrived = false;
    while (!arrived) {
        arrived = move.advance(0.001);
        fastest = std::max(fastest, 0.3 * (move.share() - before) / 0.001);
        before = move.share();
    }
    EXPECT_NEAR(fastest, 0.1, 1e-5);
    EXPECT_EQ(move.share(), 1.0);
}

} // namespace teleta::simulation
