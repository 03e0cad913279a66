// SPDX-License-Identifier: GPL-3.0-or-later
// The program against publishers of this process, over the loopback interface. Each test has a domain of its
// own.
#include "backend/ros/node_list.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "tests/app/cli/program_run.h"
#include "tests/backend/ros/joint_message.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>

namespace teleta::dds {
namespace {

using nlohmann::json;
using test::ProgramResult;

std::shared_ptr<const Participant> join(int domain) {
    return Participant::open({.domain = domain, .interface = "lo", .peers = {}}).value();
}

ProgramResult runRos(std::vector<std::string> arguments, int domain) {
    arguments.insert(arguments.begin(), "ros");
    for (const char* argument : {"--interface", "lo", "--domain"})
        arguments.emplace_back(argument);
    arguments.push_back(std::to_string(domain));
    return test::run(arguments);
}

bool comesToWrite(const test::RunningProgram& program, std::string_view text) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::seconds(30); Clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
        if (program.hasWritten(text))
            return true;
    }
    return false;
}

/// Publishes joint states every 10 ms while it lives.
class JointPublisher {
public:
    JointPublisher(std::shared_ptr<const Participant> participant, const char* topic)
        : m_writer(Writer<ros::JointState>::open(std::move(participant), topic, ros::kSensorWriter).value())
        , m_thread([this](const std::stop_token& stop) {
            for (int i = 1; !stop.stop_requested(); ++i) {
                ros::JointMessage message{{"elbow", "wrist\x1b[2J"}, {0.25, i + 0.0}, {}, {}, {i, 0}};
                (void)m_writer.write(message.message());
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
        }) {}

private:
    Writer<ros::JointState> m_writer;
    std::jthread m_thread;
};

TEST(RosCommand, listsTopics) {
    constexpr int kDomain = 91;
    const auto participant = join(kDomain);
    const auto states =
        Writer<ros::JointState>::open(participant, "rt/joint_states", ros::kSensorWriter).value();
    const auto more =
        Writer<ros::JointState>::open(participant, "rt/joint_states", ros::kCommandWriter).value();
    const auto description =
        Writer<ros::String>::open(participant, "rt/robot_description", ros::kLatchedWriter).value();
    const auto commands =
        Reader<ros::JointTrajectory>::open(participant, "rt/arm/joint_trajectory", ros::kSensorReader)
            .value();
    const auto service =
        Writer<ros::String>::open(participant, "rq/resetRequest", ros::kCommandWriter).value();
    const ProgramResult result = runRos({"topics", "--json"}, kDomain);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(json::parse(result.out), json::parse(R"([
        {"topic": "/arm/joint_trajectory", "type": "trajectory_msgs/msg/JointTrajectory", "publishers": 0,
         "subscribers": 1, "reliability": null, "durability": null},
        {"topic": "/joint_states", "type": "sensor_msgs/msg/JointState", "publishers": 2, "subscribers": 0,
         "reliability": "mixed", "durability": "volatile"},
        {"topic": "/robot_description", "type": "std_msgs/msg/String", "publishers": 1, "subscribers": 0,
         "reliability": "reliable", "durability": "transient_local"}])"))
        << result.out;
    EXPECT_EQ(result.err, "");
}

TEST(RosCommand, saysWhenNobodyIsThere) {
    const ProgramResult result = runRos({"topics", "--json"}, 92);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(json::parse(result.out), json::array());
    EXPECT_NE(result.err.find("no program of domain 92"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("--peer"), std::string::npos) << result.err;
}

TEST(RosCommand, takesTheDomainOfTheEnvironment) {
    test::ProgramSettings settings;
    settings.environment = {{"ROS_DOMAIN_ID", "93"}};
    const ProgramResult result = test::run({"ros", "topics", "--interface", "lo"}, settings);
    EXPECT_NE(result.err.find("no program of domain 93"), std::string::npos) << result.err;
    settings.environment = {{"ROS_DOMAIN_ID", "x"}};
    const ProgramResult wrong = test::run({"ros", "topics", "--interface", "lo"}, settings);
    EXPECT_EQ(wrong.exitCode, 3);
    EXPECT_NE(wrong.err.find("ROS_DOMAIN_ID"), std::string::npos) << wrong.err;
}

TEST(RosCommand, listsNodes) {
    constexpr int kDomain = 94;
    const auto participant = join(kDomain);
    auto writer = Writer<ros::JazzyNodes>::open(participant, ros::kNodesTopic, ros::kLatchedWriter).value();
    std::array<::rmw_dds_common_jazzy_msg_dds__Gid_, 2> gids{};
    std::array<::rmw_dds_common_jazzy_msg_dds__NodeEntitiesInfo_, 2> infos{};
    std::strcpy(infos[0].node_namespace, "/lab");
    std::strcpy(infos[0].node_name, "driver");
    ros::lend(infos[0].writer_gid_seq, std::span(gids));
    std::strcpy(infos[1].node_namespace, "/");
    std::strcpy(infos[1].node_name, "camera");
    ros::JazzyNodes message{};
    ros::lend(message.node_entities_info_seq, std::span(infos));
    ASSERT_TRUE(writer.write(message));
    const ProgramResult result = runRos({"nodes", "--json"}, kDomain);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(json::parse(result.out), json::parse(R"([{"node": "/camera", "publishers": 0, "subscribers": 0},
                              {"node": "/lab/driver", "publishers": 2, "subscribers": 0}])"))
        << result.out;
    EXPECT_EQ(result.err, "");
}

TEST(RosCommand, printsMessages) {
    constexpr int kDomain = 95;
    const JointPublisher publisher(join(kDomain), "rt/joint_states");
    const ProgramResult asJson = runRos({"echo", "/joint_states", "--count", "3", "--json"}, kDomain);
    ASSERT_EQ(asJson.exitCode, 0) << asJson.err;
    const json messages = json::parse(asJson.out);
    ASSERT_EQ(messages.size(), 3U);
    for (const json& message : messages) {
        EXPECT_EQ(message["name"][0], "elbow");
        EXPECT_EQ(message["position"][1], message["header"]["stamp"]["sec"]);
    }
    const ProgramResult asText = runRos({"echo", "joint_states", "--count", "1"}, kDomain);
    ASSERT_EQ(asText.exitCode, 0) << asText.err;
    EXPECT_NE(asText.out.find("name: [\"elbow\", \"wrist\\x1b[2J\"]\nposition: [0.25, "), std::string::npos)
        << asText.out;
    EXPECT_TRUE(asText.out.ends_with("effort: []\n---\n")) << asText.out;
}

TEST(RosCommand, whatWasSaidBeforeIsPrintedAsWell) {
    constexpr int kDomain = 96;
    auto writer =
        Writer<ros::String>::open(join(kDomain), "rt/robot_description", ros::kLatchedWriter).value();
    std::string text = "<robot name=\"r\"/>";
    ASSERT_TRUE(writer.write({text.data()}));
    const ProgramResult result = runRos({"echo", "/robot_description", "--count", "1", "--json"}, kDomain);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(json::parse(result.out)[0]["data"], text);
}

TEST(RosCommand, anInterruptionCompletesTheDocument) {
    constexpr int kDomain = 97;
    const JointPublisher publisher(join(kDomain), "rt/joint_states");
    test::RunningProgram program(
        {"ros", "echo", "/joint_states", "--json", "--interface", "lo", "--domain", std::to_string(kDomain)});
    ASSERT_TRUE(comesToWrite(program, "wrist"));
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_TRUE(json::accept(result.out)) << result.out;
}

TEST(RosCommand, saysWhenNothingIsSent) {
    constexpr int kDomain = 99;
    const auto silent =
        Writer<ros::JointState>::open(join(kDomain), "rt/joint_states", ros::kSensorWriter).value();
    test::RunningProgram program(
        {"ros", "echo", "/joint_states", "--interface", "lo", "--domain", std::to_string(kDomain)});
    ASSERT_TRUE(comesToWrite(program, "nothing was sent on /joint_states within 5 s"));
    program.send(SIGTERM);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.out, "");
}

TEST(RosCommand, saysWhatCannotBePrinted) {
    constexpr int kDomain = 98;
    const ProgramResult nobody = runRos({"echo", "/no_such_topic"}, kDomain);
    EXPECT_EQ(nobody.exitCode, 1);
    EXPECT_NE(nobody.err.find("nobody published /no_such_topic in domain 98 within 5 s"), std::string::npos)
        << nobody.err;
    // A message of ROS that is not one of those that are sent alone.
    const auto participant = join(kDomain);
    const auto writer =
        AnyWriter::open(participant, "rt/time", ::builtin_interfaces_msg_dds__Time__desc, ros::kSensorWriter)
            .value();
    const ProgramResult unknown = runRos({"echo", "/time"}, kDomain);
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_NE(unknown.err.find("builtin_interfaces/msg/Time"), std::string::npos) << unknown.err;
    EXPECT_NE(unknown.err.find("sensor_msgs/msg/JointState"), std::string::npos) << unknown.err;
    EXPECT_EQ(runRos({"echo", "/a//b"}, kDomain).exitCode, 2);
    EXPECT_EQ(test::run({"ros", "topics", "--domain", "233"}).exitCode, 2);
    const ProgramResult wrong = test::run({"ros", "topics", "--interface", "no-such-interface"});
    EXPECT_EQ(wrong.exitCode, 1);
    EXPECT_NE(wrong.err.find("no-such-interface"), std::string::npos) << wrong.err;
}

} // namespace
} // namespace teleta::dds
