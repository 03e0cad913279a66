// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/ros_camera_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace teleta::ros_camera {
namespace {

const std::string kShortest = "kind = \"ros_camera\"\nname = \"front\"\ntopic = \"/front/image_raw\"\n";

TEST(RosCameraFile, theShortestFileHasTheDefaults) {
    const auto file = parseRosCamera(kShortest, "front.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->name, "front");
    EXPECT_EQ(file->topic, "/front/image_raw");
    EXPECT_EQ(file->format, PictureFormat::image);
    EXPECT_EQ(file->rate_Hz, 0.0);
    EXPECT_EQ(file->domain, dds::DomainConfig());
}

TEST(RosCameraFile, theEndOfTheTopicTellsTheMessageUnlessTheFileDoes) {
    const std::string compressed =
        "kind = \"ros_camera\"\nname = \"front\"\ntopic = \"/front/image_raw/compressed\"\n";
    const auto guessed = parseRosCamera(compressed, "front.toml");
    ASSERT_TRUE(guessed) << core::describe(guessed.error());
    EXPECT_EQ(guessed->format, PictureFormat::compressedImage);
    const auto told = parseRosCamera(compressed + "format = \"Image\"\n", "front.toml");
    ASSERT_TRUE(told);
    EXPECT_EQ(told->format, PictureFormat::image);
    const auto other = parseRosCamera(kShortest + "format = \"CompressedImage\"\n", "front.toml");
    ASSERT_TRUE(other);
    EXPECT_EQ(other->format, PictureFormat::compressedImage);
}

TEST(RosCameraFile, readsEveryKey) {
    const auto file = parseRosCamera(
        kShortest + "rate_Hz = 30\n[ros]\ndomain = 7\ninterface = \"lo\"\npeers = [\"127.0.0.1\"]\n",
        "front.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->rate_Hz, 30.0);
    EXPECT_EQ(file->domain, (dds::DomainConfig{7, "lo", {"127.0.0.1"}}));
}

TEST(RosCameraFile, saysWhatIsWrongWhere) {
    for (const auto& [line, text] :
         {std::pair{"format = \"Picture\"\n", "CompressedImage"}, std::pair{"rate_Hz = -1\n", "0"},
          std::pair{"rows = 6\n", "rows"}, std::pair{"[ros]\ndomain = 233\n", "232"}}) {
        const auto file = parseRosCamera(kShortest + line, "front.toml");
        ASSERT_FALSE(file) << line;
        EXPECT_NE(core::describe(file.error()).find(text), std::string::npos) << core::describe(file.error());
        EXPECT_GE(file.error().where.line, 4);
    }
    const auto topic =
        parseRosCamera("kind = \"ros_camera\"\nname = \"front\"\ntopic = \"no topic\"\n", "front.toml");
    ASSERT_FALSE(topic);
    EXPECT_EQ(topic.error().where.line, 3);
    EXPECT_FALSE(readRosCamera("/nowhere/front.toml"));
}

TEST(RosCameraFile, theExampleIsRight) {
    const auto file = readRosCamera(TELETA_SOURCE_DIR "/resources/sites/camera.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->format, PictureFormat::compressedImage);
}

} // namespace
} // namespace teleta::ros_camera
