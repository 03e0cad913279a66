// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <string>

namespace teleta::test {

/// Frame i is grey with the level 40 + 5 i, and a white square.
inline cv::Mat videoFrame(int i) {
    cv::Mat image(120, 160, CV_8UC3, cv::Scalar::all(40 + 5 * i));
    cv::rectangle(image, {10 + i, 20, 30, 30}, cv::Scalar::all(255), cv::FILLED);
    return image;
}

/// Motion-JPEG in an AVI file.
inline void writeVideo(const std::string& path, int frames, double rate_Hz) {
    cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate_Hz, {160, 120});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 0; i < frames; ++i)
        writer.write(videoFrame(i));
}

} // namespace teleta::test
