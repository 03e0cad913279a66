// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm/arm4_kinematics.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace teleta;
using arm_model::ArmModel;
using arm_model::SerialChain;

namespace {

constexpr double kRounding = 1e-14;

std::shared_ptr<const ArmModel> load(const std::string& name) {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/" + name);
    EXPECT_TRUE(model) << core::describe(model.error());
    return std::make_shared<const ArmModel>(*model);
}

SerialChain chain(const std::string& name, const std::string& base, const std::string& tip) {
    const auto made = SerialChain::create(load(name), base, tip);
    EXPECT_TRUE(made) << core::describe(made.error());
    return *made;
}

} // namespace

TEST(SerialChain, twoLinksReachWhereTrigonometrySays) {
    const SerialChain arm = chain("gripper.urdf", "base_link", "tool0");
    ASSERT_EQ(arm.joints(), 2U);
    for (const auto& [shoulder, elbow] : {std::pair{0.0, 0.0}, std::pair{0.4, -1.1}, std::pair{-2.0, 1.5}}) {
        const Eigen::Vector3d tip = arm.X_Base_Tip({shoulder, elbow}).translation();
        // A positive turn about y lowers x towards -z.
        EXPECT_NEAR(tip.x(), 0.3 * std::cos(shoulder) + 0.2 * std::cos(shoulder + elbow), kRounding);
        EXPECT_NEAR(tip.y(), 0.0, kRounding);
        EXPECT_NEAR(tip.z(), -0.3 * std::sin(shoulder) - 0.2 * std::sin(shoulder + elbow), kRounding);
    }
}

TEST(SerialChain, itsPathGoesThroughTheJointsToTheTip) {
    const SerialChain arm = chain("gripper.urdf", "base_link", "tool0");
    const double shoulder = 0.4;
    const double elbow = -1.1;
    const std::vector<Eigen::Vector3d> path_m = arm.pathPoints_m({shoulder, elbow});
    // The base, the two joints, the fixed joint of the tool.
    ASSERT_EQ(path_m.size(), 4U);
    EXPECT_EQ(path_m[0], Eigen::Vector3d::Zero());
    EXPECT_EQ(path_m[1], Eigen::Vector3d::Zero());
    const Eigen::Vector3d lower(0.3 * std::cos(shoulder), 0.0, -0.3 * std::sin(shoulder));
    EXPECT_LT((path_m[2] - lower).norm(), kRounding);
    EXPECT_LT((path_m[3] - arm.X_Base_Tip({shoulder, elbow}).translation()).norm(), kRounding);
}

TEST(SerialChain, gravityOfTwoLinksIsThatOfStatics) {
    const SerialChain arm = chain("gripper.urdf", "base_link", "tool0");
    const double shoulder = 0.4;
    const double elbow = -1.1;
    const auto torque = arm.gravityTorque({shoulder, elbow});
    ASSERT_TRUE(torque);
    constexpr double kGravity = 9.81;
    // 2 kg at 0.15 m; 1 kg at 0.1 m and two fingers of 0.1 kg at 0.2 m of the lower link.
    const double lower = (1.0 * 0.1 + 0.2 * 0.2) * std::cos(shoulder + elbow);
    const double upper = (2.0 * 0.15 + 1.2 * 0.3) * std::cos(shoulder);
    // Gravity turns the arm down, about +y; what holds it turns the other way.
    EXPECT_NEAR((*torque)[1], -kGravity * lower, 1e-12);
    EXPECT_NEAR((*torque)[0], -kGravity * (lower + upper), 1e-12);
    EXPECT_NEAR(arm.movedMass_kg(), 3.2, 1e-12);
}

TEST(SerialChain, fingersStandAtTheEndThatIsNearestToZeroAndMimicsFollow) {
    const SerialChain arm = chain("gripper.urdf", "base_link", "tool0");
    const auto poses = arm.linkPoses({0.0, 0.0});
    const ArmModel& model = arm.model();
    EXPECT_NEAR(poses[*model.findLink("finger_left")].translation().y(), 0.01, kRounding);
    EXPECT_NEAR(poses[*model.findLink("finger_right")].translation().y(), -0.01 + 0.002, kRounding);
}

TEST(SerialChain, aMimicOnTheWayMovesWithTheJointThatItFollows) {
    // The tip hangs on the right finger, which mimics the left one.
    const SerialChain arm = chain("gripper.urdf", "tool0", "finger_right");
    ASSERT_EQ(arm.joints(), 1U);
    EXPECT_EQ(arm.joint(0).name, "left");
    EXPECT_NEAR(arm.X_Base_Tip(core::JointVector::zeros(1)).translation().y(), 0.002, kRounding);
    const arm_model::ChainJacobian jacobian = arm.jacobian(core::JointVector::zeros(1));
    EXPECT_NEAR(jacobian(1, 0), -1.0, kRounding);
    EXPECT_NEAR(jacobian.col(0).norm(), 1.0, kRounding);
}

