// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "devices/site/site_streams.h"
#include "devices/site/site_topics.h"

#include <gtest/gtest.h>

namespace teleta::site_link {
namespace {

TEST(SiteTopics, areNamedAsTheProtocolSays) {
    const SiteTopics topics("lab");
    EXPECT_EQ(topics.state(), "rt/teleta/lab/state");
    EXPECT_EQ(topics.joints("left_arm"), "rt/teleta/lab/joints/left_arm");
    EXPECT_EQ(topics.temperatures("skin"), "rt/teleta/lab/temperatures/skin");
    EXPECT_EQ(topics.command("console1"), "rt/teleta/lab/console/console1/command");
    EXPECT_EQ(topics.clockAnswer("console1"), "rt/teleta/lab/console/console1/clock_answer");
}

TEST(SiteTopics, aConsoleIsFoundByItsPresence) {
    const SiteTopics topics("lab");
    EXPECT_EQ(topics.consoleOf(topics.presence("console1")), "console1");
    for (const char* other : {"rt/teleta/lab/console/console1/command", "rt/teleta/lab2/console/a/presence",
                              "rt/teleta/lab/console//presence", "rt/teleta/lab/console/presence",
                              "rt/teleta/lab/console/A/presence", "rt/teleta/lab/console/a/b/presence", ""})
        EXPECT_FALSE(topics.consoleOf(other)) << other;
}

TEST(SiteTopics, aSiteIsFoundByWhatItTellsOfItself) {
    EXPECT_EQ(siteOfInfo("rt/teleta/lab/info"), "lab");
    for (const char* other : {"rt/teleta/lab/state", "rt/teleta//info", "rt/teleta/info", "rt/lab/info"})
        EXPECT_FALSE(siteOfInfo(other)) << other;
}

TEST(SiteTopics, namesAreShortAndSmall) {
    EXPECT_TRUE(isSiteName("a"));
    EXPECT_TRUE(isSiteName("left_arm2"));
    EXPECT_TRUE(isSiteName(std::string(31, 'a')));
    for (const std::string& bad : {std::string(), std::string("2a"), std::string("_a"), std::string("a-b"),
                                   std::string("A"), std::string("a b"), std::string(32, 'a')})
        EXPECT_FALSE(isSiteName(bad)) << bad;
}

TEST(SiteTopics, temperaturesAreSentAndNoOtherNumbers) {
    const SiteTopics topics("lab");
    recording::StreamInfo stream;
    stream.kind = recording::StreamKind::numbers;
    stream.name = "skin-temperatures";
    EXPECT_EQ(deviceOf(stream), "skin");
    EXPECT_STREQ(topicOf(stream, topics).kind, "temperatures");
    EXPECT_EQ(topicOf(stream, topics).name, topics.temperatures("skin"));
    for (const char* other : {"skin-loads", "skin-features", "-temperatures", "Skin-temperatures"}) {
        stream.name = other;
        EXPECT_EQ(deviceOf(stream), "") << other;
    }
}

TEST(SiteTopics, aGelIsSentWithItsRestAndATubeIsNot) {
    const SiteTopics topics("lab");
    const core::CameraDescription camera{.name = "finger", .nominalRate_Hz = 25.0};
    vision::MarkerGelFile file;
    file.plane.mmPerPx = 0.1;
    const auto pictures = pipeline::gelStream("finger-camera", camera, file, "finger-reference");
    EXPECT_EQ(deviceOf(pictures), "finger");
    EXPECT_STREQ(topicOf(pictures, topics).kind, "image");
    EXPECT_EQ(topicOf(pictures, topics).name, "rt/teleta/lab/image/finger");
    EXPECT_GT(topicOf(pictures, topics).profile.depth, 1) << "each picture is followed";
    const auto rest = pipeline::gelReferenceStream("finger-reference", camera);
    EXPECT_EQ(deviceOf(rest), "finger");
    EXPECT_STREQ(topicOf(rest, topics).kind, "rest");
    EXPECT_EQ(topicOf(rest, topics).name, "rt/teleta/lab/rest/finger");
    EXPECT_EQ(topicOf(rest, topics).profile.durability, ros::Durability::transientLocal);
    EXPECT_EQ(deviceOf(pipeline::gelContactStream("finger-contacts", camera)), "");
    EXPECT_EQ(deviceOf(pipeline::referenceStream("tube-reference", camera)), "");
    recording::StreamInfo tube = pictures;
    tube.details = "{\"camera\": {}}";
    EXPECT_EQ(deviceOf(tube), "");
    tube.details = "no JSON";
    EXPECT_EQ(deviceOf(tube), "");
}

} // namespace
} // namespace teleta::site_link
