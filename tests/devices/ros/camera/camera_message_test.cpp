// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/camera_message.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace teleta::ros_camera {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Picture {
    Picture(std::string name, std::uint32_t width, std::uint32_t height, std::uint32_t step, Bytes given,
            bool isBig = false)
        : encoding(std::move(name))
        , data(std::move(given)) {
        message.encoding = encoding.data();
        message.width = width;
        message.height = height;
        message.step = step;
        message.is_bigendian = isBig ? 1 : 0;
        ros::lend(message.data, std::span(data));
    }
    std::string encoding;
    Bytes data;
    ros::Image message{};
};

struct Coded {
    explicit Coded(Bytes given)
        : data(std::move(given)) {
        message.format = format.data();
        ros::lend(message.data, std::span(data));
    }
    std::string format = "whatever it says";
    Bytes data;
    ros::CompressedImage message{};
};

/// The bytes of a picture of two columns.
template <typename Message>
Bytes bytes(const Message& message) {
    const auto picture = pictureOf(message);
    EXPECT_TRUE(picture) << core::describe(picture.error());
    if (!picture)
        return {};
    const auto size = static_cast<std::size_t>(3 * picture->width_px * picture->height_px);
    return {picture->pixels.get(), picture->pixels.get() + size};
}

template <typename Message>
std::string misfit(const Message& message) {
    const auto picture = pictureOf(message);
    EXPECT_FALSE(picture);
    return picture ? std::string() : core::describe(picture.error());
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A gradient with a different colour in each corner.
cv::Mat3b drawn(int width, int height) {
    cv::Mat3b bgr(height, width);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            bgr(row, column) = {static_cast<std::uint8_t>(255 * column / width),
                                static_cast<std::uint8_t>(255 * row / height), 90};
    return bgr;
}

TEST(CameraMessage, readsEachOrderOfColours) {
    // Two pixels: red 1, green 2, blue 3; red 4, green 5, blue 6.
    const Bytes wanted{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(bytes(Picture("rgb8", 2, 1, 6, {1, 2, 3, 4, 5, 6}).message), wanted);
    EXPECT_EQ(bytes(Picture("bgr8", 2, 1, 6, {3, 2, 1, 6, 5, 4}).message), wanted);
    EXPECT_EQ(bytes(Picture("8UC3", 2, 1, 6, {3, 2, 1, 6, 5, 4}).message), wanted);
    EXPECT_EQ(bytes(Picture("rgba8", 2, 1, 8, {1, 2, 3, 0, 4, 5, 6, 255}).message), wanted);
    EXPECT_EQ(bytes(Picture("bgra8", 2, 1, 8, {3, 2, 1, 0, 6, 5, 4, 255}).message), wanted);
    EXPECT_EQ(bytes(Picture("8UC4", 2, 1, 8, {3, 2, 1, 0, 6, 5, 4, 255}).message), wanted);
}

TEST(CameraMessage, greyBecomesThreeEqualColours) {
    const Bytes wanted{7, 7, 7, 200, 200, 200};
    EXPECT_EQ(bytes(Picture("mono8", 2, 1, 2, {7, 200}).message), wanted);
    EXPECT_EQ(bytes(Picture("8UC1", 2, 1, 2, {7, 200}).message), wanted);
    EXPECT_EQ(bytes(Picture("mono16", 2, 1, 4, {99, 7, 98, 200}).message), wanted);
    EXPECT_EQ(bytes(Picture("mono16", 2, 1, 4, {7, 99, 200, 98}, true).message), wanted);
}

TEST(CameraMessage, passesOverWhatFollowsTheRows) {
    const Bytes wanted{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(bytes(Picture("rgb8", 1, 2, 5, {1, 2, 3, 88, 88, 4, 5, 6}).message), wanted)
        << "the last row may end with its pixels";
    EXPECT_EQ(bytes(Picture("rgb8", 1, 2, 5, {1, 2, 3, 88, 88, 4, 5, 6, 88, 88, 77}).message), wanted);
    EXPECT_EQ(bytes(Picture("bgr8", 1, 2, 4, {3, 2, 1, 88, 6, 5, 4, 88}).message), wanted);
}

TEST(CameraMessage, sharedColoursAreThoseOfTheStandard) {
    // ITU-R BT.601, studio range: R = 1.164 (Y - 16) + 1.596 (V - 128) and so on.
    const double y = 120.0;
    const double u = 90.0;
    const double v = 160.0;
    const auto byte = [](double value) { return static_cast<int>(std::lround(value)); };
    const std::vector<int> wanted{byte(1.164 * (y - 16) + 1.596 * (v - 128)),
                                  byte(1.164 * (y - 16) - 0.813 * (v - 128) - 0.392 * (u - 128)),
                                  byte(1.164 * (y - 16) + 2.017 * (u - 128))};
    for (const Bytes& found : {bytes(Picture("yuv422", 2, 1, 4, {90, 120, 160, 120}).message),
                               bytes(Picture("yuv422_yuy2", 2, 1, 4, {120, 90, 120, 160}).message)}) {
        ASSERT_EQ(found.size(), 6U);
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], wanted[i % 3], 1) << i;
    }
}

TEST(CameraMessage, aLargePictureIsThatOfOpenCv) {
    const cv::Mat3b bgr = drawn(1920, 1080);
    Bytes data(bgr.data, bgr.data + bgr.total() * 3);
    const auto picture = pictureOf(Picture("bgr8", 1920, 1080, 5760, std::move(data)).message);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width_px, 1920);
    EXPECT_EQ(picture->height_px, 1080);
    cv::Mat3b rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    EXPECT_TRUE(std::equal(rgb.data, rgb.data + rgb.total() * 3, picture->pixels.get()));
}

