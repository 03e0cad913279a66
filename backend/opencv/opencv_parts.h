// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>
#include <opencv2/videoio.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace teleta::opencv {

/// OpenCV's files of pictures. The functions throw cv::Exception as those of OpenCV do.
struct Pictures {
    /// cv::imwrite
    bool (*write)(const std::string& path, const cv::Mat& picture);
    /// cv::imdecode; flags: cv::ImreadModes
    cv::Mat (*decode)(const cv::Mat& bytes, int flags);
    /// cv::imencode; extension: with its dot; parameters: pairs of cv::ImwriteFlags and a value
    bool (*encode)(const std::string& extension, const cv::Mat& picture, std::vector<std::uint8_t>& bytes,
                   const std::vector<int>& parameters);
};

/// Loads them at the first call. Error: unavailable. Thread: any.
[[nodiscard]] core::Expected<const Pictures*> pictures();

/// A cv::VideoCapture that is not open yet. Its methods are virtual, so that who uses it links nothing.
/// Loads FFmpeg, GStreamer and others at the first call. Error: unavailable. Thread: any.
[[nodiscard]] core::Expected<std::unique_ptr<cv::VideoCapture>> videoCapture();

/// cv::DISOpticalFlow::create; preset: one of its constants.
/// Loads OpenCV's library at the first call. Error: unavailable. Thread: any.
[[nodiscard]] core::Expected<cv::Ptr<cv::DISOpticalFlow>> denseFlow(int preset);

} // namespace teleta::opencv
