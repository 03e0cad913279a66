// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/ros_names.h"
#include "backend/mcap/recorded/stream_encoder.h"
#include "backend/mcap/ros_schemas.h"
#include "backend/recording/stream_columns.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

using namespace teleta;

namespace {

/// A .msg file as it is installed, without remarks.
std::string installed(const std::string& name) {
    std::istringstream file(test::readAll(TELETA_SOURCE_DIR "/resources/teleta_msgs/msg/" + name + ".msg"));
    std::string text;
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line.front() != '#')
            text += line + "\n";
    }
    return text;
}

} // namespace

TEST(RosSchemas, nestedTypesFollowAfterALineOf80Signs) {
    const std::string rule(80, '=');
    EXPECT_EQ(mcap::schemaText(mcap::rosDefinition("geometry_msgs/WrenchStamped"), "geometry_msgs"),
              "std_msgs/Header header\nWrench wrench\n" + rule +
                  "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + rule +
                  "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + rule +
                  "\nMSG: geometry_msgs/Wrench\nVector3 force\nVector3 torque\n" + rule +
                  "\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n");
    EXPECT_TRUE(mcap::rosDefinition("geometry_msgs/Nothing").empty());
    EXPECT_EQ(mcap::rosDefinition("std_msgs/msg/Header"), mcap::rosDefinition("std_msgs/Header"));
}

TEST(RosSchemas, fieldsAreFoundAmongConstantsAndRemarks) {
    using Fields = std::vector<std::pair<std::string, std::string>>;
    EXPECT_EQ(mcap::schemaFields(
                  "# a remark\nuint8 NONE=0\nuint8 EDGE = 2\n float64 x # in m\r\n\nstring[] name\n" +
                  std::string(80, '=') + "\nMSG: a/B\nuint8 no\n"),
              (Fields{{"float64", "x"}, {"string[]", "name"}}));
}

TEST(RosSchemas, theInstalledMessagesAreThoseOfTheFiles) {
    EXPECT_EQ(installed("TactileArray"), mcap::rosDefinition("teleta_msgs/TactileArray"));
    EXPECT_EQ(installed("Numbers"), mcap::rosDefinition("teleta_msgs/Numbers"));
    EXPECT_EQ(installed("Tactors"), mcap::rosDefinition("teleta_msgs/Tactors"));
    EXPECT_EQ(installed("TactileFeatures"), mcap::featuresDefinition(recording::featureColumns()));
    EXPECT_EQ(installed("Touch"), mcap::touchDefinition(recording::touchColumns()));
    EXPECT_EQ(installed("Contact"), mcap::contactDefinition(recording::contactColumns()));
    EXPECT_EQ(installed("Contacts"), mcap::contactsDefinition());
}

TEST(RosNames, areMadeOfLettersDigitsAndUnderscores) {
    EXPECT_EQ(mcap::topicPart("skin-frames"), "skin_frames");
    EXPECT_EQ(mcap::topicPart("6x14 mat"), "s_6x14_mat");
    EXPECT_EQ(mcap::topicPart("\xc3\xa9"), "__");
    EXPECT_EQ(mcap::topicPart(""), "s_");
}

TEST(RosNames, equalOnesGetNumbersAndFramesFollowTheirSource) {
    using recording::StreamInfo;
    using recording::StreamKind;
    const std::vector<StreamInfo> streams{
        {.name = "a b", .kind = StreamKind::array, .source = "mat", .details = R"({"pitch_m":0.01})"},
        {.name = "a-b", .kind = StreamKind::features, .source = "mat"},
        {.name = "touches", .kind = StreamKind::touches},
        {.name = "eye",
         .kind = StreamKind::camera,
         .source = "eye",
         .details = R"({"camera":{"mirrored":true}})"},
        {.name = "pushes", .kind = StreamKind::contacts, .source = "eye"},
        {.name = "arm-wrench",
         .kind = StreamKind::wrench,
         .source = "arm",
         .details = R"({"frame":"tool0"})"},
        {.name = "wrench", .kind = StreamKind::wrench, .source = "other"}};
    const auto names = mcap::rosNames(streams);
    ASSERT_EQ(names.size(), 7U);
    EXPECT_EQ(names[0].topic, "a_b");
    EXPECT_EQ(names[0].frame, "a_b");
    EXPECT_EQ(names[1].topic, "a_b_2");
    EXPECT_EQ(names[1].frame, "a_b");
    EXPECT_EQ(names[2].frame, "base_link");
    EXPECT_EQ(names[3].frame, "eye_optical_frame");
    EXPECT_FALSE(names[3].turnsY);
    EXPECT_EQ(names[4].frame, "eye");
    EXPECT_TRUE(names[4].turnsY);
    EXPECT_EQ(names[5].frame, "tool0");
    EXPECT_EQ(names[6].frame, "") << "nobody told where it was measured";
}
