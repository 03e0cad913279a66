// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/tip_motion.h"
#include "backend/arm_model/trajectory_points.h"
#include "backend/arm_model/urdf_reader.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

using namespace teleta;
using arm_model::SerialChain;
using arm_model::TipRates;

namespace {

SerialChain chain(const std::string& name, const std::string& base, const std::string& tip) {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/" + name);
    EXPECT_TRUE(model) << core::describe(model.error());
    const auto made = SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model), base, tip);
    EXPECT_TRUE(made) << core::describe(made.error());
    return *made;
}

Eigen::VectorXd asVector(const core::JointVector& q) {
    return Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
}

} // namespace

TEST(TipMotion, awayFromSingularitiesTheTipDoesWhatIsAsked) {
    const SerialChain arm = chain("crooked_arm.urdf", "base_link", "hand");
    const arm_model::TipTwist twist{{0.05, -0.02, 0.03}, {0.1, 0.2, -0.3}};
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    int looked = 0;
    while (looked < 100) {
        core::JointVector q = core::JointVector::zeros(arm.joints());
        for (double& value : q)
            value = any(random);
        Eigen::MatrixXd weighted = arm.jacobian(q);
        weighted.bottomRows<3>() *= arm_model::kTurnLength_m;
        if (Eigen::JacobiSVD<Eigen::MatrixXd>(weighted).singularValues().minCoeff() < 0.03)
            continue;
        ++looked;
        const TipRates rates = arm_model::tipRates(arm, q, twist);
        const Eigen::Vector<double, 6> done = arm.jacobian(q) * asVector(rates.rate);
        EXPECT_LT((done.head<3>() - twist.velocity_mPerS).norm(), 1e-11);
        EXPECT_LT((done.tail<3>() - twist.turn_radPerS).norm(), 1e-11);
        EXPECT_NEAR(rates.followed, 1.0, 1e-11);
        EXPECT_FALSE(rates.singular);
    }
}

TEST(TipMotion, anArmOfTwoJointsDoesTheNearestThatItCan) {
    const SerialChain arm = chain("gripper.urdf", "base_link", "tool0");
    // Sideways, the planar arm cannot move at all.
    const TipRates sideways = arm_model::tipRates(arm, {0.4, -1.1}, {{0.0, 0.05, 0.0}});
    EXPECT_LT(asVector(sideways.rate).norm(), 1e-12);
    EXPECT_LT(sideways.followed, 1e-12);
    EXPECT_FALSE(sideways.singular) << "it moves that way in no pose";
}

TEST(TipMotion, ratesStayBoundedThroughASingularity) {
    // Stretched, the arm cannot move along itself. Only the velocity counts here: the turn of the tip is free
    // of charge for a planar arm, so the bound is looked at for random twists.
    const SerialChain arm = chain("crooked_arm.urdf", "base_link", "hand");
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int round = 0; round < 2000; ++round) {
        core::JointVector q = core::JointVector::zeros(arm.joints());
        for (double& value : q)
            value = round % 2 == 0 ? 0.0 : 2.0 * any(random);
        const arm_model::TipTwist twist{{any(random), any(random), any(random)},
                                        {any(random), any(random), any(random)}};
        const TipRates rates = arm_model::tipRates(arm, q, twist);
        const double asked =
            std::hypot(twist.velocity_mPerS.norm(), arm_model::kTurnLength_m * twist.turn_radPerS.norm());
        EXPECT_LE(asVector(rates.rate).norm(), 1.2 * asked / arm_model::kLeastLever_m);
        EXPECT_GE(rates.followed, 0.0);
        EXPECT_LE(rates.followed, 1.0);
    }
}

TEST(TipMotion, aStretchedArmIsSingularAlongItself) {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    const auto arm =
        SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model), "base_link", "tool0");
    ASSERT_TRUE(arm) << core::describe(arm.error());
    const auto along = [&](const core::JointVector& q, const Eigen::Vector3d& direction) {
        return arm_model::tipRates(*arm, q, {0.05 * direction, Eigen::Vector3d::Zero()});
    };
    const core::JointVector zeros = core::JointVector::zeros(7);
    const Eigen::Vector3d itself = arm->X_Base_Tip(zeros).translation().normalized();
    const TipRates stretched = along(zeros, itself);
    EXPECT_TRUE(stretched.singular);
    EXPECT_LT(stretched.followed, 0.1);
    const TipRates bent = along({0.0, 0.6, 0.0, -1.2, 0.0, 0.8, 0.0}, itself);
    EXPECT_FALSE(bent.singular);
    EXPECT_NEAR(bent.followed, 1.0, 1e-9);
}

TEST(TipMotion, whatIsNotFiniteMovesNothing) {
    const SerialChain arm = chain("gripper.urdf", "base_link", "tool0");
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(arm_model::tipRates(arm, {0.4, kNan}, {{0.1, 0.0, 0.0}}).rate, core::JointVector::zeros(2));
    EXPECT_EQ(arm_model::tipRates(arm, {0.4, 0.1}, {{kNan, 0.0, 0.0}}).rate, core::JointVector::zeros(2));
    EXPECT_EQ(arm_model::tipRates(arm, {0.4, 0.1}, {}).rate, core::JointVector::zeros(2));
}

TEST(TrajectoryPoints, endAtRestWhereBrakingEnds) {
    const auto points = arm_model::trajectoryPoints({0.5, -0.2}, {0.3, -0.15}, {3.0, 3.0});
    EXPECT_DOUBLE_EQ(points[0].time_s, 0.04);
    EXPECT_DOUBLE_EQ(points[0].position[0], 0.5 + 0.3 * 0.04);
    EXPECT_DOUBLE_EQ(points[0].velocity[1], -0.15);
    // T1 + Tb = 40 ms + 0.3 / 3 s = 140 ms; 0.3^2 / (2 * 3) = 0.015 rad.
    EXPECT_DOUBLE_EQ(points[1].time_s, 0.14);
    EXPECT_DOUBLE_EQ(points[1].position[0], 0.5 + 0.012 + 0.015);
    EXPECT_DOUBLE_EQ(points[1].position[1], -0.2 - 0.006 - 0.00375);
    EXPECT_EQ(points[1].velocity, core::JointVector::zeros(2));
}

TEST(TrajectoryPoints, timesRiseWhenNothingMoves) {
    const auto points = arm_model::trajectoryPoints({0.5, -0.2}, core::JointVector::zeros(2), {3.0, 3.0});
    EXPECT_GT(points[1].time_s, points[0].time_s);
    EXPECT_EQ(points[1].position, points[0].position);
}
