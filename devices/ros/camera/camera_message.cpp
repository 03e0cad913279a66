// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/camera_message.h"

#include "backend/core/failure.h"
#include "backend/opencv/coded_picture.h"
#include "backend/opencv/opencv_parts.h"

#include <QCoreApplication>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace teleta::ros_camera {

namespace {

struct CameraMessageText {
    Q_DECLARE_TR_FUNCTIONS(RosCameraMessage)
};

struct Encoding {
    std::string_view name;
    int type;        ///< of the pixels, as OpenCV has them
    int conversion;  ///< to red, green, blue; kNone: they are that already
    int evenColumns; ///< pixels share their colours with a neighbour: 2
};

constexpr int kNone = -1;
constexpr std::array<Encoding, 11> kEncodings{{{"rgb8", CV_8UC3, kNone, 1},
                                               {"bgr8", CV_8UC3, cv::COLOR_BGR2RGB, 1},
                                               {"8UC3", CV_8UC3, cv::COLOR_BGR2RGB, 1},
                                               {"rgba8", CV_8UC4, cv::COLOR_RGBA2RGB, 1},
                                               {"bgra8", CV_8UC4, cv::COLOR_BGRA2RGB, 1},
                                               {"8UC4", CV_8UC4, cv::COLOR_BGRA2RGB, 1},
                                               {"mono8", CV_8UC1, cv::COLOR_GRAY2RGB, 1},
                                               {"8UC1", CV_8UC1, cv::COLOR_GRAY2RGB, 1},
                                               {"mono16", CV_8UC2, cv::COLOR_GRAY2RGB, 1},
                                               {"yuv422", CV_8UC2, cv::COLOR_YUV2RGB_UYVY, 2},
                                               {"yuv422_yuy2", CV_8UC2, cv::COLOR_YUV2RGB_YUYV, 2}}};
constexpr const char* kEncodingNames =
    "rgb8, bgr8, rgba8, bgra8, mono8, mono16, 8UC1, 8UC3, 8UC4, yuv422, yuv422_yuy2";

core::Unexpected badMessage(const QString& why, const QString& expected = {}) {
    return core::failed(core::ErrorKind::badInput, why, expected);
}

/// pixels: three bytes each, not written to afterwards.
core::ColourImage imageOf(cv::Mat pixels) {
    const auto kept = std::make_shared<cv::Mat>(pixels.isContinuous() ? std::move(pixels) : pixels.clone());
    return {{kept, kept->data}, kept->cols, kept->rows};
}

/// OpenCV takes no constant bytes, and does not change these.
void* lent(std::span<const std::uint8_t> bytes) {
    return const_cast<std::uint8_t*>(bytes.data());
}

} // namespace

core::Expected<core::ColourImage> pictureOf(const ros::Image& message) {
    const std::string_view name = message.encoding == nullptr ? "" : message.encoding;
    const auto encoding = std::ranges::find(kEncodings, name, &Encoding::name);
    if (encoding == kEncodings.end())
        return badMessage(CameraMessageText::tr("a picture has the encoding \"%1\"")
                              .arg(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))),
                          QLatin1String(kEncodingNames));
    const std::size_t width = message.width;
    const std::size_t height = message.height;
    const QString size = QStringLiteral("%1 x %2").arg(width).arg(height);
    if (width == 0 || height == 0)
        return badMessage(CameraMessageText::tr("a picture has no pixels (%1)").arg(size));
    if (width > kMostPixels / height)
        return badMessage(CameraMessageText::tr("a picture is too large (%1)").arg(size),
                          CameraMessageText::tr("at most %1 pixels").arg(kMostPixels));
    if (width % static_cast<std::size_t>(encoding->evenColumns) != 0)
        return badMessage(CameraMessageText::tr("a picture in %1 has an odd width (%2)")
                              .arg(QLatin1String(encoding->name.data()), size));
    const auto data = ros::view(message.data);
    const std::size_t step = message.step;
    const std::size_t rowBytes = width * static_cast<std::size_t>(CV_ELEM_SIZE(encoding->type));
    if (step < rowBytes)
        return badMessage(CameraMessageText::tr("a row of a picture has %1 bytes, its %2 pixels need %3")
                              .arg(step)
                              .arg(width)
                              .arg(rowBytes));
    if (const std::size_t needed = step * (height - 1) + rowBytes; data.size() < needed)
        return badMessage(
            CameraMessageText::tr("a picture has %1 bytes, its size says %2").arg(data.size()).arg(needed));
    try {
        const cv::Mat given(static_cast<int>(height), static_cast<int>(width), encoding->type, lent(data),
                            step);
        cv::Mat rgb;
        if (encoding->name == "mono16") {
            cv::Mat upper;
            cv::extractChannel(given, upper, message.is_bigendian != 0 ? 0 : 1);
            cv::cvtColor(upper, rgb, encoding->conversion);
        } else if (encoding->conversion == kNone) {
            rgb = given.clone();
        } else {
            cv::cvtColor(given, rgb, encoding->conversion);
        }
        return imageOf(std::move(rgb));
    } catch (const cv::Exception& error) {
        return badMessage(QString::fromStdString(error.err));
    }
}

core::Expected<core::ColourImage> pictureOf(const ros::CompressedImage& message) {
    const auto data = ros::view(message.data);
    const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
    if (!opencv::isPicture(bytes, kMostPixels))
        return badMessage(
            CameraMessageText::tr("a picture is no JPEG or PNG, or too large (%1 bytes)").arg(data.size()),
            CameraMessageText::tr("JPEG or PNG of at most %1 pixels").arg(kMostPixels));
    TELETA_TRY(const auto pictures, opencv::pictures());
    try {
        const cv::Mat coded(1, static_cast<int>(data.size()), CV_8UC1, lent(data));
        const cv::Mat bgr = pictures->decode(coded, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
        if (bgr.empty() || bgr.type() != CV_8UC3)
            return badMessage(CameraMessageText::tr("a picture is damaged (%1 bytes)").arg(data.size()));
        cv::Mat rgb;
        cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
        return imageOf(std::move(rgb));
    } catch (const cv::Exception& error) {
        return badMessage(QString::fromStdString(error.err));
    }
}

} // namespace teleta::ros_camera
