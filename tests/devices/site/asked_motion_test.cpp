// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "devices/site/asked_motion.h"
#include "devices/site/site_topics.h"
#include "tests/backend/pipeline/scripted_arm_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace teleta;
using core::JointVector;
using site_link::AskedMotion;

namespace {

constexpr std::int64_t kNow_ns = 1'000'000'000'000;

/// The four-joint arm of the paper, and a chain of as many joints.
class AskedMotionTest : public ::testing::Test {
protected:
    AskedMotionTest() {
        const auto model = arm_model::parseUrdf(R"(<robot name="four">
  <link name="base"/><link name="a"/><link name="b"/><link name="c"/><link name="hand"/>
  <joint name="j1" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="1" effort="9"/></joint>
  <joint name="j2" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" velocity="1" effort="9"/></joint>
  <joint name="j3" type="revolute"><parent link="b"/><child link="c"/><origin xyz="0 0 0.4"/><axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" velocity="1" effort="9"/></joint>
  <joint name="j4" type="revolute"><parent link="c"/><child link="hand"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" velocity="1" effort="9"/></joint>
</robot>)",
                                                "four.urdf");
        EXPECT_TRUE(model) << core::describe(model.error());
        auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                    "base", "hand");
        EXPECT_TRUE(chain) << core::describe(chain.error());
        m_arm.source = &m_source;
        m_arm.chain = std::make_shared<const arm_model::SerialChain>(*chain);
        m_arm.angles = [this] { return site_link::ArmReading{m_angles, m_read_ns}; };
    }

    [[nodiscard]] std::optional<AskedMotion> asked(std::uint8_t kind, std::vector<double> values,
                                                   const std::string& frame = {}) const {
        return AskedMotion::of(kind, frame, values, m_arm);
    }
    /// Velocity and angular velocity of the tip at these rates, by differences.
    [[nodiscard]] Eigen::Vector<double, 6> tipVelocity(const JointVector& rates) const {
        constexpr double kStep_s = 1e-6;
        JointVector before = m_angles;
        JointVector after = m_angles;
        for (std::size_t i = 0; i < rates.size(); ++i) {
            before[i] -= kStep_s * rates[i];
            after[i] += kStep_s * rates[i];
        }
        const Eigen::Isometry3d from = m_arm.chain->X_Base_Tip(before);
        const Eigen::Isometry3d to = m_arm.chain->X_Base_Tip(after);
        const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
        Eigen::Vector<double, 6> velocity;
        velocity << to.translation() - from.translation(), turn.angle() * turn.axis();
        return velocity / (2.0 * kStep_s);
    }

    test::ScriptedArmSource m_source;
    site_link::SiteArm m_arm;
    JointVector m_angles{0.4, 0.7, 0.9, -0.2};
    std::int64_t m_read_ns = kNow_ns;
};

} // namespace

TEST_F(AskedMotionTest, ratesAreThoseOfTheJoints) {
    const auto motion = asked(site_link::kRatesCommand, {0.1, -0.2, 0.3, 0.0});
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->rates(m_arm, kNow_ns), (JointVector{0.1, -0.2, 0.3, 0.0}));
    EXPECT_FALSE(asked(site_link::kRatesCommand, {0.1, -0.2, 0.3}));
}

/// Led by old angles it would go on at its rate past its target, for as long as commands come.
TEST_F(AskedMotionTest, whatIsLedByAnglesRestsOnceTheyAreOld) {
    const auto positions = asked(site_link::kPositionsCommand, {0.0, 0.0, 0.0, 0.0});
    const auto twist = asked(site_link::kTwistCommand, {0.1, 0.0, 0.0, 0.0, 0.0, 0.0});
    const auto rates = asked(site_link::kRatesCommand, {0.1, -0.2, 0.3, 0.0});
    m_arm.oldestAngles_ns = 100'000'000;
    m_read_ns = kNow_ns - 100'000'000;
    const JointVector none = JointVector::zeros(4);
    EXPECT_NE(positions->rates(m_arm, kNow_ns), none);
    EXPECT_NE(twist->rates(m_arm, kNow_ns), none);
    EXPECT_TRUE(positions->isLed(m_arm, kNow_ns));
    --m_read_ns;
    EXPECT_FALSE(positions->isLed(m_arm, kNow_ns));
    EXPECT_FALSE(twist->isLed(m_arm, kNow_ns));
    EXPECT_TRUE(rates->isLed(m_arm, kNow_ns));
    EXPECT_EQ(positions->rates(m_arm, kNow_ns), none);
    EXPECT_EQ(twist->rates(m_arm, kNow_ns), none);
    EXPECT_EQ(rates->rates(m_arm, kNow_ns), (JointVector{0.1, -0.2, 0.3, 0.0}));
}

