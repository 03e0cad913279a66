// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/image/jpeg_picture.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <memory>

namespace teleta::site_link {
namespace {

/// Red grows to the right, green downwards.
core::ColourImage gradient() {
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>();
    for (int row = 0; row < 48; ++row) {
        for (int column = 0; column < 64; ++column) {
            pixels->push_back(static_cast<std::uint8_t>(4 * column));
            pixels->push_back(static_cast<std::uint8_t>(5 * row));
            pixels->push_back(128);
        }
    }
    return {{pixels, pixels->data()}, 64, 48};
}

TEST(JpegPicture, otherProgramsSeeTheSamePicture) {
    const core::ColourImage picture = gradient();
    const auto bytes = toJpeg(picture, 90);
    ASSERT_TRUE(bytes) << core::describe(bytes.error());
    EXPECT_TRUE(isWholeJpeg(*bytes));
    const cv::Mat seen = cv::imdecode(*bytes, cv::IMREAD_COLOR);
    ASSERT_EQ(seen.size(), cv::Size(64, 48));
    cv::Mat rgb;
    cv::cvtColor(seen, rgb, cv::COLOR_BGR2RGB);
    for (int i = 0; i < 3 * 64 * 48; ++i)
        ASSERT_NEAR(rgb.data[i], picture.pixels.get()[i], 16) << i;
}

TEST(JpegPicture, aGreyPictureHasOneColourOnly) {
    cv::Mat1b picture(48, 64);
    for (int row = 0; row < 48; ++row)
        for (int column = 0; column < 64; ++column)
            picture(row, column) = static_cast<std::uint8_t>(2 * row + 2 * column);
    const auto bytes = toJpeg(core::greyImageOf(picture), 95);
    ASSERT_TRUE(bytes) << core::describe(bytes.error());
    EXPECT_TRUE(isWholeJpeg(*bytes));
    const cv::Mat seen = cv::imdecode(*bytes, cv::IMREAD_UNCHANGED);
    ASSERT_EQ(seen.channels(), 1);
    ASSERT_EQ(seen.size(), cv::Size(64, 48));
    EXPECT_LE(cv::norm(seen, picture, cv::NORM_INF), 4.0);
}

TEST(JpegPicture, aLowerQualityTakesFewerBytes) {
    const auto fine = toJpeg(gradient(), 95);
    const auto coarse = toJpeg(gradient(), 10);
    ASSERT_TRUE(fine && coarse);
    EXPECT_LT(coarse->size(), fine->size());
}

TEST(JpegPicture, anEmptyPictureIsRefused) {
    EXPECT_FALSE(toJpeg(core::ColourImage(), 70));
    EXPECT_FALSE(toJpeg(core::GreyImage(), 70));
}

TEST(JpegPicture, whatWasCutOffIsNotWhole) {
    auto bytes = toJpeg(gradient(), 70);
    ASSERT_TRUE(bytes);
    for (std::size_t size = 0; size < bytes->size(); ++size)
        ASSERT_FALSE(isWholeJpeg(std::span(*bytes).first(size))) << size;
    EXPECT_FALSE(isWholeJpeg(std::span(*bytes).subspan(1)));
}

} // namespace
} // namespace teleta::site_link
