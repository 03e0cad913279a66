// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/quaternion_order.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using teleta::servo::quaternionXyzw;

TEST(QuaternionOrder, isXyzwWithWNotNegative) {
    // A quarter turn about z, as SciPy's Rotation.from_euler("z", 90, degrees=True).as_quat() and ROS have
    // it.
    Eigen::Matrix3d quarter;
    quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    const std::array<double, 4> q = quaternionXyzw(quarter);
    EXPECT_EQ(q[0], 0.0);
    EXPECT_EQ(q[1], 0.0);
    EXPECT_NEAR(q[2], std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(q[3], std::sqrt(0.5), 1e-15);
    EXPECT_EQ(quaternionXyzw(Eigen::Matrix3d::Identity()), (std::array{0.0, 0.0, 0.0, 1.0}));
    // A turn by 270 degrees is one by -90.
    const Eigen::Matrix3d back =
        Eigen::AngleAxisd(1.5 * std::numbers::pi, Eigen::Vector3d::UnitY()).toRotationMatrix();
    EXPECT_NEAR(quaternionXyzw(back)[1], -std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(quaternionXyzw(back)[3], std::sqrt(0.5), 1e-15);
}

TEST(QuaternionOrder, aHalfTurnHasOneSignOnly) {
    Eigen::Matrix3d half;
    half << -1, 0, 0, 0, 1, 0, 0, 0, -1;
    EXPECT_EQ(quaternionXyzw(half), (std::array{0.0, 1.0, 0.0, 0.0}));
    half << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    EXPECT_EQ(quaternionXyzw(half), (std::array{1.0, 0.0, 0.0, 0.0}));
}

TEST(QuaternionOrder, isTheSameRotation) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 200; ++round) {
        const Eigen::Matrix3d R =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized()
                .toRotationMatrix();
        const auto [x, y, z, w] = quaternionXyzw(R);
        EXPECT_GE(w, 0.0);
        EXPECT_NEAR(x * x + y * y + z * z + w * w, 1.0, 1e-15 * 4);
        EXPECT_LE((Eigen::Quaterniond(w, x, y, z).toRotationMatrix() - R).norm(), 1e-14);
    }
}
