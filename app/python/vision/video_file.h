// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace teleta::python {

/// Grey pictures of a video file, or of numbered images (frame_%04d.png), with the times of the file; where
/// these do not rise, the number of the picture over the rate. Thread: one.
class VideoFile {
public:
    /// Error: notFound, badInput: no video.
    [[nodiscard]] static core::Expected<VideoFile> open(const std::string& path);

    enum class Outcome {
        picture,
        undecodable, ///< there was one, but it could not be decoded
        ended,
    };
    /// picture: changed only when there is one.
    [[nodiscard]] Outcome next(cv::Mat1b& picture, double& time_s);

private:
    [[nodiscard]] double stampedTime_s();

    std::unique_ptr<cv::VideoCapture> m_capture;
    cv::Mat m_image;
    double m_rate_Hz = 0.0;
    std::uint64_t m_total = 0; ///< 0: unknown
    std::uint64_t m_read = 0;
    int m_failures = 0; ///< in a row
    double m_first_ms = 0.0;
    double m_last_s = 0.0;
};

} // namespace teleta::python