TEST(CameraMessage, saysWhatDoesNotFit) {
    EXPECT_TRUE(has(misfit(Picture("bayer_rggb8", 2, 2, 2, {1, 2, 3, 4}).message), "\"bayer_rggb8\""));
    EXPECT_TRUE(has(misfit(Picture("bayer_rggb8", 2, 2, 2, {1, 2, 3, 4}).message), "bgr8")) << "what is read";
    EXPECT_TRUE(has(misfit(Picture("rgb8", 2, 1, 5, {1, 2, 3, 4, 5, 6}).message), "has 5 bytes"));
    EXPECT_TRUE(has(misfit(Picture("rgb8", 2, 2, 6, Bytes(11)).message), "has 11 bytes, its size says 12"));
    EXPECT_TRUE(has(misfit(Picture("rgb8", 0, 4, 0, {}).message), "0 x 4"));
    EXPECT_TRUE(has(misfit(Picture("rgb8", 4, 0, 12, {}).message), "4 x 0"));
    EXPECT_TRUE(has(misfit(Picture("yuv422", 1, 1, 4, {1, 2, 3, 4}).message), "odd width"));
    const std::uint32_t huge = std::numeric_limits<std::uint32_t>::max();
    EXPECT_TRUE(has(misfit(Picture("rgb8", huge, huge, huge, {1}).message), "too large"));
    EXPECT_TRUE(has(misfit(Picture("mono8", 8, 4096, huge, {1}).message), "its size says"));
    ros::Image none{};
    EXPECT_TRUE(has(misfit(none), "encoding \"\""));
}

TEST(CameraMessage, decodesPngExactlyAndJpegClosely) {
    const cv::Mat3b bgr = drawn(64, 48);
    cv::Mat3b rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    Bytes png;
    ASSERT_TRUE(cv::imencode(".png", bgr, png));
    EXPECT_EQ(bytes(Coded(png).message), Bytes(rgb.data, rgb.data + rgb.total() * 3));
    Bytes jpeg;
    ASSERT_TRUE(cv::imencode(".jpg", bgr, jpeg));
    const Bytes found = bytes(Coded(jpeg).message);
    ASSERT_EQ(found.size(), rgb.total() * 3);
    int worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        worst = std::max(worst, std::abs(int{found[i]} - int{rgb.data[i]}));
    EXPECT_LT(worst, 16) << "JPEG loses a little, and no colour takes the place of another";
    Bytes grey;
    ASSERT_TRUE(cv::imencode(".png", cv::Mat1b(1, 1, std::uint8_t{77}), grey));
    EXPECT_EQ(bytes(Coded(grey).message), (Bytes{77, 77, 77}));
}

TEST(CameraMessage, saysWhatCannotBeDecoded) {
    EXPECT_TRUE(has(misfit(Coded({}).message), "no JPEG or PNG"));
    EXPECT_TRUE(has(misfit(Coded({'B', 'M', 1, 2, 3}).message), "no JPEG or PNG"));
    Bytes png;
    ASSERT_TRUE(cv::imencode(".png", drawn(64, 48), png));
    Bytes head(png.begin(), png.begin() + 40);
    EXPECT_TRUE(has(misfit(Coded(head).message), "damaged"));
    Bytes wide = png;
    for (const std::size_t at : {16, 17, 20, 21}) // of the width and the height
        wide[at] = 0x7f;
    EXPECT_TRUE(has(misfit(Coded(wide).message), "too large")) << "before a byte is decoded";
}

} // namespace
} // namespace teleta::ros_camera
