// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/joint_dials.h"
#include "backend/arm_model/urdf_reader.h"

#include <QTest>

#include <cmath>
#include <memory>
#include <numbers>

using namespace teleta;

namespace {

bool isSame(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    return a.matrix().isApprox(b.matrix(), 1e-9);
}

Eigen::Vector3d pointerOf(const view3d::JointDial& dial) {
    return dial.X_World_Joint.linear() *
           Eigen::Vector3d(std::cos(dial.angle_rad), std::sin(dial.angle_rad), 0.0);
}

} // namespace

/// Where the dials of an arm's joints are.
class JointDialsTest : public QObject {
    Q_OBJECT

private slots:
    void theDialsOfTheArmTurnAsItsLinks() {
        const arm::Arm4Kinematics kinematics;
        core::ArmDescription description;
        description.lowest_rad = {-2.0, -1.6, -2.0, -0.2};
        description.highest_rad = {2.0, 1.6, 2.0, 2.6};
        description.halfThickness_m = 0.03;
        const arm::JointVector q_rad(0.4, -0.7, 0.5, 1.1);
        const auto dials = console::armDials(kinematics, description, q_rad);
        QCOMPARE(dials.size(), std::size_t(4));
        const Eigen::Isometry3d X_Base_Upper = kinematics.X_Base_Link(arm::Link::upperArm, q_rad);
        const Eigen::Isometry3d X_Base_Forearm = kinematics.X_Base_Link(arm::Link::forearm, q_rad);
        // Yaw and elbow point along the link that they move.
        QVERIFY((pointerOf(dials[2]) - X_Base_Upper.linear().col(0)).norm() < 1e-9);
        QVERIFY((pointerOf(dials[3]) - X_Base_Forearm.linear().col(0)).norm() < 1e-9);
        QVERIFY((dials[3].X_World_Joint.translation() - X_Base_Forearm.translation()).norm() < 1e-9);
        for (std::size_t joint = 0; joint < 4; ++joint) {
            QCOMPARE(dials[joint].lowest_rad, description.lowest_rad[joint]);
            QCOMPARE(dials[joint].highest_rad, description.highest_rad[joint]);
            // The dial stands still while its joint turns, and the joint turns about it: a point of the
            // forearm moves by the rotation about the dial's z.
            arm::JointVector turned_rad = q_rad;
            turned_rad[static_cast<Eigen::Index>(joint)] += 0.3;
            const auto turned = console::armDials(kinematics, description, turned_rad);
            QVERIFY(isSame(turned[joint].X_World_Joint, dials[joint].X_World_Joint));
            const Eigen::Isometry3d& X = dials[joint].X_World_Joint;
            const Eigen::Isometry3d turn = X * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) * X.inverse();
            QVERIFY(isSame(turn * X_Base_Forearm, kinematics.X_Base_Link(arm::Link::forearm, turned_rad)));
        }
        description.lowest_rad = core::JointVector::zeros(7);
        QVERIFY2(console::armDials(kinematics, description, q_rad).empty(), "another arm");
    }

    void theDialsOfADescribedArmTurnAsItsTip() {
        const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf");
        QVERIFY(model.has_value());
        const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                          "base_link", "tool0");
        QVERIFY(chain.has_value());
        core::JointVector q = core::JointVector::zeros(chain->joints());
        for (std::size_t i = 0; i < q.size(); ++i)
            q[i] = 0.3 - 0.1 * static_cast<double>(i);
        const console::ChainDials chainDials(std::make_shared<const arm_model::SerialChain>(*chain));
        const auto dials = chainDials.at(q, 0.02);
        QCOMPARE(dials.size(), chain->joints());
        for (std::size_t joint = 0; joint < dials.size(); ++joint) {
            QCOMPARE(dials[joint].angle_rad, q[joint]);
            core::JointVector turned_q = q;
            turned_q[joint] += 0.2;
            QVERIFY(isSame(chainDials.at(turned_q, 0.02)[joint].X_World_Joint, dials[joint].X_World_Joint));
            const Eigen::Isometry3d& X = dials[joint].X_World_Joint;
            const Eigen::Isometry3d turn = X * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()) * X.inverse();
            QVERIFY(isSame(turn * chain->X_Base_Tip(q), chain->X_Base_Tip(turned_q)));
        }
    }

    void theDialsOfTheServosArmTurnAsItsFlange() {
        servo::LwrVector q_rad;
        q_rad << 0.2, 0.5, -0.1, -1.4, 0.3, 1.2, 0.4;
        const auto dials = console::servoDials(q_rad, 0.05);
        QCOMPARE(dials.size(), std::size_t(servo::kLwrJoints));
        const servo::LwrKinematics kinematics;
        for (Eigen::Index joint = 0; joint < servo::kLwrJoints; ++joint) {
            const view3d::JointDial& dial = dials[static_cast<std::size_t>(joint)];
            servo::LwrVector turned_rad = q_rad;
            turned_rad[joint] -= 0.25;
            QVERIFY(
                isSame(console::servoDials(turned_rad, 0.05)[static_cast<std::size_t>(joint)].X_World_Joint,
                       dial.X_World_Joint));
            const Eigen::Isometry3d& X = dial.X_World_Joint;
            const Eigen::Isometry3d turn =
                X * Eigen::AngleAxisd(-0.25, Eigen::Vector3d::UnitZ()) * X.inverse();
            QVERIFY(isSame(turn * kinematics.X_Base_Tool(q_rad), kinematics.X_Base_Tool(turned_rad)));
        }
        // The robot's data sheet.
        QVERIFY(std::abs(dials[0].highest_rad - 170.0 * std::numbers::pi / 180.0) < 1e-9);
        QVERIFY(std::abs(dials[1].lowest_rad + 120.0 * std::numbers::pi / 180.0) < 1e-9);
        q_rad[3] = std::nan("");
        QVERIFY(console::servoDials(q_rad, 0.05).empty());
    }
};

QTEST_GUILESS_MAIN(JointDialsTest)
#include "joint_dials_test.moc"