/// A turn about the base's axis and a motion within the plane of the arm, which four joints can do.
TEST_F(AskedMotionTest, aTwistMovesTheTipInTheFrameThatIsNamed) {
    Eigen::Vector<double, 6> wanted = tipVelocity({0.1, 0.2, -0.3, 0.15});
    const auto inBase = asked(site_link::kTwistCommand, {wanted.begin(), wanted.end()}, "base");
    ASSERT_TRUE(inBase);
    EXPECT_LT((tipVelocity(inBase->rates(m_arm, kNow_ns)) - wanted).norm(), 1e-6);

    const Eigen::Matrix3d R_Tip_Base = m_arm.chain->X_Base_Tip(m_angles).linear().transpose();
    Eigen::Vector<double, 6> inTip;
    inTip << R_Tip_Base * wanted.head<3>(), R_Tip_Base * wanted.tail<3>();
    const auto ofTip = asked(site_link::kTwistCommand, {inTip.begin(), inTip.end()}, "hand");
    ASSERT_TRUE(ofTip);
    EXPECT_LT((tipVelocity(ofTip->rates(m_arm, kNow_ns)) - wanted).norm(), 1e-6);
}

TEST_F(AskedMotionTest, positionsAreReachedTogetherAndWithinTheRange) {
    const core::ArmDescription& arm = m_source.description();
    m_angles = JointVector{0.0, 0.0, 0.0, 0.0};
    const auto motion = asked(site_link::kPositionsCommand, {0.4, -0.2, 0.0, 0.1});
    ASSERT_TRUE(motion);
    constexpr double kStep_s = 0.01;
    double least = 1.0;
    for (int i = 0; i < 2000; ++i) {
        const JointVector rates = motion->rates(m_arm, kNow_ns);
        for (std::size_t joint = 0; joint < rates.size(); ++joint) {
            ASSERT_LE(std::abs(rates[joint]), arm.fastest_radPerS[joint] * (1.0 + 1e-12));
            m_angles[joint] += kStep_s * rates[joint];
        }
        ASSERT_NEAR(m_angles[1], -0.5 * m_angles[0], 1e-12) << "a straight line of angles";
        least = std::min(least, std::abs(rates[0]));
    }
    EXPECT_NEAR(m_angles[0], 0.4, 1e-9);
    EXPECT_NEAR(m_angles[3], 0.1, 1e-9);
    EXPECT_LT(least, 1e-9);

    JointVector far = arm.highest_rad;
    for (double& angle : far)
        angle += 1.0;
    m_angles = arm.highest_rad;
    const auto beyond = asked(site_link::kPositionsCommand, {far.begin(), far.end()});
    ASSERT_TRUE(beyond);
    for (const double rate : beyond->rates(m_arm, kNow_ns))
        EXPECT_EQ(rate, 0.0);
}

TEST_F(AskedMotionTest, whatTheArmCannotDoIsRefused) {
    const std::vector<double> twist{0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
    EXPECT_FALSE(asked(site_link::kTwistCommand, twist, "elsewhere"));
    EXPECT_FALSE(asked(site_link::kTwistCommand, {0.0, 0.0, 0.1}));
    EXPECT_FALSE(asked(4, {0.1, 0.1, 0.1, 0.1}));
    m_arm.chain = nullptr;
    EXPECT_FALSE(asked(site_link::kTwistCommand, twist));
    EXPECT_TRUE(asked(site_link::kPositionsCommand, {0.1, 0.1, 0.1, 0.1}));
    m_arm.angles = nullptr;
    EXPECT_FALSE(asked(site_link::kPositionsCommand, {0.1, 0.1, 0.1, 0.1}));
    EXPECT_TRUE(asked(site_link::kRatesCommand, {0.1, 0.1, 0.1, 0.1}));
}

TEST_F(AskedMotionTest, nothingMovesWhileTheAnglesAreNotKnown) {
    const auto positions = asked(site_link::kPositionsCommand, {0.1, 0.1, 0.1, 0.1});
    const auto twist = asked(site_link::kTwistCommand, {0.0, 0.0, 0.1, 0.0, 0.0, 0.0});
    ASSERT_TRUE(positions && twist);
    for (const JointVector& unknown :
         {JointVector(), JointVector{0.0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}}) {
        m_angles = unknown;
        EXPECT_EQ(positions->rates(m_arm, kNow_ns), JointVector::zeros(4));
        EXPECT_EQ(twist->rates(m_arm, kNow_ns), JointVector::zeros(4));
    }
}
