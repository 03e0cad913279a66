// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/opencv_parts.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace teleta::opencv {
namespace {

bool isLoaded(const char* library) {
    void* const handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
    if (handle != nullptr)
        dlclose(handle);
    return handle != nullptr;
}

cv::Mat1b texture(int shift_px) {
    cv::Mat1b image(96, 128);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image(y, x) = static_cast<std::uint8_t>(128.0 + 60.0 * std::sin(0.35 * (x - shift_px)) +
                                                    60.0 * std::cos(0.29 * y + 0.11 * (x - shift_px)));
    return image;
}

TEST(OpenCvPartsTest, librariesComeWithTheFirstUse) {
    EXPECT_FALSE(isLoaded("libopencv_video.so.406"));
    EXPECT_FALSE(isLoaded("libopencv_imgcodecs.so.406"));
    EXPECT_FALSE(isLoaded("libopencv_videoio.so.406"));
    ASSERT_TRUE(denseFlow(cv::DISOpticalFlow::PRESET_FAST));
    EXPECT_TRUE(isLoaded("libopencv_video.so.406"));
    EXPECT_FALSE(isLoaded("libopencv_imgcodecs.so.406"));
    ASSERT_TRUE(pictures());
    EXPECT_TRUE(isLoaded("libopencv_imgcodecs.so.406"));
    EXPECT_FALSE(isLoaded("libopencv_videoio.so.406"));
    ASSERT_TRUE(videoCapture());
    EXPECT_TRUE(isLoaded("libopencv_videoio.so.406"));
}

TEST(OpenCvPartsTest, aPictureIsWrittenAndDecoded) {
    const test::TemporaryFolder folder;
    const auto part = pictures();
    ASSERT_TRUE(part) << describe(part.error());
    const cv::Mat1b image = texture(0);
    const std::string path = folder.path("picture.png");
    ASSERT_TRUE((*part)->write(path, image));
    std::ifstream file(path, std::ios::binary);
    std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const cv::Mat coded(1, static_cast<int>(bytes.size()), CV_8UC1, bytes.data());
    const cv::Mat decoded = (*part)->decode(coded, 0);
    ASSERT_EQ(decoded.size(), image.size());
    EXPECT_EQ(cv::norm(decoded, image, cv::NORM_INF), 0.0);
    EXPECT_TRUE((*part)->decode(cv::Mat(1, 3, CV_8UC1, cv::Scalar::all(7)), 0).empty());
    // A format that OpenCV does not know: its exceptions pass through.
    EXPECT_THROW((void)(*part)->write(folder.path("picture.unknown"), image), cv::Exception);
}

TEST(OpenCvPartsTest, theFlowOfAShiftIsTheShift) {
    auto flow = denseFlow(cv::DISOpticalFlow::PRESET_MEDIUM);
    ASSERT_TRUE(flow) << describe(flow.error());
    cv::Mat2f found;
    (*flow)->calc(texture(0), texture(2), found);
    const cv::Scalar mean = cv::mean(found(cv::Rect(32, 24, 64, 48)));
    EXPECT_NEAR(mean[0], 2.0, 0.2);
    EXPECT_NEAR(mean[1], 0.0, 0.2);
}

TEST(OpenCvPartsTest, aNewVideoIsNotOpen) {
    auto video = videoCapture();
    ASSERT_TRUE(video) << describe(video.error());
    EXPECT_FALSE((*video)->isOpened());
    EXPECT_FALSE((*video)->grab());
}

} // namespace
} // namespace teleta::opencv
