// SPDX-License-Identifier: GPL-3.0-or-later
// The force at the wrist of a planar arm whose two joints turn about y, so that the tool is turned by their
// sum.
#include "backend/arm_model/urdf_reader.h"
#include "devices/ros/wrench_watch.h"
#include "tests/devices/ros/told_frames.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace teleta::ros_arm {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const arm_model::SerialChain> planarArm() {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/tests/data/urdf/gripper.urdf");
    EXPECT_TRUE(model);
    const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                      "base_link", "tool0");
    EXPECT_TRUE(chain);
    return std::make_shared<const arm_model::SerialChain>(*chain);
}

RosWrenchFile sensor() {
    RosWrenchFile file;
    file.name = "wrist";
    file.topic = "/ft/wrench";
    return file;
}

class Wrist {
public:
    explicit Wrist(const RosWrenchFile& file = sensor())
        : watch(file, planarArm()) {}
    void tell(double x, double y, double z, std::int64_t time_ns, std::string frame = {},
              const Eigen::Vector3d& torque_Nm = Eigen::Vector3d::Zero()) {
        ros::WrenchStamped message{};
        message.header.frame_id = frame.data();
        message.wrench.force = {x, y, z};
        message.wrench.torque = {torque_Nm.x(), torque_Nm.y(), torque_Nm.z()};
        watch.take(message, time_ns);
    }
    /// quaternion: w, x, y, z.
    /// moving_ns: when it was read, of /tf; nothing: of /tf_static.
    void hang(std::string frame, std::string parent, const std::array<double, 3>& p_m,
              const std::array<double, 4>& quaternion, std::optional<std::int64_t> moving_ns = {}) {
        test::tellFrames({{std::move(frame), std::move(parent), p_m, quaternion}},
                         [&](const ros::TFMessage& message) {
                             if (moving_ns)
                                 watch.takeMoving(message, *moving_ns);
                             else
                                 watch.takeFixed(message);
                         });
    }
    WrenchWatch watch;
};

TEST(WrenchWatch, turnsTheForceIntoTheBase) {
    Wrist wrist;
    const core::JointVector q{0.4, 0.3};
    EXPECT_FALSE(wrist.watch.takeForce_Base_N(q, 0)) << "nothing was told yet";
    wrist.tell(1.0, 2.0, 3.0, 0);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto tool = wrist.watch.takeForce_Base_N(q, 100 * kMs);
    ASSERT_TRUE(tool);
    EXPECT_TRUE(tool->isApprox(Eigen::Vector3d(c + 3.0 * s, 2.0, 3.0 * c - s), 1e-12));
    wrist.tell(1.0, 2.0, 3.0, 0, "base_link");
    EXPECT_TRUE(wrist.watch.takeForce_Base_N(q, 0)->isApprox(Eigen::Vector3d(1.0, 2.0, 3.0), 1e-12));
}

