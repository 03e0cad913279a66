// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/qos_profile.h"
#include "backend/ros/topic_names.h"

#include <gtest/gtest.h>

namespace teleta::ros {
namespace {

TEST(RosNames, topicsHaveThePrefixOfTheirKind) {
    EXPECT_EQ(ddsTopicOf("/joint_states"), "rt/joint_states");
    EXPECT_EQ(ddsTopicOf("/arm_1/ft/wrench"), "rt/arm_1/ft/wrench");
    EXPECT_EQ(rosTopicOf("rt/arm_1/ft/wrench"), "/arm_1/ft/wrench");
    for (const char* other : {"rq/arm/resetRequest", "rr/arm/resetReply", "ros_discovery_info", "DCPSTopic",
                              "rt", "rt/", "rtt/a", "", "rt/a b"})
        EXPECT_FALSE(rosTopicOf(other)) << other;
}

TEST(RosNames, topicsConsistOfParts) {
    for (const char* good : {"/a", "/a/b_2", "/_hidden", "/A9/z"})
        EXPECT_TRUE(isTopicName(good)) << good;
    for (const char* bad :
         {"", "/", "a", "/a/", "//a", "/a//b", "/9a", "/a/9", "/a-b", "/a b", "/\xc3\xa4", "~/a"})
        EXPECT_FALSE(isTopicName(bad)) << bad;
    EXPECT_TRUE(isTopicName("/" + std::string(252, 'a')));
    EXPECT_FALSE(isTopicName("/" + std::string(253, 'a')));
}

TEST(RosNames, typesAreSpelledAsTheMiddlewareDoes) {
    EXPECT_EQ(ddsTypeOf("sensor_msgs/msg/JointState"), "sensor_msgs::msg::dds_::JointState_");
    EXPECT_EQ(rosTypeOf("sensor_msgs::msg::dds_::JointState_"), "sensor_msgs/msg/JointState");
    for (const char* bad :
         {"JointState", "sensor_msgs/JointState", "/msg/A", "a/msg/", "a/msg/b/c", "a b/msg/C"})
        EXPECT_FALSE(ddsTypeOf(bad)) << bad;
    for (const char* other :
         {"Plain", "a::msg::dds_::", "a::msg::dds_::_", "::msg::dds_::A_", "a::srv::dds_::B_Request_"})
        EXPECT_EQ(rosTypeOf(other), other);
}

TEST(RosQos, aReaderIsRefusedWhatAWriterDoesNotOffer) {
    EXPECT_FALSE(mismatch(kSensorReader, kSensorWriter));
    EXPECT_FALSE(mismatch(kSensorReader, kCommandWriter));
    EXPECT_FALSE(mismatch(kSensorReader, kLatchedWriter));
    EXPECT_FALSE(mismatch(kLatchedReader, kLatchedWriter));
    EXPECT_EQ(mismatch(kCommandWriter, kSensorWriter), QosMismatch::reliability);
    EXPECT_EQ(mismatch(kLatchedReader, kSensorWriter), QosMismatch::reliability);
    EXPECT_EQ(mismatch(kLatchedReader, kCommandWriter), QosMismatch::durability);
    EXPECT_EQ(kSensorReader.withDepth(64).depth, 64);
}

} // namespace
} // namespace teleta::ros
