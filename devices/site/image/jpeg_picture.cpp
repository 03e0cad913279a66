// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/image/jpeg_picture.h"

#include "backend/core/failure.h"
#include "backend/opencv/opencv_parts.h"

#include <QString>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>

namespace teleta::site_link {

namespace {

constexpr std::array<std::uint8_t, 3> kBegin{0xff, 0xd8, 0xff};
constexpr std::array<std::uint8_t, 2> kEnd{0xff, 0xd9};

/// type: CV_8UC3 for red, green and blue, or CV_8UC1.
core::Expected<std::vector<std::uint8_t>> coded(const std::uint8_t* pixels, int width_px, int height_px,
                                                int type, int quality) {
    TELETA_TRY(const auto pictures, opencv::pictures());
    try {
        // OpenCV takes no constant bytes, and does not change these.
        cv::Mat picture(height_px, width_px, type, const_cast<std::uint8_t*>(pixels));
        if (type == CV_8UC3) {
            cv::Mat bgr;
            cv::cvtColor(picture, bgr, cv::COLOR_RGB2BGR);
            picture = bgr;
        }
        std::vector<std::uint8_t> bytes;
        if (pictures->encode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality}))
            return bytes;
    } catch (const cv::Exception& error) {
        return core::refused(QString::fromStdString(error.err));
    }
    return core::refused(QStringLiteral("JPEG"));
}

} // namespace

core::Expected<std::vector<std::uint8_t>> toJpeg(const core::ColourImage& picture, int quality) {
    return coded(picture.pixels.get(), picture.width_px, picture.height_px, CV_8UC3, quality);
}

core::Expected<std::vector<std::uint8_t>> toJpeg(const core::GreyImage& picture, int quality) {
    return coded(picture.pixels.get(), picture.width_px, picture.height_px, CV_8UC1, quality);
}

bool isWholeJpeg(std::span<const std::uint8_t> bytes) {
    return bytes.size() > kBegin.size() + kEnd.size() &&
           std::ranges::equal(bytes.first(kBegin.size()), kBegin) &&
           std::ranges::equal(bytes.last(kEnd.size()), kEnd);
}

} // namespace teleta::site_link
