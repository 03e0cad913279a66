// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that Fast DDS sends, as a camera driver of ROS 2 does, reach the device as they were.
#include "backend/core/device/colour_image.h"
#include "dds_node.h"
#include "devices/ros/camera/ros_camera.h"
#include "messages.h"
#include "messagesPubSubTypes.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta {
namespace {

namespace fast = eprosima::fastdds::dds;
using core::DeviceState;
using Bytes = std::vector<std::uint8_t>;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr peer::EndQos kSensor{.reliable = false, .transientLocal = false, .depth = 5};

/// Waits at most 30 s.
template <typename Condition>
bool eventually(const Condition& holds) {
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::seconds(30); Clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
        if (holds())
            return true;
    }
    return false;
}

/// Each byte tells its place and the number of the picture.
Bytes numbered(std::uint32_t number) {
    Bytes bytes(std::size_t{3} * kWidth * kHeight);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i * 7 + number);
    return bytes;
}

class RosCameraPeer : public testing::Test {
protected:
    std::unique_ptr<ros_camera::RosCamera> open(int domain, const std::string& topic) {
        const auto file = ros_camera::parseRosCamera(
            "kind = \"ros_camera\"\nname = \"front\"\ntopic = \"" + topic +
                "\"\nrate_Hz = 30\n[ros]\ndomain = " + std::to_string(domain) + "\ninterface = \"lo\"\n",
            "front.toml");
        EXPECT_TRUE(file) << core::describe(file.error());
        auto opened = ros_camera::RosCamera::open(*file);
        EXPECT_TRUE(opened) << core::describe(opened.error());
        (*opened)->start(m_wakeup);
        return std::move(*opened);
    }
    static fast::DataWriter* images(peer::DdsNode& node, const std::string& topic) {
        return node.write(topic, fast::TypeSupport(new sensor_msgs::msg::ImagePubSubType), kSensor);
    }
    static sensor_msgs::msg::Image image(std::uint32_t number) {
        sensor_msgs::msg::Image message;
        message.header().stamp().sec(100);
        message.header().stamp().nanosec(number * 33'000'000);
        message.width(kWidth);
        message.height(kHeight);
        message.encoding("rgb8");
        message.step(3 * kWidth);
        message.data(numbered(number));
        return message;
    }

    core::Wakeup m_wakeup;
};

} // namespace

TEST_F(RosCameraPeer, aWholePictureArrivesByteByByteAndTheStatusFollowsTheWriter) {
    const auto camera = open(117, "/front/image_raw");
    EXPECT_TRUE(eventually([&] {
        return camera->status().message.find("nobody publishes /front/image_raw") != std::string::npos;
    })) << camera->status().message;
    EXPECT_EQ(camera->status().state, DeviceState::connecting);
    {
        peer::DdsNode node(117);
        fast::DataWriter* const writer = images(node, "/front/image_raw");
        std::uint32_t number = 0;
        core::CameraFrame frame;
        double last_s = -1.0;
        int right = 0;
        EXPECT_TRUE(eventually([&] {
            sensor_msgs::msg::Image message = image(++number);
            writer->write(&message);
            while (camera->pop(frame)) {
                const core::ColourImage picture = core::colourOf(frame.image);
                EXPECT_EQ(picture.width_px, kWidth);
                EXPECT_EQ(picture.height_px, kHeight);
                // Which one it is, it tells by itself.
                EXPECT_TRUE(
                    std::ranges::equal(numbered(picture.pixels.get()[0]),
                                       std::span(picture.pixels.get(), std::size_t{3} * kWidth * kHeight)));
                EXPECT_GT(frame.capture_s, last_s);
                last_s = frame.capture_s;
                ++right;
            }
            return right >= 20;
        })) << right;
        EXPECT_EQ(camera->status().state, DeviceState::live);
        EXPECT_EQ(camera->counters().misfits, 0U);
        EXPECT_EQ(camera->counters().oddStamps, 0U);
    }
    EXPECT_TRUE(eventually([&] { return camera->status().state == DeviceState::stale; }));
    EXPECT_NE(camera->status().message.find("/front/image_raw"), std::string::npos);
    // The same program, or another, comes back.
    peer::DdsNode again(117);
    fast::DataWriter* const writer = images(again, "/front/image_raw");
    EXPECT_TRUE(eventually([&] {
        sensor_msgs::msg::Image message = image(1);
        writer->write(&message);
        return camera->status().state == DeviceState::live;
    }));
    EXPECT_TRUE(camera->status().message.empty()) << camera->status().message;
}

TEST_F(RosCameraPeer, aMessageThatLiesIsCountedAndTold) {
    peer::DdsNode node(118);
    fast::DataWriter* const writer = images(node, "/front/image_raw");
    const auto camera = open(118, "/front/image_raw");
    sensor_msgs::msg::Image message = image(1);
    message.height(kHeight + 1);
    EXPECT_TRUE(eventually([&] {
        writer->write(&message);
        return camera->status().message.find("a picture has 921600 bytes, its size says 923520") !=
               std::string::npos;
    })) << camera->status().message;
    EXPECT_GT(camera->counters().misfits, 0U);
    EXPECT_GE(camera->counters().misfits, camera->status().framesLost);
    EXPECT_EQ(camera->counters().pictures, 0U);
    core::CameraFrame frame;
    EXPECT_FALSE(camera->pop(frame));
    // A right one ends it.
    message = image(1);
    EXPECT_TRUE(eventually([&] {
        writer->write(&message);
        return camera->status().state == DeviceState::live;
    }));
}

TEST_F(RosCameraPeer, aCompressedPictureIsDecoded) {
    peer::DdsNode node(119);
    fast::DataWriter* const writer =
        node.write("/front/image_raw/compressed",
                   fast::TypeSupport(new sensor_msgs::msg::CompressedImagePubSubType), kSensor);
    const auto camera = open(119, "/front/image_raw/compressed");
    // Blue, green, red.
    cv::Mat3b bgr(48, 64, cv::Vec3b(40, 90, 200));
    Bytes png;
    ASSERT_TRUE(cv::imencode(".png", bgr, png));
    sensor_msgs::msg::CompressedImage message;
    message.format("rgb8; png compressed bgr8");
    message.data(png);
    core::CameraFrame frame;
    EXPECT_TRUE(eventually([&] {
        writer->write(&message);
        return camera->pop(frame);
    }));
    const core::ColourImage picture = core::colourOf(frame.image);
    ASSERT_EQ(picture.width_px, 64);
    ASSERT_EQ(picture.height_px, 48);
    EXPECT_EQ(Bytes(picture.pixels.get(), picture.pixels.get() + 3), (Bytes{200, 90, 40}));
    // A stamp that is not set is no order of time: our clock tells.
    EXPECT_TRUE(eventually([&] {
        writer->write(&message);
        return camera->counters().oddStamps > 1;
    }));
}

} // namespace teleta