/// The tip of the arm is turned by the sum of both joints and lies where the links end. A force F in the
/// base's origin has the torque -p x F about the tip.
TEST(WrenchWatch, movesForceAndTorqueToTheTip) {
    Wrist wrist;
    const core::JointVector q{0.4, 0.3};
    EXPECT_FALSE(wrist.watch.atTip(q)) << "nothing was told yet";
    wrist.tell(1.0, 2.0, 3.0, 7 * kMs, "base_link", {0.1, -0.2, 0.3});
    const Eigen::Isometry3d X_Base_Tip = planarArm()->X_Base_Tip(q);
    const Eigen::Matrix3d R_Tip_Base = Eigen::AngleAxisd(-0.7, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const Eigen::Vector3d F_N(1.0, 2.0, 3.0);
    const auto tip = wrist.watch.atTip(q);
    ASSERT_TRUE(tip);
    EXPECT_EQ(tip->time_ns, 7 * kMs);
    const auto vectorOf = [](const std::array<double, 3>& axes) {
        return Eigen::Vector3d(axes[0], axes[1], axes[2]);
    };
    EXPECT_TRUE(vectorOf(tip->force_N).isApprox(R_Tip_Base * F_N, 1e-12));
    const Eigen::Vector3d torque_Nm =
        R_Tip_Base * (Eigen::Vector3d(0.1, -0.2, 0.3) - X_Base_Tip.translation().cross(F_N));
    EXPECT_TRUE(vectorOf(tip->torque_Nm).isApprox(torque_Nm, 1e-12));

    wrist.tell(1.0, 2.0, 3.0, 8 * kMs, {}, {0.1, -0.2, 0.3}); // of the tip itself
    EXPECT_TRUE(vectorOf(wrist.watch.atTip(q)->force_N).isApprox(F_N, 1e-12));
    EXPECT_TRUE(vectorOf(wrist.watch.atTip(q)->torque_Nm).isApprox(Eigen::Vector3d(0.1, -0.2, 0.3), 1e-12));
    wrist.tell(1.0, 2.0, 3.0, 9 * kMs, {}, {0.1, kNan, 0.3});
    EXPECT_FALSE(wrist.watch.atTip(q));
    wrist.tell(1.0, 2.0, 3.0, 9 * kMs, "elsewhere");
    EXPECT_FALSE(wrist.watch.atTip(q));
}

TEST(WrenchWatch, hasTheFrameAndTheSignOfItsFile) {
    RosWrenchFile file = sensor();
    file.frame = "upper";
    file.sign = -1.0;
    Wrist wrist(file);
    wrist.tell(1.0, 0.0, 0.0, 0);
    const auto force = wrist.watch.takeForce_Base_N({0.4, 0.3}, 0);
    ASSERT_TRUE(force);
    EXPECT_TRUE(force->isApprox(Eigen::Vector3d(-std::cos(0.4), 0.0, std::sin(0.4)), 1e-12));
}

/// A sensor 0.1 m beyond the tool, turned by a right angle about its z.
TEST(WrenchWatch, findsAFrameThatHangsOnALink) {
    Wrist wrist;
    const core::JointVector q{0.0, 0.0};
    wrist.tell(1.0, 2.0, 3.0, 0, "sensor");
    EXPECT_FALSE(wrist.watch.takeForce_Base_N(q, 0));
    EXPECT_EQ(wrist.watch.unknownFrame(), "sensor");
    wrist.hang("/mount", "tool0", {0.0, 0.0, 0.1}, {2.0, 0.0, 0.0, 0.0}); // not of length 1
    wrist.hang("sensor", "/mount", {0.0, 0.0, 0.0}, {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)});
    EXPECT_EQ(wrist.watch.unknownFrame(), "");
    const auto tip = wrist.watch.atTip(q);
    ASSERT_TRUE(tip);
    // x of the sensor is y of the tool; (0, 0, 0.1) x (-2, 1, 3) = (-0.1, -0.2, 0).
    const std::array<double, 3> force_N{-2.0, 1.0, 3.0};
    const std::array<double, 3> torque_Nm{-0.1, -0.2, 0.0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(tip->force_N[axis], force_N[axis], 1e-12);
        EXPECT_NEAR(tip->torque_Nm[axis], torque_Nm[axis], 1e-12);
    }
    // What says nothing changes nothing.
    wrist.hang("sensor", "tool0", {0.0, kNan, 0.0}, {1.0, 0.0, 0.0, 0.0});
    wrist.hang("sensor", "tool0", {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0});
    EXPECT_NEAR(wrist.watch.atTip(q)->force_N[0], -2.0, 1e-12);
    // Frames that hang on each other are nowhere.
    wrist.hang("mount", "sensor", {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0});
    EXPECT_FALSE(wrist.watch.atTip(q));
    EXPECT_EQ(wrist.watch.unknownFrame(), "sensor");
}

