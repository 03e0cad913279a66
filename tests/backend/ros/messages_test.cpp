// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/message_json.h"
#include "backend/ros/node_list.h"
#include "backend/ros/stamps.h"
#include "backend/ros/topic_names.h"
#include "tests/backend/ros/joint_message.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>

namespace teleta::ros {
namespace {

TEST(RosMessages, areFoundByTheirNames) {
    EXPECT_TRUE(std::ranges::is_sorted(messageTypes(), {}, &MessageType::name));
    for (const MessageType& type : messageTypes()) {
        EXPECT_EQ(findMessageType(type.name), &type);
        EXPECT_EQ(type.descriptor->m_typename, ddsTypeOf(type.name));
    }
    EXPECT_EQ(findMessageType("std_msgs/msg/Int8"), nullptr);
    EXPECT_EQ(&descriptorOf<JointState>(), findMessageType("sensor_msgs/msg/JointState")->descriptor);
    EXPECT_STREQ(descriptorOf<HumbleNodes>().m_typename, descriptorOf<JazzyNodes>().m_typename);
}

TEST(RosMessages, areShownInTheWordsOfTheirDefinition) {
    JointMessage message{{"a", "b"}, {1.0, -2.5}, {}, {3.0, 4.0}, {12, 5}};
    EXPECT_EQ(messageJson(message.message()).dump(),
              R"({"header":{"stamp":{"sec":12,"nanosec":5},"frame_id":""},"name":["a","b"],)"
              R"("position":[1.0,-2.5],"velocity":[],"effort":[3.0,4.0]})");
    const MessageType* type = findMessageType("sensor_msgs/msg/JointState");
    EXPECT_EQ(type->json(&message.message()), messageJson(message.message()));
}

TEST(RosMessages, aTrajectoryShowsItsPoints) {
    std::array<double, 1> positions{0.25};
    std::array<JointTrajectoryPoint, 1> points{};
    lend(points[0].positions, std::span(positions));
    points[0].time_from_start = {0, 40'000'000};
    JointTrajectory message{};
    lend(message.points, std::span(points));
    EXPECT_EQ(messageJson(message)["points"].dump(),
              R"([{"positions":[0.25],"velocities":[],"accelerations":[],"effort":[],)"
              R"("time_from_start":{"sec":0,"nanosec":40000000}}])");
}

TEST(RosMessages, picturesAreShownBySize) {
    std::array<std::uint8_t, 6> bytes{};
    Image image{};
    lend(image.data, std::span(bytes));
    EXPECT_EQ(messageJson(image)["data_bytes"], 6);
    EXPECT_FALSE(messageJson(image).contains("data"));
}

TEST(RosStamps, keepNanoseconds) {
    EXPECT_EQ(nanoseconds({2'000'000'000, 999'999'999}), 2'000'000'000'999'999'999);
    EXPECT_EQ(nanoseconds({-1, 999'999'999}), -1);
    EXPECT_DOUBLE_EQ(seconds({3, 250'000'000}), 3.25);
}

template <typename Message, typename Infos>
Message nodesMessage(Infos infos) {
    Message message{};
    lend(message.node_entities_info_seq, infos);
    return message;
}

TEST(RosNodes, areNamedWithTheirNamespaces) {
    using Info = ::rmw_dds_common_jazzy_msg_dds__NodeEntitiesInfo_;
    std::array<::rmw_dds_common_jazzy_msg_dds__Gid_, 3> gids{};
    std::array<Info, 2> infos{};
    std::strcpy(infos[0].node_namespace, "/");
    std::strcpy(infos[0].node_name, "driver");
    std::strcpy(infos[1].node_namespace, "/left/arm");
    std::strcpy(infos[1].node_name, "planner");
    lend(infos[1].reader_gid_seq, std::span(gids));
    lend(infos[1].writer_gid_seq, std::span(gids).first(1));
    const auto nodes = nodesOf(nodesMessage<JazzyNodes>(std::span(infos)));
    ASSERT_TRUE(nodes);
    EXPECT_EQ(*nodes, (std::vector<Node>{{"/driver", 0, 0}, {"/left/arm/planner", 3, 1}}));
}

TEST(RosNodes, ofAnotherDistributionAreNotMadeUp) {
    using Info = ::rmw_dds_common_humble_msg_dds__NodeEntitiesInfo_;
    EXPECT_FALSE(nodesOf(HumbleNodes{}));
    for (const auto& [space, name] : {std::pair{"", "node"}, {"/", ""}, {"/", "a/b"}, {"nonsense", "node"}}) {
        std::array<Info, 1> infos{};
        std::strcpy(infos[0].node_namespace, space);
        std::strcpy(infos[0].node_name, name);
        EXPECT_FALSE(nodesOf(nodesMessage<HumbleNodes>(std::span(infos)))) << space << name;
    }
}

} // namespace
} // namespace teleta::ros
