// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/array/array_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace teleta::ros_array {
namespace {

RosArrayFile fileOf(int rows, int columns) {
    RosArrayFile file;
    file.layout = {rows, columns, 1e-3};
    return file;
}

/// The loads, or why the message is no frame.
template <typename Message>
std::vector<float> loads(const Message& message, const RosArrayFile& file) {
    std::vector<float> found(file.layout.taxels(), -1.0F);
    const auto isFrame = loadsOf(message, file, found);
    EXPECT_TRUE(isFrame) << core::describe(isFrame.error());
    EXPECT_TRUE(isFrame.value_or(false));
    return found;
}

template <typename Message>
std::string misfit(const Message& message, const RosArrayFile& file) {
    std::vector<float> found(file.layout.taxels(), -1.0F);
    const auto isFrame = loadsOf(message, file, found);
    EXPECT_EQ(found, std::vector<float>(found.size(), -1.0F)) << "unchanged";
    return isFrame ? std::string() : isFrame.error().message;
}

struct Numbers {
    explicit Numbers(std::vector<double> given, std::vector<std::uint32_t> sizes = {},
                     std::uint32_t offset = 0)
        : data(std::move(given)) {
        for (const std::uint32_t size : sizes) {
            dimensions.push_back({});
            dimensions.back().size = size;
        }
        ros::lend(message.data, std::span(data));
        ros::lend(message.layout.dim, std::span(dimensions));
        message.layout.data_offset = offset;
    }
    std::vector<double> data;
    std::vector<std::remove_pointer_t<decltype(ros::Float64MultiArray{}.layout.dim._buffer)>> dimensions;
    ros::Float64MultiArray message{};
};

struct Picture {
    Picture(std::string name, std::uint32_t rows, std::uint32_t columns, std::uint32_t step,
            std::vector<std::uint8_t> given, bool isBig = false)
        : encoding(std::move(name))
        , data(std::move(given)) {
        message.encoding = encoding.data();
        message.height = rows;
        message.width = columns;
        message.step = step;
        message.is_bigendian = isBig ? 1 : 0;
        ros::lend(message.data, std::span(data));
    }
    std::string encoding;
    std::vector<std::uint8_t> data;
    ros::Image message{};
};

TEST(ArrayMessage, readsNumbersRowByRow) {
    EXPECT_EQ(loads(Numbers({1, 2, 3, 4, 5, 6}, {2, 3}).message, fileOf(2, 3)),
              (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(loads(Numbers({1, 2}).message, fileOf(1, 2)), (std::vector<float>{1, 2})) << "no dimensions";
    EXPECT_EQ(loads(Numbers({9, 9, 1, 2}, {1, 2}, 2).message, fileOf(1, 2)), (std::vector<float>{1, 2}));
    RosArrayFile scaled = fileOf(1, 2);
    scaled.scale = -0.5;
    for (const double number :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        const auto found = loads(Numbers({4, number}).message, scaled);
        EXPECT_EQ(found[0], -2.0F);
        EXPECT_TRUE(std::isnan(found[1])) << number;
    }
}

TEST(ArrayMessage, saysInWhatNumbersDoNotFit) {
    EXPECT_EQ(misfit(Numbers({1, 2, 3}).message, fileOf(2, 2)),
              "a message has 3 numbers, the file has 2 x 2 taxels");
    EXPECT_EQ(misfit(Numbers({1, 2, 3, 4}, {1, 4}).message, fileOf(2, 2)),
              "a message has 1 x 4 numbers, the file has 2 x 2 taxels");
    EXPECT_EQ(misfit(Numbers({1, 2, 3, 4}, {2, 2, 1}).message, fileOf(2, 2)), "a message has 3 dimensions");
    EXPECT_NE(misfit(Numbers({1, 2, 3, 4}, {2, 2}, 9).message, fileOf(2, 2)), "");
    EXPECT_NE(misfit(Numbers({}, {0, 0}).message, fileOf(1, 1)), "");
}

TEST(ArrayMessage, takesTheNamedSensorOfAState) {
    std::string palm = "palm", thumb = "thumb";
    std::vector<float> palmValues{1, 2}, thumbValues{3, 4, 5};
    using Sensor = std::remove_pointer_t<decltype(ros::TactileState{}.sensors._buffer)>;
    std::vector<Sensor> sensors(2);
    sensors[0].name = thumb.data();
    ros::lend(sensors[0].values, std::span(thumbValues));
    sensors[1].name = palm.data();
    ros::lend(sensors[1].values, std::span(palmValues));
    ros::TactileState message{};
    ros::lend(message.sensors, std::span(sensors));
    RosArrayFile file = fileOf(1, 2);
    EXPECT_EQ(misfit(message, file), "a message has 2 sensors") << "which one?";
    file.sensor = "palm";
    EXPECT_EQ(loads(message, file), (std::vector<float>{1, 2}));
    file.sensor = "thumb";
    EXPECT_EQ(misfit(message, file), "a message has 3 numbers, the file has 1 x 2 taxels");
    file.sensor = "wrist";
    std::vector<float> none(2);
    const auto other = loadsOf(message, file, none);
    ASSERT_TRUE(other);
    EXPECT_FALSE(*other) << "a message of other sensors is no error";
    file.sensor.clear();
    ros::lend(message.sensors, std::span(sensors).last(1));
    EXPECT_EQ(loads(message, file), (std::vector<float>{1, 2}));
}

TEST(ArrayMessage, readsPixelsOfAllDepthsAndOrders) {
    EXPECT_EQ(loads(Picture("mono8", 2, 2, 3, {1, 2, 99, 3, 255}).message, fileOf(2, 2)),
              (std::vector<float>{1, 2, 3, 255}))
        << "a gap after each row, none after the last";
    EXPECT_EQ(loads(Picture("16UC1", 1, 2, 4, {1, 2, 3, 4}).message, fileOf(1, 2)),
              (std::vector<float>{0x0201, 0x0403}));
    EXPECT_EQ(loads(Picture("mono16", 1, 2, 4, {1, 2, 3, 4}, true).message, fileOf(1, 2)),
              (std::vector<float>{0x0102, 0x0304}));
    EXPECT_EQ(loads(Picture("32FC1", 1, 1, 4, {0, 0, 0xC0, 0x3F}).message, fileOf(1, 1)),
              (std::vector<float>{1.5F}));
}

TEST(ArrayMessage, refusesPicturesThatLie) {
    EXPECT_EQ(misfit(Picture("mono8", 2, 2, 2, {1, 2, 3}).message, fileOf(2, 2)),
              "a message has 3 bytes, its size says 4");
    EXPECT_NE(misfit(Picture("16UC1", 1, 2, 2, {1, 2, 3, 4}).message, fileOf(1, 2)), "") << "rows overlap";
    EXPECT_NE(misfit(Picture("mono8", 1, 2, 0xFFFFFFFF, {1}).message, fileOf(1, 2)), "");
    EXPECT_EQ(misfit(Picture("mono8", 1, 4, 4, {1, 2, 3, 4}).message, fileOf(2, 2)),
              "a message has 1 x 4 numbers, the file has 2 x 2 taxels");
    EXPECT_EQ(misfit(Picture("rgb8", 1, 1, 3, {1, 2, 3}).message, fileOf(1, 1)),
              "a message has the encoding \"rgb8\"");
}

} // namespace
} // namespace teleta::ros_array
