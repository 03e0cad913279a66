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

} // namespace

core::Expected<std::vector<std::uint8_t>> toJpeg(const core::ColourImage& picture, int quality) {
    TELETA_TRY(const auto pictures, opencv::pictures());
    try {
        // OpenCV takes no constant bytes, and does not change these.
        const cv::Mat rgb(picture.height_px, picture.width_px, CV_8UC3,
                          const_cast<std::uint8_t*>(picture.pixels.get()));
        cv::Mat bgr;
        cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
        std::vector<std::uint8_t> bytes;
        if (pictures->encode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality}))
            return bytes;
    } catch (const cv::Exception& error) {
        return core::refused(QString::fromStdString(error.err));
    }
    return core::refused(QStringLiteral("JPEG"));
}

bool isWholeJpeg(std::span<const std::uint8_t> bytes) {
    return bytes.size() > kBegin.size() + kEnd.size() &&
           std::ranges::equal(bytes.first(kBegin.size()), kBegin) &&
           std::ranges::equal(bytes.last(kEnd.size()), kEnd);
}

} // namespace teleta::site_link
