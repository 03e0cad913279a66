// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/cdr_reader.h"
#include "backend/mcap/recorded/stream_encoder.h"
#include "backend/mcap/ros_schemas.h"
#include "backend/recording/stream_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace teleta::mcap {
namespace {

using recording::StreamInfo;
using recording::StreamKind;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

template <typename Number>
core::TappedFrames oneFrame(const std::vector<Number>& values) {
    core::TappedFrames frames;
    frames.time_ns = {5};
    frames.sourceTime_s = {0.0};
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    frames.values.assign(bytes, bytes + values.size() * sizeof(Number));
    return frames;
}

struct Cloud {
    std::vector<std::string> fields;
    std::vector<float> points;
    bool isDense = false;
};

/// Reads the message as ROS defines it.
Cloud cloudOf(const StreamInfo& stream, const std::vector<float>& values) {
    const StreamEncoder encoder(stream, {.topic = "pad", .frame = "pad"}, 1);
    Cloud cloud;
    EXPECT_EQ(encoder.topics().size(), 1U);
    if (encoder.topics().size() != 1)
        return cloud;
    EXPECT_EQ(encoder.topics()[0].topic, "/pad/points");
    std::string bytes;
    encoder.encode(0, oneFrame(values), 0, 1, 1'000'000'002, bytes);
    CdrReader cdr(bytes);
    EXPECT_EQ(cdr.number<std::int32_t>(), 1);
    EXPECT_EQ(cdr.number<std::uint32_t>(), 2U);
    EXPECT_EQ(cdr.text(), "pad");
    EXPECT_EQ(cdr.number<std::uint32_t>(), 1U) << "height";
    const auto width = cdr.number<std::uint32_t>();
    const auto fields = cdr.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < fields; ++i) {
        cloud.fields.emplace_back(cdr.text());
        EXPECT_EQ(cdr.number<std::uint32_t>(), 4 * i);
        EXPECT_EQ(cdr.number<std::uint8_t>(), 7) << "FLOAT32";
        EXPECT_EQ(cdr.number<std::uint32_t>(), 1U);
    }
    EXPECT_EQ(cdr.number<std::uint8_t>(), 0) << "little-endian";
    EXPECT_EQ(cdr.number<std::uint32_t>(), 4 * fields);
    EXPECT_EQ(cdr.number<std::uint32_t>(), 4 * fields * width);
    const std::string_view data = cdr.byteSequence();
    cloud.points.resize(data.size() / sizeof(float));
    std::memcpy(cloud.points.data(), data.data(), cloud.points.size() * sizeof(float));
    cloud.isDense = cdr.number<std::uint8_t>() != 0;
    EXPECT_FALSE(cdr.failed());
    EXPECT_EQ(cloud.points.size(), std::size_t{width} * fields);
    return cloud;
}

TEST(PointCloud, hasAPointWithItsForceForEachTaxelOfVectors) {
    StreamInfo stream{.name = "pad-frames", .shape = {3, 3}};
    stream.details =
        R"({"components": 3, "rows": 1, "columns": 3, "pitch_x_m": 0.004, "pitch_y_m": 0.01, "mask": [1]})";
    const Cloud cloud = cloudOf(stream, {1, 2, -3, kNaN, kNaN, kNaN, 4, 5, -6});
    EXPECT_EQ(cloud.fields, (std::vector<std::string>{"x", "y", "z", "force_x", "force_y", "force_z"}));
    EXPECT_EQ(cloud.points, (std::vector<float>{-0.004F, 0, 0, 1, 2, -3, 0.004F, 0, 0, 4, 5, -6}))
        << "the place without a taxel has none";
    EXPECT_TRUE(cloud.isDense);
}

TEST(PointCloud, hasTheLoadsOfTaxelsOffAGrid) {
    StreamInfo stream{.name = "pad-frames", .shape = {2}};
    stream.details = R"({"positions_m": [[0.001, 0.002, 0.003], [-0.001, 0, 0]]})";
    const Cloud cloud = cloudOf(stream, {7, kNaN});
    EXPECT_EQ(cloud.fields, (std::vector<std::string>{"x", "y", "z", "value"}));
    ASSERT_EQ(cloud.points.size(), 8U);
    EXPECT_EQ(cloud.points[2], 0.003F);
    EXPECT_EQ(cloud.points[3], 7.0F);
    EXPECT_TRUE(std::isnan(cloud.points[7])) << "a dead taxel";
    EXPECT_FALSE(cloud.isDense);
}

TEST(PointCloud, isDescribedForReadersWithoutRos) {
    const std::string text = schemaText(rosDefinition("sensor_msgs/PointCloud2"), "sensor_msgs");
    EXPECT_NE(text.find("MSG: sensor_msgs/PointField\n"), std::string::npos);
    EXPECT_NE(text.find("MSG: std_msgs/Header\n"), std::string::npos);
    EXPECT_NE(text.find("MSG: builtin_interfaces/Time\n"), std::string::npos);
}

TEST(PointCloud, theWrenchOfVectorsHasTheirShearAtTheOrigin) {
    StreamInfo stream{.name = "pad-features",
                      .kind = StreamKind::features,
                      .type = recording::ValueType::float64,
                      .columns = recording::featureColumns("N", true)};
    stream.shape = {stream.columns.size()};
    std::vector<double> values(stream.columns.size(), std::nan(""));
    values[0] = 1.0;
    values[1] = 4.0;   // force
    values[2] = 0.010; // CoP
    values[3] = -0.020;
    values[12] = 1.0; // shear
    values[13] = 2.0;
    values[14] = 0.5; // at the CoP
    const StreamEncoder encoder(stream, {.topic = "pad", .frame = "pad"}, 1);
    ASSERT_EQ(encoder.topics().size(), 2U);
    std::string bytes;
    encoder.encode(1, oneFrame(values), 0, 1, 0, bytes);
    CdrReader cdr(bytes);
    (void)cdr.number<std::int32_t>();
    (void)cdr.number<std::uint32_t>();
    (void)cdr.text();
    const std::vector<double> expected{1.0,           2.0,         -4.0,
                                       -4.0 * -0.020, 4.0 * 0.010, 0.5 + 0.010 * 2.0 - -0.020 * 1.0};
    for (const double number : expected)
        EXPECT_DOUBLE_EQ(cdr.number<double>(), number);
}

TEST(PointCloud, gridsOfLoadsStayImages) {
    StreamInfo stream{.name = "pad-frames", .shape = {2, 3}};
    stream.details = R"({"pitch_m": 0.004})";
    const StreamEncoder encoder(stream, {.topic = "pad", .frame = "pad"}, 1);
    ASSERT_EQ(encoder.topics().size(), 2U);
    EXPECT_EQ(encoder.topics()[0].topic, "/pad/image");
}

TEST(PointCloud, aGridWithTwoPitchesIsNoImage) {
    StreamInfo stream{.name = "pad-frames", .shape = {2, 3}};
    stream.details = R"({"pitch_x_m": 0.004, "pitch_y_m": 0.010})";
    const StreamEncoder encoder(stream, {.topic = "pad", .frame = "pad"}, 1);
    ASSERT_EQ(encoder.topics().size(), 1U);
    EXPECT_EQ(encoder.topics()[0].topic, "/pad/points");
}

TEST(FeatureMessages, eachDefinitionHasANameOfItsOwn) {
    const auto nameOf = [](const std::string& unit, bool vectors) {
        StreamInfo stream{.name = "pad-features",
                          .kind = recording::StreamKind::features,
                          .type = recording::ValueType::float64,
                          .columns = recording::featureColumns(unit, vectors)};
        stream.shape = {static_cast<std::uint32_t>(stream.columns.size())};
        const StreamEncoder encoder(stream, {.topic = "pad", .frame = "pad"}, 1);
        return encoder.topics().empty() ? std::string() : encoder.topics()[0].schemaName;
    };
    // The first is that of the package teleta_msgs.
    EXPECT_EQ(nameOf("N", false), "teleta_msgs/msg/TactileFeatures");
    EXPECT_EQ(nameOf("N", true), "teleta_msgs/msg/TactileFeaturesShear");
    EXPECT_EQ(nameOf("uT", false), "teleta_msgs/msg/TactileFeaturesUt");
    EXPECT_EQ(nameOf("uT", true), "teleta_msgs/msg/TactileFeaturesUtShear");
}

} // namespace
} // namespace teleta::mcap
