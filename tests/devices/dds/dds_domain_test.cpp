// SPDX-License-Identifier: GPL-3.0-or-later
// Messages between two processes over the loopback interface. Each test has a domain of its own, so that
// tests beside it are not seen.
#include "backend/core/threads/urgent_thread.h"
#include "backend/ros/node_list.h"
#include "devices/dds/discovery.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"
#include "tests/backend/ros/joint_message.h"
#include "tests/devices/dds/dds_child.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sched.h>
#include <sstream>
#include <string>
#include <thread>

namespace teleta::dds {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kLongest = 20s;
constexpr auto kPeriod = 10ms;

DomainConfig loopback(int domain) {
    return {.domain = domain, .interface = "lo", .peers = {}};
}

template <typename Holds>
bool comesTrue(const Holds& holds) {
    for (const auto end = Clock::now() + kLongest; Clock::now() < end; std::this_thread::sleep_for(kPeriod)) {
        if (holds())
            return true;
    }
    return false;
}

/// Publishes joint states, as a child that is killed.
TEST(DdsChild, DISABLED_publishesJoints) {
    std::istringstream argument(DdsChild::childArgument());
    int domain = 0;
    std::string topic;
    std::string profile;
    ASSERT_TRUE(argument >> domain >> topic >> profile);
    const auto participant = Participant::open(loopback(domain));
    auto writer = Writer<ros::JointState>::open(
        participant.value(), topic, profile == "command" ? ros::kCommandWriter : ros::kSensorWriter);
    for (int i = 1; i < 6000; ++i) {
        ros::JointMessage message{{"a", "b"}, {0.5 * i, -1.0}, {}, {}, {i, 0}};
        (void)writer.value().write(message.message());
        std::this_thread::sleep_for(kPeriod);
    }
}

constexpr const char* kJoints = "DdsChild.DISABLED_publishesJoints";

DdsChild jointPublisher(int domain, const std::string& how) {
    return DdsChild(kJoints, std::to_string(domain) + " " + how);
}

TEST(DdsDomain, theThreadThatReceivesIsUrgentWhereTheUserMayHaveThat) {
    const std::optional<int> priority = core::libraryThreadPriority();
    if (!priority)
        GTEST_SKIP() << "this user may have no real-time priority";
    const auto participant = Participant::open(loopback(96));
    ASSERT_TRUE(participant) << core::describe(participant.error());
    int receiving = 0;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string name;
        std::ifstream(task.path() / "comm") >> name;
        if (!name.starts_with("recv"))
            continue;
        ++receiving;
        const auto thread = static_cast<pid_t>(std::stoi(task.path().filename()));
        sched_param parameters{};
        EXPECT_EQ(sched_getscheduler(thread), SCHED_FIFO) << name;
        EXPECT_EQ(sched_getparam(thread, &parameters), 0);
        EXPECT_EQ(parameters.sched_priority, *priority);
    }
    EXPECT_GE(receiving, 1);
}

TEST(DdsDomain, aMessageArrivesAsItWasSent) {
    constexpr int kDomain = 81;
    const DdsChild child = jointPublisher(kDomain, "rt/joint_states sensor");
    // What the environment says is ignored: this would break everything.
    setenv("CYCLONEDDS_URI",
           "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name=\"none\"/>"
           "</Interfaces></General></Domain></CycloneDDS>",
           1);
    const auto participant = Participant::open(loopback(kDomain));
    ASSERT_TRUE(participant) << core::describe(participant.error());
    auto reader = Reader<ros::JointState>::open(*participant, "rt/joint_states", ros::kSensorReader);
    ASSERT_TRUE(reader);
    WaitSet waitSet(*participant);
    waitSet.attach(*reader);
    std::size_t received = 0;
    std::int32_t last = 0;
    const auto end = Clock::now() + kLongest;
    while (received < 20 && Clock::now() < end) {
        waitSet.wait(100'000'000);
        received += reader->take([&](const ros::JointState& message, const SampleInfo& info) {
            ASSERT_EQ(message.name._length, 2U);
            EXPECT_STREQ(message.name._buffer[1], "b");
            EXPECT_DOUBLE_EQ(message.position._buffer[0], 0.5 * message.header.stamp.sec);
            EXPECT_EQ(message.velocity._length, 0U);
            EXPECT_GT(message.header.stamp.sec, last);
            EXPECT_GT(info.sent_ns, 0);
            last = message.header.stamp.sec;
        });
    }
    EXPECT_GE(received, 20U);
    EXPECT_EQ(reader->matched(), 1U);
    EXPECT_FALSE(reader->incompatible());
    unsetenv("CYCLONEDDS_URI");
}

TEST(DdsDomain, qualitiesThatDoNotMatchAreTold) {
    constexpr int kDomain = 82;
    const DdsChild child = jointPublisher(kDomain, "rt/joint_states sensor");
    const auto participant = Participant::open(loopback(kDomain));
    ASSERT_TRUE(participant);
    const auto reader = Reader<ros::JointState>::open(*participant, "rt/joint_states", ros::kLatchedReader);
    ASSERT_TRUE(reader);
    EXPECT_TRUE(comesTrue([&] { return reader->incompatible() == ros::QosMismatch::reliability; }));
    EXPECT_EQ(reader->matched(), 0U);
}