TEST(SerialChain, jacobianIsTheDerivativeOfThePose) {
    const SerialChain arm = chain("crooked_arm.urdf", "base_link", "hand");
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> angle(-2.0, 2.0);
    const Eigen::Vector3d point(0.03, -0.02, 0.07);
    for (int round = 0; round < 50; ++round) {
        core::JointVector q = core::JointVector::zeros(arm.joints());
        for (double& value : q)
            value = angle(random);
        const arm_model::ChainJacobian jacobian = arm.jacobian(q, point);
        for (std::size_t i = 0; i < q.size(); ++i) {
            constexpr double kStep = 1e-6;
            core::JointVector more = q;
            core::JointVector less = q;
            more[i] += kStep;
            less[i] -= kStep;
            const Eigen::Vector3d slope =
                (arm.X_Base_Tip(more) * point - arm.X_Base_Tip(less) * point) / (2.0 * kStep);
            const Eigen::AngleAxisd turn(arm.X_Base_Tip(more).linear() *
                                         arm.X_Base_Tip(less).linear().transpose());
            const auto column = jacobian.col(static_cast<Eigen::Index>(i));
            EXPECT_LT((column.head<3>() - slope).norm(), 1e-8);
            EXPECT_LT((column.tail<3>() - turn.angle() / (2.0 * kStep) * turn.axis()).norm(), 1e-8);
        }
    }
}

TEST(SerialChain, poseAndDerivativeDoNotDependOnTheBaseOfTheDescription) {
    // From the third link on it is an arm of its own.
    const SerialChain whole = chain("crooked_arm.urdf", "base_link", "hand");
    const SerialChain part = chain("crooked_arm.urdf", "l3", "hand");
    ASSERT_EQ(part.joints(), 4U);
    const core::JointVector q{0.3, -0.4, 0.5, -1.2, 0.05, 0.7, -0.8};
    const auto poses = whole.linkPoses(q);
    const Eigen::Isometry3d expected =
        poses[*whole.model().findLink("l3")].inverse() * poses[*whole.model().findLink("hand")];
    EXPECT_TRUE(part.X_Base_Tip({-1.2, 0.05, 0.7, -0.8}).isApprox(expected, 1e-13));
}

TEST(SerialChain, refusesWhatIsNoChain) {
    const auto model = load("gripper.urdf");
    const auto missing = SerialChain::create(model, "base_link", "tool1");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, core::ErrorKind::notFound);
    EXPECT_NE(missing.error().expected.find("tool0"), std::string::npos);
    const auto turned = SerialChain::create(model, "tool0", "base_link");
    ASSERT_FALSE(turned);
    EXPECT_NE(turned.error().message.find("does not hang on"), std::string::npos);
    EXPECT_FALSE(SerialChain::create(model, "finger_left", "finger_right"));
    const auto rigid = SerialChain::create(model, "lower", "tool0");
    ASSERT_FALSE(rigid);
    EXPECT_NE(rigid.error().message.find("no joint"), std::string::npos);
}

TEST(SerialChain, refusesMoreJointsThanAVectorHolds) {
    std::string text = "<robot name='snake'><link name='l0'/>";
    for (int i = 1; i <= 17; ++i) {
        const std::string n = std::to_string(i);
        text += "<link name='l" + n + "'/><joint name='j" + n + "' type='continuous'><parent link='l" +
                std::to_string(i - 1) + "'/><child link='l" + n + "'/><axis xyz='0 0 1'/></joint>";
    }
    const auto model = arm_model::parseUrdf(text + "</robot>", "snake.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    const auto shared = std::make_shared<const ArmModel>(*model);
    EXPECT_TRUE(SerialChain::create(shared, "l0", "l16"));
    EXPECT_FALSE(SerialChain::create(shared, "l0", "l17"));
}

TEST(SerialChain, namesTheLinkWhoseMassIsMissing) {
    const auto model = arm_model::parseUrdf(
        "<robot name='r'><link name='a'/><link name='b'><visual><geometry><sphere radius='0.1'/></geometry>"
        "</visual></link><joint name='j' type='continuous'><parent link='a'/><child link='b'/>"
        "<axis xyz='0 0 1'/></joint></robot>",
        "r.urdf");
    ASSERT_TRUE(model);
    const auto made = SerialChain::create(std::make_shared<const ArmModel>(*model), "a", "b");
    ASSERT_TRUE(made);
    EXPECT_EQ(made->linkWithoutMass(), "b");
    EXPECT_FALSE(made->gravityTorque(core::JointVector::zeros(1)));
}

TEST(SerialChain, theSimulatedArmIsOneOfThem) {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/four-joints.urdf");
    ASSERT_TRUE(model) << core::describe(model.error());
    const auto made = SerialChain::create(std::make_shared<const ArmModel>(*model), "base_link", "tool0");
    ASSERT_TRUE(made) << core::describe(made.error());
    const arm::Arm4Kinematics closedForm;
    const Eigen::Vector3d tip(closedForm.dimensions().forearmLength_m, 0.0, 0.0);
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> angle(-2.0, 2.0);
    for (int round = 0; round < 100; ++round) {
        const arm::JointVector q(angle(random), angle(random), angle(random), angle(random));
        const core::JointVector same{q[0], q[1], q[2], q[3]};
        EXPECT_TRUE(made->X_Base_Tip(same).isApprox(
            closedForm.X_Base_Link(arm::Link::forearm, q) * Eigen::Translation3d(tip), 1e-14));
        EXPECT_TRUE(made->jacobian(same).topRows<3>().isApprox(
            closedForm.pointJacobian(arm::Link::forearm, q, tip), 1e-13));
    }
}
