// SPDX-License-Identifier: GPL-3.0-or-later
// The robot as another process of Fast DDS sees it. Expected values are closed forms of its arm: seven
// joints, straight up at 0, the tip 0.946 m above joint_2 and 0.526 m above joint_4.
#include "dds_node.h"
#include "messages.h"
#include "messagesPubSubTypes.h"
#include "tests/support/peer_process.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <numeric>
#include <sstream>
#include <thread>
#include <unistd.h>

using namespace teleta;
using namespace teleta::peer;
namespace fast = eprosima::fastdds::dds;

namespace {

using sensor_msgs::msg::JointState;
using trajectory_msgs::msg::JointTrajectory;

const std::string kUrdf = TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf";
constexpr double kHeightOverJoint2_m = 0.2045 + 0.2155 + 0.1845 + 0.2155 + 0.081 + 0.045;
constexpr double kHeightOverJoint4_m = 0.1845 + 0.2155 + 0.081 + 0.045;

std::string textOf(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// Waits until `holds`, at most 30 s.
template <class Condition>
bool eventually(Condition holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

class RosRobot : public ::testing::Test {
protected:
    void start(const QStringList& more = {}) {
        QStringList arguments = {
            "--domain",  QString::number(m_domain), "--urdf",    QString::fromStdString(kUrdf),
            "--json",    m_folder.filePath("log"),  "--seconds", "100",
            "--commands"};
        m_robot.start(QStringLiteral(TELETA_ROS_ROBOT), arguments + more, true);
        ASSERT_TRUE(m_robot.waitFor("ready")) << ::testing::PrintToString(m_robot.takeLines());
        m_node.read("/joint_states", fast::TypeSupport(new sensor_msgs::msg::JointStatePubSubType),
                    {.reliable = false, .depth = 2000}, &m_joints);
        ASSERT_TRUE(eventually([&] { return next(); }));
    }

    /// Takes what has come of the joints; true when there is more.
    bool next() {
        std::vector<JointState> taken = m_joints.take();
        if (taken.empty())
            return false;
        m_last = taken.back();
        m_seen.insert(m_seen.end(), taken.begin(), taken.end());
        return true;
    }

    bool eventuallyJoints(const std::function<bool(const JointState&)>& holds) {
        return eventually([&] { return next() && holds(m_last); });
    }

    bool restsAt(std::size_t joint, double position_rad, double tolerance_rad) {
        return eventuallyJoints([&](const JointState& state) {
            return std::abs(state.position()[joint] - position_rad) < tolerance_rad &&
                   std::abs(state.velocity()[joint]) < 1e-3;
        });
    }

    fast::DataWriter* commander() {
        fast::DataWriter* writer =
            m_node.write("/arm_controller/joint_trajectory",
                         fast::TypeSupport(new trajectory_msgs::msg::JointTrajectoryPubSubType), {});
        EXPECT_TRUE(eventually([&] {
            fast::PublicationMatchedStatus status;
            writer->get_publication_matched_status(status);
            return status.current_count == 1;
        }));
        return writer;
    }

    /// One point for all joints: the first at `position_rad` after `time_s`.
    static JointTrajectory way(double position_rad, double velocity_radPerS, std::int32_t time_s) {
        JointTrajectory trajectory;
        trajectory_msgs::msg::JointTrajectoryPoint point;
        for (int i = 1; i <= 7; ++i) {
            trajectory.joint_names().push_back("joint_" + std::to_string(i));
            point.positions().push_back(i == 1 ? position_rad : 0);
            point.velocities().push_back(i == 1 ? velocity_radPerS : 0);
        }
        point.time_from_start().sec(time_s);
        trajectory.points().push_back(point);
        return trajectory;
    }

    /// Ends the robot; the lines of its log of one kind.
    std::vector<nlohmann::json> logOf(const std::string& event) {
        m_robot.say("end");
        EXPECT_TRUE(m_robot.waitFor("ended"));
        std::ifstream file(m_folder.filePath("log").toStdString());
        std::vector<nlohmann::json> found;
        for (std::string line; std::getline(file, line);)
            if (nlohmann::json one = nlohmann::json::parse(line); one["event"] == event)
                found.push_back(one);
        return found;
    }

    QTemporaryDir m_folder;
    test::PeerProcess m_robot;
    int m_domain = 100 + static_cast<int>(getpid() % 100);
    Inbox<JointState> m_joints;
    Inbox<std_msgs::msg::String> m_description;
    Inbox<tf2_msgs::msg::TFMessage> m_fixed;
    Inbox<geometry_msgs::msg::WrenchStamped> m_wrench;
    Inbox<std_msgs::msg::Float64MultiArray> m_pad;
    JointState m_last;
    std::vector<JointState> m_seen;
    DdsNode m_node{m_domain};
};

} // namespace

TEST_F(RosRobot, tellsItsJointsDescriptionAndFrames) {
    start();
    ASSERT_TRUE(eventually([&] { return next() && m_seen.size() >= 1000; }));
    double last_s = 0;
    for (const JointState& state : m_seen) {
        ASSERT_EQ(state.name(), way(0, 0, 1).joint_names());
        ASSERT_EQ(state.position().size(), 7U);
        ASSERT_EQ(state.effort().size(), 7U);
        const double stamp_s = state.header().stamp().sec() + 1e-9 * state.header().stamp().nanosec();
        ASSERT_GT(stamp_s, last_s);
        last_s = stamp_s;
        for (std::size_t i = 0; i < 7; ++i)
            ASSERT_NEAR(state.position()[i], 0, 1e-6);
    }

    // They were published before this reader was there.
    const EndQos latched{.transientLocal = true};
    m_node.read("/robot_description", fast::TypeSupport(new std_msgs::msg::StringPubSubType), latched,
                &m_description);
    m_node.read("/tf_static", fast::TypeSupport(new tf2_msgs::msg::TFMessagePubSubType), latched, &m_fixed);
    std::vector<std_msgs::msg::String> texts;
    ASSERT_TRUE(eventually([&] { return !(texts = m_description.take()).empty(); }));
    EXPECT_EQ(texts.front().data(), textOf(kUrdf));
    std::vector<tf2_msgs::msg::TFMessage> frames;
    ASSERT_TRUE(eventually([&] { return !(frames = m_fixed.take()).empty(); }));
    ASSERT_EQ(frames.front().transforms().size(), 1U);
    const auto& flange = frames.front().transforms().front();
    EXPECT_EQ(flange.header().frame_id(), "link_7");
    EXPECT_EQ(flange.child_frame_id(), "tool0");
    EXPECT_EQ(flange.transform().translation().z(), 0.045);
    EXPECT_EQ(flange.transform().rotation().w(), 1);
}

TEST_F(RosRobot, followsATrajectoryToItsEnd) {
    start();
    JointTrajectory trajectory = way(0.3, 0, 1);
    fast::DataWriter* writer = commander();
    writer->write(&trajectory);
    ASSERT_TRUE(restsAt(0, 0.3, 1e-4));
    // A cubic from rest to rest over 1 s is fastest at its middle: 1.5 * 0.3 rad/s.
    double fastest = 0;
    for (const JointState& state : m_seen)
        fastest = std::max(fastest, state.velocity()[0]);
    EXPECT_NEAR(fastest, 0.45, 0.01);

    JointTrajectory partial = way(0.1, 0, 1);
    partial.joint_names().pop_back();
    partial.points().front().positions().pop_back();
    partial.points().front().velocities().pop_back();
    JointTrajectory moving = way(0.1, 0.2, 1);
    for (JointTrajectory* refused : {&partial, &moving})
        writer->write(refused);
    EXPECT_TRUE(eventually([&] {
        return writer->wait_for_acknowledgments({1, 0}) == ReturnCode_t::RETCODE_OK;
    }));
    m_seen.clear();
    ASSERT_TRUE(eventually([&] { return next() && m_seen.size() > 200; }));
    EXPECT_NEAR(m_last.position()[0], 0.3, 1e-4);
    const auto log = logOf("trajectory");
    ASSERT_GE(log.size(), 2U);
    EXPECT_EQ(log.front()["accepted"], true);
    EXPECT_EQ(log.back()["reason"], "the end is not at rest");
}

TEST_F(RosRobot, feelsAForceInItsSensorAndItsJoints) {
    start();
    m_node.read("/ft/wrench", fast::TypeSupport(new geometry_msgs::msg::WrenchStampedPubSubType),
                {.reliable = false}, &m_wrench);
    geometry_msgs::msg::WrenchStamped last;
    const auto settles = [&](double x_N, double z_N) {
        return eventually([&] {
            for (const auto& wrench : m_wrench.take())
                last = wrench;
            return std::abs(last.wrench().force().x() - x_N) < 0.15 &&
                   std::abs(last.wrench().force().z() - z_N) < 0.15;
        });
    };
    EXPECT_TRUE(settles(0, 0));
    EXPECT_TRUE(m_robot.command("push 0 0 -10"));
    EXPECT_TRUE(settles(0, -10)) << last.wrench().force().z();
    EXPECT_EQ(last.header().frame_id(), "tool0");
    EXPECT_TRUE(m_robot.command("push 10 0 0"));
    EXPECT_TRUE(settles(10, 0)) << last.wrench().force().x();
    EXPECT_NEAR(last.wrench().torque().y(), 0, 1e-3);
    // joint_2 turns about y, joint_4 about -y; each holds against force times height.
    EXPECT_TRUE(eventuallyJoints([&](const JointState& state) {
        return std::abs(state.effort()[1] + 10 * kHeightOverJoint2_m) < 0.1 &&
               std::abs(state.effort()[3] - 10 * kHeightOverJoint4_m) < 0.1 &&
               std::abs(state.effort()[0]) < 0.1;
    })) << m_last.effort()[1]
        << ' ' << m_last.effort()[3];
}

TEST_F(RosRobot, feelsTheBallOnItsPad) {
    start({"--pad"});
    m_node.read("/pad/tactile", fast::TypeSupport(new std_msgs::msg::Float64MultiArrayPubSubType),
                {.reliable = false}, &m_pad);
    std_msgs::msg::Float64MultiArray last;
    const auto presses = [&](double force_N) {
        return eventually([&] {
            for (const auto& frame : m_pad.take())
                last = frame;
            const double sum = std::accumulate(last.data().begin(), last.data().end(), 0.0);
            return !last.data().empty() && std::abs(sum - force_N) < 0.005 * force_N + 1e-9;
        });
    };
    EXPECT_TRUE(presses(0));
    ASSERT_EQ(last.data().size(), 84U);
    EXPECT_EQ(last.layout().dim().at(0).size(), 14U);
    EXPECT_EQ(last.layout().dim().at(1).size(), 6U);
    EXPECT_TRUE(m_robot.command("press 2"));
    // The ball of 12 mm lies between four spheres of 1.7 mm, 1.7 mm from it in both directions: each pushes
    // back along the line between the centres.
    const double cosine = std::sqrt(1 - 2 * 1.7 * 1.7 / (13.7 * 13.7));
    EXPECT_TRUE(presses(2 / cosine)) << std::accumulate(last.data().begin(), last.data().end(), 0.0);
    for (const std::size_t taxel : {6U * 6 + 2, 6U * 6 + 3, 7U * 6 + 2, 7U * 6 + 3})
        EXPECT_NEAR(last.data()[taxel], 2 / cosine / 4, 0.01);
}

TEST_F(RosRobot, anObjectPushesLikeASpring) {
    // The tip looks up. The ball stands 1 mm too low, beside the axes of joints 2, 4 and 6, in the middle of
    // a taxel: on the line between two of them both would feel it.
    constexpr double kStiffness_NPerM = 2000.0;
    constexpr double kDepth_m = 0.001;
    constexpr double kLever_m = 2.5 * 0.0034;
    constexpr double kBall_m = 0.012;
    const double tip_m = 0.1575 + 0.2025 + kHeightOverJoint2_m;
    start({"--pad", "--torque-sensors", "--object",
           QString("%1,0.0017,%2,%3")
               .arg(kLever_m)
               .arg(tip_m + kBall_m - kDepth_m, 0, 'g', 12)
               .arg(kStiffness_NPerM)});
    std::this_thread::sleep_for(std::chrono::seconds(2));
    ASSERT_TRUE(eventually([&] { return next(); }));
    const nlohmann::json state = logOf("state").back();
    EXPECT_NEAR(state["depth_m"][0].get<double>(), -kDepth_m, 0.02 * kDepth_m);
    const double force_N = state["pad_N"];
    EXPECT_NEAR(force_N, kStiffness_NPerM * kDepth_m, 0.02 * kStiffness_NPerM * kDepth_m);
    for (const std::size_t joint : {1, 3, 5})
        EXPECT_NEAR(std::abs(m_last.effort()[joint]), force_N * kLever_m, 0.02 * force_N * kLever_m) << joint;
    for (const std::size_t joint : {0, 2, 4, 6})
        EXPECT_NEAR(m_last.effort()[joint], 0.0, 1e-4) << joint;
}

TEST_F(RosRobot, keepsTheLastVelocityForEver) {
    start({"--controller", "velocity"});
    fast::DataWriter* writer = m_node.write("/velocity_controller/commands",
                                            fast::TypeSupport(new std_msgs::msg::Float64MultiArrayPubSubType),
                                            {.transientLocal = true});
    std_msgs::msg::Float64MultiArray message;
    message.data({0, 0, 0, 0, 0, 0, 0.5});
    writer->write(&message);
    ASSERT_TRUE(eventuallyJoints([](const JointState& state) { return state.position()[6] > 0.05; }));
    m_node.remove(writer);
    ASSERT_TRUE(eventuallyJoints([](const JointState& state) { return state.position()[6] > 0.5; }));
    // The servo against damping: 120 (0.5 - v) = 1 v.
    EXPECT_NEAR(m_last.velocity()[6], 0.5 * 120 / 121, 1e-3);
}

TEST_F(RosRobot, failsAsItIsAskedTo) {
    start();
    const auto stampOf = [](const JointState& state) { return state.header().stamp().sec(); };
    EXPECT_TRUE(m_robot.command("fault nan"));
    EXPECT_TRUE(eventuallyJoints([](const JointState& state) { return std::isnan(state.position()[0]); }));
    EXPECT_TRUE(m_robot.command("fault missing"));
    EXPECT_TRUE(eventuallyJoints([](const JointState& state) {
        return state.name().size() == 6 && state.position().size() == 6 && !std::isnan(state.position()[0]);
    }));
    EXPECT_TRUE(m_robot.command("fault swapped"));
    EXPECT_TRUE(eventuallyJoints([](const JointState& state) { return state.name().front() == "joint_7"; }));
    EXPECT_TRUE(m_robot.command("fault jump"));
    EXPECT_TRUE(
        eventuallyJoints([](const JointState& state) { return std::abs(state.position()[0] - 0.5) < 1e-3; }));
    const std::int32_t before_s = stampOf(m_last);
    EXPECT_TRUE(m_robot.command("fault backward"));
    EXPECT_TRUE(eventuallyJoints([&](const JointState& state) { return stampOf(state) < before_s; }));
    EXPECT_TRUE(m_robot.command("fault silent"));
    // The fault begins with a later step: until then states still come.
    ASSERT_TRUE(eventually([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        return !next();
    }));
    EXPECT_TRUE(m_robot.command("fault best-effort"));
    EXPECT_TRUE(eventuallyJoints([](const JointState&) { return true; }));
    m_robot.say("fault unheard-of");
    EXPECT_TRUE(m_robot.waitFor("error"));
    EXPECT_EQ(logOf("fault").size(), 7U);
}

TEST_F(RosRobot, refusesCommandsOfOtherQos) {
    start({"--command-qos", "transient-local", "--fault", "silent@1.5+0.5"});
    m_node.write("/arm_controller/joint_trajectory",
                 fast::TypeSupport(new trajectory_msgs::msg::JointTrajectoryPubSubType), {});
    const auto told = [&] {
        const std::string text = textOf(m_folder.filePath("log").toStdString());
        return text.find("\"incompatible\":1") != std::string::npos &&
               text.find("\"active\":[]") != std::string::npos;
    };
    EXPECT_TRUE(eventually(told));
    EXPECT_EQ(logOf("end").size(), 1U);
}