TEST(DdsDomain, whoIsThereIsFound) {
    constexpr int kDomain = 83;
    const DdsChild child = jointPublisher(kDomain, "rt/arm/joint_states command");
    const auto participant = Participant::open(loopback(kDomain));
    ASSERT_TRUE(participant);
    const auto discovery = Discovery::open(*participant);
    ASSERT_TRUE(discovery);
    ASSERT_TRUE(comesTrue([&] { return !discovery->endsOf("rt/arm/joint_states").empty(); }));
    const FoundEnd end = discovery->endsOf("rt/arm/joint_states").front();
    EXPECT_EQ(end.ddsType, "sensor_msgs::msg::dds_::JointState_");
    EXPECT_TRUE(end.writes);
    EXPECT_FALSE(end.own);
    EXPECT_EQ(end.profile.reliability, ros::Reliability::reliable);
    EXPECT_EQ(end.profile.durability, ros::Durability::volatileData);
    EXPECT_EQ(discovery->otherPrograms(), 1U);
    // Our own ends are told as such.
    const auto writer =
        Writer<ros::JointState>::open(*participant, "rt/arm/joint_states", ros::kCommandWriter);
    ASSERT_TRUE(writer);
    ASSERT_TRUE(comesTrue([&] { return discovery->endsOf("rt/arm/joint_states").size() == 2; }));
    const std::vector<FoundEnd> both = discovery->endsOf("rt/arm/joint_states");
    EXPECT_NE(both[0].own, both[1].own);
}

TEST(DdsDomain, whoIsKilledIsGoneAfterTheLease) {
    constexpr int kDomain = 84;
    auto child = std::make_unique<DdsChild>(kJoints, std::to_string(kDomain) + " rt/joint_states sensor");
    const auto participant = Participant::open(loopback(kDomain));
    ASSERT_TRUE(participant);
    const auto discovery = Discovery::open(*participant);
    ASSERT_TRUE(discovery);
    ASSERT_TRUE(comesTrue([&] { return discovery->otherPrograms() == 1; }));
    child.reset();
    EXPECT_TRUE(comesTrue([&] { return discovery->otherPrograms() == 0; }));
    EXPECT_TRUE(comesTrue([&] { return discovery->endsOf("rt/joint_states").empty(); }));
}

template <typename Message, typename Info>
void publishNodes(int domain, const char* name) {
    const auto participant = Participant::open(loopback(domain));
    auto writer = Writer<Message>::open(participant.value(), ros::kNodesTopic, ros::kLatchedWriter);
    std::array<Info, 1> infos{};
    std::strcpy(infos[0].node_namespace, "/lab");
    std::strcpy(infos[0].node_name, name);
    Message message{};
    message.gid.data[0] = static_cast<std::uint8_t>(name[0]);
    ros::lend(message.node_entities_info_seq, std::span(infos));
    (void)writer.value().write(message);
    std::this_thread::sleep_for(2 * kLongest);
}

TEST(DdsChild, DISABLED_tellsANodeOfHumble) {
    publishNodes<ros::HumbleNodes, ::rmw_dds_common_humble_msg_dds__NodeEntitiesInfo_>(
        std::stoi(DdsChild::childArgument()), "old");
}

TEST(DdsChild, DISABLED_tellsANodeOfJazzy) {
    publishNodes<ros::JazzyNodes, ::rmw_dds_common_jazzy_msg_dds__NodeEntitiesInfo_>(
        std::stoi(DdsChild::childArgument()), "recent");
}

TEST(DdsDomain, nodesOfBothDistributionsAreRead) {
    constexpr int kDomain = 85;
    const DdsChild old("DdsChild.DISABLED_tellsANodeOfHumble", std::to_string(kDomain));
    const DdsChild recent("DdsChild.DISABLED_tellsANodeOfJazzy", std::to_string(kDomain));
    const auto participant = Participant::open(loopback(kDomain));
    ASSERT_TRUE(participant);
    const ros::QosProfile profile = ros::kLatchedReader;
    auto humble = Reader<ros::HumbleNodes>::open(*participant, ros::kNodesTopic, profile.withDepth(8));
    auto jazzy = Reader<ros::JazzyNodes>::open(*participant, ros::kNodesTopic, profile.withDepth(8));
    ASSERT_TRUE(humble) << core::describe(humble.error());
    ASSERT_TRUE(jazzy) << core::describe(jazzy.error());
    std::vector<std::string> names;
    const auto take = [&](const auto& message, const SampleInfo&) {
        if (const auto nodes = ros::nodesOf(message))
            names.push_back(nodes->front().name);
    };
    EXPECT_TRUE(comesTrue([&] {
        (void)humble->take(take);
        (void)jazzy->take(take);
        return names.size() >= 2;
    }));
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"/lab/old", "/lab/recent"}));
}

TEST(DdsDomain, aWrongInterfaceIsNamed) {
    const auto participant = Participant::open({.domain = 86, .interface = "no-such-interface", .peers = {}});
    ASSERT_FALSE(participant);
    EXPECT_EQ(participant.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(core::describe(participant.error()).find("no-such-interface"), std::string::npos)
        << core::describe(participant.error());
}

TEST(DdsDomain, isUsedInOneWayOnly) {
    constexpr int kDomain = 87;
    const auto first = Participant::open(loopback(kDomain));
    ASSERT_TRUE(first);
    EXPECT_TRUE(Participant::open(loopback(kDomain)));
    const auto other = Participant::open({.domain = kDomain, .interface = "lo", .peers = {"127.0.0.2"}});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().kind, core::ErrorKind::refused);
}

TEST(DdsDomain, aWaitEndsWhenItIsTold) {
    const auto participant = Participant::open(loopback(88));
    ASSERT_TRUE(participant);
    WaitSet waitSet(*participant);
    waitSet.wake();
    const auto begin = Clock::now();
    waitSet.wait(std::chrono::nanoseconds(kLongest).count());
    EXPECT_LT(Clock::now() - begin, kLongest);
}

} // namespace
} // namespace teleta::dds
