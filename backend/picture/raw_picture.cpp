// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/picture/raw_picture.h"

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

namespace teleta::picture {

namespace {

struct CameraMessageText {
    Q_DECLARE_TR_FUNCTIONS(RosCameraMessage)
};

struct Encoding {
    std::string_view name;
    int type;        ///< of the pixels, as OpenCV has them
    int conversion;  ///< to red, green, blue; kNone: they are that already
    int evenColumns; ///< pixels share their colours with a neighbour: 2
    bool hasColours;
};

constexpr int kNone = -1;
constexpr std::array<Encoding, 11> kEncodings{{{"rgb8", CV_8UC3, kNone, 1, true},
                                               {"bgr8", CV_8UC3, cv::COLOR_BGR2RGB, 1, true},
                                               {"8UC3", CV_8UC3, cv::COLOR_BGR2RGB, 1, true},
                                               {"rgba8", CV_8UC4, cv::COLOR_RGBA2RGB, 1, true},
                                               {"bgra8", CV_8UC4, cv::COLOR_BGRA2RGB, 1, true},
                                               {"8UC4", CV_8UC4, cv::COLOR_BGRA2RGB, 1, true},
                                               {"mono8", CV_8UC1, cv::COLOR_GRAY2RGB, 1, false},
                                               {"8UC1", CV_8UC1, cv::COLOR_GRAY2RGB, 1, false},
                                               {"mono16", CV_8UC2, cv::COLOR_GRAY2RGB, 1, false},
                                               {"yuv422", CV_8UC2, cv::COLOR_YUV2RGB_UYVY, 2, true},
                                               {"yuv422_yuy2", CV_8UC2, cv::COLOR_YUV2RGB_YUYV, 2, true}}};
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

/// The encoding of a picture whose sizes fit each other and its bytes.
core::Expected<const Encoding*> checked(const RawPicture& picture) {
    const std::string_view name = picture.encoding;
    const auto encoding = std::ranges::find(kEncodings, name, &Encoding::name);
    if (encoding == kEncodings.end())
        return badMessage(CameraMessageText::tr("a picture has the encoding \"%1\"")
                              .arg(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))),
                          QLatin1String(kEncodingNames));
    const std::size_t width = picture.width_px;
    const std::size_t height = picture.height_px;
    const QString size = QStringLiteral("%1 x %2").arg(width).arg(height);
    if (width == 0 || height == 0)
        return badMessage(CameraMessageText::tr("a picture has no pixels (%1)").arg(size));
    if (width > kMostPixels / height)
        return badMessage(CameraMessageText::tr("a picture is too large (%1)").arg(size),
                          CameraMessageText::tr("at most %1 pixels").arg(kMostPixels));
    if (width % static_cast<std::size_t>(encoding->evenColumns) != 0)
        return badMessage(CameraMessageText::tr("a picture in %1 has an odd width (%2)")
                              .arg(QLatin1String(encoding->name.data()), size));
    const std::size_t step = picture.rowBytes;
    const std::size_t rowBytes = width * static_cast<std::size_t>(CV_ELEM_SIZE(encoding->type));
    if (step < rowBytes)
        return badMessage(CameraMessageText::tr("a row of a picture has %1 bytes, its %2 pixels need %3")
                              .arg(step)
                              .arg(width)
                              .arg(rowBytes));
    if (const std::size_t needed = step * (height - 1) + rowBytes; picture.data.size() < needed)
        return badMessage(CameraMessageText::tr("a picture has %1 bytes, its size says %2")
                              .arg(picture.data.size())
                              .arg(needed));
    return &*encoding;
}

/// The brightness of mono8, 8UC1 and mono16; refers to the bytes of the picture where it can.
cv::Mat brightnessOf(const RawPicture& picture, const cv::Mat& given) {
    if (picture.encoding != "mono16")
        return given;
    cv::Mat upper;
    cv::extractChannel(given, upper, picture.isBigEndian ? 0 : 1);
    return upper;
}

/// OpenCV takes no constant bytes, and does not change these.
cv::Mat matrixOf(const RawPicture& picture, const Encoding& encoding) {
    return {static_cast<int>(picture.height_px), static_cast<int>(picture.width_px), encoding.type,
            const_cast<std::uint8_t*>(picture.data.data()), picture.rowBytes};
}

/// mode: cv::IMREAD_COLOR or cv::IMREAD_GRAYSCALE.
core::Expected<cv::Mat> decoded(std::string_view bytes, int mode) {
    if (!opencv::isPicture(bytes, kMostPixels))
        return badMessage(
            CameraMessageText::tr("a picture is no JPEG or PNG, or too large (%1 bytes)").arg(bytes.size()),
            CameraMessageText::tr("JPEG or PNG of at most %1 pixels").arg(kMostPixels));
    TELETA_TRY(const auto pictures, opencv::pictures());
    try {
        const cv::Mat coded(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
        cv::Mat pixels = pictures->decode(coded, mode | cv::IMREAD_IGNORE_ORIENTATION);
        if (pixels.empty() || pixels.type() != (mode == cv::IMREAD_COLOR ? CV_8UC3 : CV_8UC1))
            return badMessage(CameraMessageText::tr("a picture is damaged (%1 bytes)").arg(bytes.size()));
        return pixels;
    } catch (const cv::Exception& error) {
        return badMessage(QString::fromStdString(error.err));
    }
}

cv::Mat rgbOf(const RawPicture& picture, const Encoding& encoding) {
    const cv::Mat given = matrixOf(picture, encoding);
    if (encoding.conversion == kNone)
        return given.clone();
    cv::Mat rgb;
    cv::cvtColor(encoding.hasColours ? given : brightnessOf(picture, given), rgb, encoding.conversion);
    return rgb;
}

} // namespace

core::Expected<core::ColourImage> colourOf(const RawPicture& picture) {
    TELETA_TRY(const Encoding* encoding, checked(picture));
    try {
        return imageOf(rgbOf(picture, *encoding));
    } catch (const cv::Exception& error) {
        return badMessage(QString::fromStdString(error.err));
    }
}

core::Expected<core::GreyImage> greyOf(const RawPicture& picture) {
    TELETA_TRY(const Encoding* encoding, checked(picture));
    try {
        cv::Mat grey;
        if (encoding->hasColours)
            cv::cvtColor(rgbOf(picture, *encoding), grey, cv::COLOR_RGB2GRAY);
        else
            grey = brightnessOf(picture, matrixOf(picture, *encoding)).clone();
        return core::greyImageOf(std::move(grey));
    } catch (const cv::Exception& error) {
        return badMessage(QString::fromStdString(error.err));
    }
}

bool hasColours(std::string_view encoding) {
    const auto found = std::ranges::find(kEncodings, encoding, &Encoding::name);
    return found != kEncodings.end() && found->hasColours;
}

core::Expected<core::ColourImage> colourOfCoded(std::string_view bytes) {
    TELETA_TRY(const cv::Mat bgr, decoded(bytes, cv::IMREAD_COLOR));
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    return imageOf(std::move(rgb));
}

core::Expected<core::GreyImage> greyOfCoded(std::string_view bytes) {
    TELETA_TRY(cv::Mat grey, decoded(bytes, cv::IMREAD_GRAYSCALE));
    return core::greyImageOf(std::move(grey));
}

} // namespace teleta::picture
