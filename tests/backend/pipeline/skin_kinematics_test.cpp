// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_kinematics.h"
#include "tests/backend/pipeline/pad_on_arm.h"
#include "tests/backend/pipeline/scripted_arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace teleta::pipeline {
namespace {

using core::JointVector;
using core::PadPlacement;
using Eigen::Vector3d;
using test::chainOf;

/// Below the forearm, its x along the forearm, z down.
PadPlacement belowForearm() {
    return {
        .link = "forearm", .position_m = {0.15, 0.0, -0.03}, .rollPitchYaw_rad = {std::numbers::pi, 0, 0}};
}

std::string errorOf(const PadPlacement& pad, const char* tip = "tool0") {
    const auto made = padOnLink(chainOf("resources/arms/seven-joints.urdf", tip), pad);
    return made ? std::string() : core::describe(made.error());
}

TEST(SkinKinematics, aPadBelowTheForearmIsWhereTheSkinIs) {
    const auto chain = chainOf("resources/arms/four-joints.urdf");
    const auto pad = padOnLink(chain, belowForearm());
    ASSERT_TRUE(pad) << core::describe(pad.error());
    const core::ArmDescription arm = test::paperArm();
    const auto skin = skinAroundForearm(arm);
    ASSERT_TRUE(skin);
    EXPECT_EQ((*pad)->pressingJoint(), skin->pressingJoint());
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> angle(-1.2, 1.2);
    for (int i = 0; i < 100; ++i) {
        const JointVector q{angle(random), angle(random), angle(random), angle(random)};
        const double x_m = 0.05 * angle(random);
        const SkinPoint flat = (*pad)->at(q, x_m, 0.0);
        const SkinPoint bent = skin->at(q, x_m, 0.0);
        EXPECT_LT((flat.p_Base_m - bent.p_Base_m).norm(), 1e-14);
        EXPECT_LT((flat.normal_Base - bent.normal_Base).norm(), 1e-14);
        EXPECT_LT((flat.jacobian - bent.jacobian).norm(), 1e-14);
        EXPECT_NEAR(flat.lever_m(), bent.lever_m(), 1e-14);
        EXPECT_NEAR(flat.contactDistance_m, std::hypot(bent.contactDistance_m, arm.halfThickness_m), 1e-14)
            << "from the axis, not along the forearm";
    }
}

TEST(SkinKinematics, theJacobianIsHowTheLinkMovesThePoint) {
    const auto chain = chainOf("resources/arms/seven-joints.urdf");
    const PadPlacement pad{.link = "link_5",
                           .position_m = {0.04, -0.01, 0.1},
                           .rollPitchYaw_rad = {0.3, std::numbers::pi / 2, -0.2}};
    const auto made = padOnLink(chain, pad);
    ASSERT_TRUE(made) << core::describe(made.error());
    const std::size_t link = *chain->model().findLink("link_5");
    const Eigen::Isometry3d X_Link_Pad = X_Link_Sensor(pad);
    const auto point_m = [&](const JointVector& q, double x_m, double y_m) -> Vector3d {
        return chain->linkPoses(q)[link] * (X_Link_Pad * Vector3d(x_m, y_m, 0.0));
    };
    const JointVector q{0.3, -0.7, 0.2, 1.1, -0.4, 0.8, 0.5};
    const SkinPoint at = (*made)->at(q, 0.01, -0.02);
    EXPECT_LT((at.p_Base_m - point_m(q, 0.01, -0.02)).norm(), 1e-14);
    const Vector3d x = (point_m(q, 1.0, 0.0) - point_m(q, 0.0, 0.0));
    const Vector3d y = (point_m(q, 0.0, 1.0) - point_m(q, 0.0, 0.0));
    EXPECT_LT((at.normal_Base - x.cross(y)).norm(), 1e-13);
    ASSERT_EQ(at.jacobian.cols(), 7);
    constexpr double kStep_rad = 1e-6;
    for (std::size_t joint = 0; joint < 7; ++joint) {
        JointVector more = q;
        JointVector less = q;
        more[joint] += kStep_rad;
        less[joint] -= kStep_rad;
        const Vector3d slope_m =
            (point_m(more, 0.01, -0.02) - point_m(less, 0.01, -0.02)) / (2.0 * kStep_rad);
        EXPECT_LT((at.jacobian.col(static_cast<Eigen::Index>(joint)) - slope_m).norm(), 1e-9) << joint;
    }
    // The joints behind link 5.
    EXPECT_EQ(at.jacobian.rightCols<2>(), (Eigen::Matrix<double, 3, 2>::Zero()));
}

TEST(SkinKinematics, theLastJointWithALeverPresses) {
    const auto pressing = [](PadPlacement pad) {
        const auto made = padOnLink(chainOf("resources/arms/seven-joints.urdf"), pad);
        EXPECT_TRUE(made) << core::describe(made.error());
        return made ? (*made)->pressingJoint() : 99;
    };
    // Joint 5 turns a pad that faces away from its axis along the pad: joint 4 presses.
    PadPlacement pad{
        .link = "link_5", .position_m = {0.05, 0, 0.1}, .rollPitchYaw_rad = {0, std::numbers::pi / 2, 0}};
    EXPECT_EQ(pressing(pad), 3U);
    pad.joint = "joint_2";
    EXPECT_EQ(pressing(pad), 1U);
    // Beside the axis of joint 5.
    pad.joint.clear();
    pad.position_m = {0.0, 0.05, 0.1};
    EXPECT_EQ(pressing(pad), 4U);
    // At the tip, facing forward: the last three joints meet in the pad's normal, or turn it along itself.
    EXPECT_EQ(pressing({.link = "tool0", .position_m = {0.0, 0.0, 0.02}}), 3U);
}

TEST(SkinKinematics, itsJointsAreSpringsInSeries) {
    const auto chain = chainOf("resources/arms/seven-joints.urdf");
    PadPlacement pad{
        .link = "link_5", .position_m = {0.05, 0, 0.1}, .rollPitchYaw_rad = {0, std::numbers::pi / 2, 0}};
    const JointVector q{0.3, -0.7, 0.2, 1.1, -0.4, 0.8, 0.5};
    const auto rigid = padOnLink(chain, pad);
    ASSERT_TRUE(rigid);
    EXPECT_EQ((*rigid)->linkStiffness_NPerM((*rigid)->at(q, 0.0, 0.0)), SkinKinematics::kRigid_NPerM);
    EXPECT_EQ((*rigid)->linkStiffnessSe_NPerM((*rigid)->at(q, 0.0, 0.0)), 0.0);
    pad.jointStiffness_NmPerRad = {3000, 3000, 0, 2000, 1000, 500, 500};
    const auto made = padOnLink(chain, pad);
    ASSERT_TRUE(made) << core::describe(made.error());
    const SkinPoint at = (*made)->at(q, 0.0, 0.0);
    const arm::AnyJointVector d = at.depthPerAngle_m();
    const double compliance =
        d[0] * d[0] / 3000 + d[1] * d[1] / 3000 + d[3] * d[3] / 2000 + d[4] * d[4] / 1000;
    EXPECT_NEAR((*made)->linkStiffness_NPerM(at), 1.0 / compliance, 1e-9 / compliance);
}

TEST(SkinKinematics, saysWhyAPadCannotBeThere) {
    const std::array<double, 3> outward{0, std::numbers::pi / 2, 0};
    EXPECT_NE(errorOf({.link = "hand"}).find("link_5"), std::string::npos) << "names the links";
    PadPlacement pad{.link = "link_5", .position_m = {0.05, 0, 0.1}, .rollPitchYaw_rad = outward};
    EXPECT_EQ(errorOf(pad), "");
    pad.joint = "joint_6";
    EXPECT_NE(errorOf(pad).find("joint_1, joint_2, joint_3, joint_4, joint_5"), std::string::npos)
        << errorOf(pad);
    pad.joint.clear();
    EXPECT_NE(errorOf(pad, "link_3").find("joint_4"), std::string::npos) << errorOf(pad, "link_3");
    pad.jointStiffness_NmPerRad = {1, 2};
    EXPECT_NE(errorOf(pad).find("7"), std::string::npos) << errorOf(pad);
    // Along the axis of the only joint before it.
    const PadPlacement top{.link = "link_1", .position_m = {0.0, 0.0, 0.1}};
    EXPECT_NE(errorOf(top).find("no joint presses"), std::string::npos) << errorOf(top);
    EXPECT_NE(errorOf({.link = "base_link"}), "");
    const auto slides =
        padOnLink(chainOf("tests/data/urdf/crooked_arm.urdf", "hand"), {.link = "l5", .joint = "j5"});
    ASSERT_FALSE(slides);
    EXPECT_NE(core::describe(slides.error()).find("slides"), std::string::npos)
        << core::describe(slides.error());
}

} // namespace
} // namespace teleta::pipeline
