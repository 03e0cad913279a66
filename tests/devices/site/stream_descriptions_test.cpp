// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/taxel_places.h"
#include "devices/site/stream_descriptions.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::site_link {
namespace {

TEST(StreamDescriptions, areReadAsTheyWereWritten) {
    recording::StreamInfo array;
    array.name = "pad-frames";
    array.kind = recording::StreamKind::array;
    array.source = "Pad \"1\"";
    array.shape = {14, 6};
    array.unit = "counts";
    array.nominalRate_Hz = 200.0;
    array.details = R"({"pitch_m": 0.0034})";
    recording::StreamInfo joints;
    joints.name = "arm-joints";
    joints.kind = recording::StreamKind::joints;
    joints.type = recording::ValueType::float64;
    joints.shape = {6};
    joints.columns = {{"angle_1", "rad"}, {"angle_2", "rad"}};

    const auto read = readStreams(describeStreams({array, joints}), "lab");
    ASSERT_TRUE(read) << core::describe(read.error());
    ASSERT_EQ(read->size(), 2U);
    const recording::StreamInfo& first = (*read)[0];
    EXPECT_EQ(first.name, array.name);
    EXPECT_EQ(first.kind, array.kind);
    EXPECT_EQ(first.type, array.type);
    EXPECT_EQ(first.source, array.source);
    EXPECT_EQ(first.shape, array.shape);
    EXPECT_EQ(first.unit, array.unit);
    EXPECT_EQ(first.nominalRate_Hz, array.nominalRate_Hz);
    EXPECT_EQ(first.details, array.details);
    const recording::StreamInfo& second = (*read)[1];
    EXPECT_EQ(second.kind, joints.kind);
    EXPECT_EQ(second.type, joints.type);
    ASSERT_EQ(second.columns.size(), 2U);
    EXPECT_EQ(second.columns[1].name, "angle_2");
    EXPECT_EQ(second.columns[1].unit, "rad");
    EXPECT_TRUE(readStreams(describeStreams({}), "lab")->empty());
}

TEST(StreamDescriptions, haveRoomForTheLargestArrayWithThreeComponents) {
    recording::StreamInfo array;
    array.name = "skin-frames";
    array.kind = recording::StreamKind::array;
    array.shape = {core::TaxelPlaces::kMost, 3};
    for (std::size_t column = 0; column < 3 * core::TaxelPlaces::kMost; ++column)
        array.columns.push_back({"c" + std::to_string(column), "N"});
    const auto read = readStreams(describeStreams({array}), "lab");
    ASSERT_TRUE(read) << core::describe(read.error());
    EXPECT_EQ(read->front().columns.size(), array.columns.size());
    array.columns.push_back({"more", "N"});
    EXPECT_FALSE(readStreams(describeStreams({array}), "lab"));
}

TEST(StreamDescriptions, tellTheFrameOfTheValues) {
    using recording::StreamKind;
    std::vector<recording::StreamInfo> all(4);
    all[0].name = "arm-joints";
    all[0].kind = StreamKind::joints;
    all[0].details = R"({"base_link": "base", "skin_stream": "pad-frames", "pad": {"link": "forearm"}})";
    all[1].name = "pad-frames";
    all[1].kind = StreamKind::array;
    all[2].name = "arm-wrench";
    all[2].kind = StreamKind::wrench;
    all[2].details = R"({"frame": "tool0"})";
    all[3].name = "mat-frames";
    all[3].kind = StreamKind::array;
    all[3].details = "no JSON";
    EXPECT_EQ(frameOf(all[0], all), "base");
    EXPECT_EQ(frameOf(all[1], all), "forearm");
    EXPECT_EQ(frameOf(all[2], all), "tool0");
    EXPECT_EQ(frameOf(all[3], all), "");
    all[0].details = "[]";
    EXPECT_EQ(frameOf(all[0], all), "");
    EXPECT_EQ(frameOf(all[1], all), "");
}

TEST(StreamDescriptions, streamsOfANewerSiteAreLeftOut) {
    const auto read = readStreams(
        R"({"streams": [
            {"name": "a", "kind": "smell", "type": "float32", "shape": [1], "columns": [], "rate_hz": 1},
            {"name": "b", "kind": "array", "type": "float128", "shape": [1], "columns": [], "rate_hz": 1},
            {"name": "c", "kind": "array", "type": "float32", "shape": [1], "columns": [], "rate_hz": 1}]})",
        "lab");
    ASSERT_TRUE(read) << core::describe(read.error());
    ASSERT_EQ(read->size(), 1U);
    EXPECT_EQ(read->front().name, "c");
}

TEST(StreamDescriptions, whatIsNoDescriptionIsRefused) {
    for (
        const char* text :
        {"", "[]", "{}", R"({"streams": 1})", R"({"streams": [1]})",
         R"({"streams": [{"name": "a", "kind": "array", "type": "float32", "shape": [-1], "columns": [], "rate_hz": 1}]})",
         R"({"streams": [{"name": "a", "kind": "array", "type": "float32", "shape": [1], "columns": [], "rate_hz": -1}]})"}) {
        const auto read = readStreams(text, "lab");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().where.file, "lab") << text;
    }
}

} // namespace
} // namespace teleta::site_link