/// A sensor behind a tool changer that turns: /tf says how far.
TEST(WrenchWatch, followsAFrameThatMovesAndForgetsItWhenNothingMoreIsReported) {
    Wrist wrist;
    const core::JointVector q{0.0, 0.0};
    const std::array<double, 4> straight{1.0, 0.0, 0.0, 0.0};
    const std::array<double, 4> quarter{std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
    wrist.hang("changer", "tool0", {0.0, 0.0, 0.05}, straight, 0);
    wrist.hang("sensor", "changer", {0.0, 0.0, 0.05}, straight);
    wrist.tell(1.0, 0.0, 0.0, 10 * kMs, "sensor");
    ASSERT_TRUE(wrist.watch.atTip(q));
    EXPECT_NEAR(wrist.watch.atTip(q)->force_N[0], 1.0, 1e-12);
    wrist.hang("changer", "tool0", {0.0, 0.0, 0.05}, quarter, 900 * kMs);
    EXPECT_NEAR(wrist.watch.atTip(q)->force_N[1], 1.0, 1e-12);
    wrist.tell(1.0, 0.0, 0.0, 1900 * kMs, "sensor");
    EXPECT_TRUE(wrist.watch.takeForce_Base_N(q, 1900 * kMs));
    wrist.tell(1.0, 0.0, 0.0, 1901 * kMs, "sensor");
    EXPECT_FALSE(wrist.watch.takeForce_Base_N(q, 1901 * kMs)) << "nobody knows where the changer is";
    EXPECT_EQ(wrist.watch.unknownFrame(), "sensor");
    wrist.hang("changer", "tool0", {0.0, 0.0, 0.05}, straight, 1902 * kMs);
    wrist.tell(1.0, 0.0, 0.0, 1903 * kMs, "sensor");
    EXPECT_TRUE(wrist.watch.takeForce_Base_N(q, 1903 * kMs));
    EXPECT_EQ(wrist.watch.unknownFrame(), "");
}

TEST(WrenchWatch, doesNotKnowAnOldForceOrOneOfAnUnknownFrame) {
    Wrist wrist;
    const core::JointVector q{0.0, 0.0};
    wrist.tell(1.0, 0.0, 0.0, 0);
    EXPECT_TRUE(wrist.watch.takeForce_Base_N(q, 100 * kMs));
    EXPECT_FALSE(wrist.watch.takeForce_Base_N(q, 101 * kMs));
    wrist.tell(1.0, 0.0, 0.0, 200 * kMs, "ft_sensor");
    EXPECT_FALSE(wrist.watch.takeForce_Base_N(q, 200 * kMs));
    EXPECT_EQ(wrist.watch.unknownFrame(), "ft_sensor");
    wrist.tell(2.0, 0.0, 0.0, 210 * kMs);
    EXPECT_EQ(wrist.watch.unknownFrame(), "");
    EXPECT_EQ(wrist.watch.takeForce_Base_N(q, 210 * kMs)->x(), 2.0);
    EXPECT_EQ(wrist.watch.messages(), 3U);
}

TEST(WrenchWatch, missesNoPeakBetweenTwoLooks) {
    Wrist wrist;
    const core::JointVector q{0.0, 0.0};
    wrist.tell(1.0, 0.0, 0.0, 0);
    wrist.tell(-40.0, 0.0, 0.0, kMs);
    wrist.tell(2.0, 0.0, 0.0, 2 * kMs);
    EXPECT_EQ(wrist.watch.takeForce_Base_N(q, 2 * kMs)->x(), -40.0);
    EXPECT_EQ(wrist.watch.takeForce_Base_N(q, 2 * kMs)->x(), 2.0) << "the newest";
    wrist.tell(kNan, 0.0, 0.0, 3 * kMs);
    wrist.tell(50.0, 0.0, 0.0, 4 * kMs);
    EXPECT_TRUE(std::isnan(wrist.watch.takeForce_Base_N(q, 4 * kMs)->x())) << "no number is no small force";
}

TEST(RosWrenchFile, readsItsKeys) {
    const std::string shortest = "kind = \"ros_wrench\"\nname = \"wrist\"\ntopic = \"/ft/wrench\"\n";
    const auto file = parseRosWrench(shortest, "ft.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->topic, "/ft/wrench");
    EXPECT_EQ(file->sign, 1.0);
    EXPECT_EQ(file->timeout_s, 0.1);
    EXPECT_FALSE(file->domain);
    const auto whole = parseRosWrench(
        shortest + "frame = \"tool0\"\nwrench_sign = -1\ntimeout_s = 0.05\n[ros]\ndomain = 4\n", "ft.toml");
    ASSERT_TRUE(whole) << core::describe(whole.error());
    EXPECT_EQ(whole->frame, "tool0");
    EXPECT_EQ(whole->sign, -1.0);
    EXPECT_EQ(whole->timeout_s, 0.05);
    EXPECT_EQ(whole->domain->domain, 4);
    for (const char* line : {"wrench_sign = 0\n", "wrench_sign = 2\n", "timeout_s = 0.001\n", "sign = 1\n"}) {
        const auto bad = parseRosWrench(shortest + line, "ft.toml");
        ASSERT_FALSE(bad) << line;
        EXPECT_EQ(bad.error().where.line, 4) << line;
    }
}

} // namespace
} // namespace teleta::ros_arm
