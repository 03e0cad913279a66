// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/vision/video_file.h"

#include "backend/opencv/opencv_parts.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <filesystem>
#include <utility>

namespace teleta::python {

namespace {

constexpr double kUnknownRate_Hz = 30.0;
constexpr double kHighestRate_Hz = 10000.0;
constexpr int kMostFailures = 25;   ///< pictures in a row that cannot be decoded are the end of a file
constexpr double kLongestGap = 1e6; ///< pictures; what is longer is a damaged time stamp

} // namespace

core::Expected<VideoFile> VideoFile::open(const std::string& path) {
    const auto refused = [&path](core::ErrorKind kind, const char* message, const char* expected) {
        return core::Unexpected(core::Error{kind, message, expected, {path}});
    };
    std::error_code ignored;
    if (path.find('%') == std::string::npos && !std::filesystem::exists(path, ignored))
        return refused(core::ErrorKind::notFound, "the file does not exist", "");
    VideoFile file;
    try {
        TELETA_TRY(file.m_capture, opencv::videoCapture());
        file.m_capture->open(path, cv::CAP_ANY);
        if (!file.m_capture->isOpened())
            return refused(core::ErrorKind::badInput, "the file is not a readable video",
                           "a video, or a pattern like frame_%04d.png");
        const double rate_Hz = file.m_capture->get(cv::CAP_PROP_FPS);
        file.m_rate_Hz = rate_Hz > 0.0 && rate_Hz < kHighestRate_Hz ? rate_Hz : kUnknownRate_Hz;
        const double total = file.m_capture->get(cv::CAP_PROP_FRAME_COUNT);
        file.m_total = total > 0.0 && total < 1e12 ? static_cast<std::uint64_t>(total) : 0;
    } catch (const cv::Exception& error) {
        return refused(core::ErrorKind::badInput, error.err.c_str(), "");
    }
    return file;
}

VideoFile::Outcome VideoFile::next(cv::Mat1b& picture, double& time_s) {
    try {
        if (!m_capture->grab()) {
            // OpenCV takes a damaged picture for the end; the file tells how many there should be.
            if (m_read >= m_total || ++m_failures > kMostFailures)
                return Outcome::ended;
            time_s = m_last_s += m_read == 0 ? 0.0 : 1.0 / m_rate_Hz;
            ++m_read;
            return Outcome::undecodable;
        }
        m_failures = 0;
        time_s = stampedTime_s();
        ++m_read;
        if (!m_capture->retrieve(m_image) || m_image.empty() || m_image.depth() != CV_8U)
            return Outcome::undecodable;
        if (m_image.channels() == 1)
            m_image.copyTo(picture);
        else
            cv::cvtColor(m_image, picture,
                         m_image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
        return Outcome::picture;
    } catch (const cv::Exception&) {
        time_s = m_last_s;
        return ++m_failures > kMostFailures ? Outcome::ended : Outcome::undecodable;
    }
}

double VideoFile::stampedTime_s() {
    const double time_ms = m_capture->get(cv::CAP_PROP_POS_MSEC);
    if (m_read == 0) {
        m_first_ms = time_ms;
        return m_last_s = 0.0;
    }
    // Without time stamps a container gives 0; damaged ones go back or far ahead.
    const double stamped_s = (time_ms - m_first_ms) * 1e-3;
    const bool isUsable =
        std::isfinite(stamped_s) && stamped_s > m_last_s && (stamped_s - m_last_s) * m_rate_Hz < kLongestGap;
    return m_last_s = isUsable ? stamped_s : m_last_s + 1.0 / m_rate_Hz;
}

} // namespace teleta::python
