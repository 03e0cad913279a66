// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace teleta::camera {

/// What becomes the grey level of a pixel. colour: nothing, frames have the bytes of core::ColourImage.
enum class VideoChannel { grey, red, green, blue, colour };

/// Frames, grey or in colour, of a camera (V4L2) or of a file that OpenCV reads, with their capture times:
/// the driver's or the file's, or where those do not rise, the number of the frame over the rate. Thread:
/// one.
class VideoStream {
public:
    struct Options {
        int width_px = 0; ///< asked of a camera; 0: its own
        int height_px = 0;
        double rate_Hz = 0.0;
        VideoChannel channel = VideoChannel::grey; ///< of coloured pictures
    };
    /// source: a file, a pattern of numbered images, or the number of a camera.
    /// Error: notFound, badInput (no video), unavailable (a camera that does not open).
    [[nodiscard]] static core::Expected<VideoStream> open(const std::string& source, const Options& options);
    [[nodiscard]] static core::Expected<VideoStream> open(const std::string& source) {
        return open(source, {});
    }

    /// For a frame of a camera, unless the variable OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT (seconds) is set.
    static constexpr int kLongestWait_s = 2;
    /// For the first one: a camera may have to wake up and find its exposure.
    static constexpr int kLongestFirstWait_s = 10;

    enum class Outcome {
        frame,
        undecodable, ///< there was a frame, but it could not be decoded
        ended,       ///< of a file
        late,        ///< the first frame of a camera has not arrived yet: ask again
        gone,        ///< the camera sends no frames any more, or none for kLongestWait_s
    };
    /// Waits for the next frame. frame: changed only when there is one.
    [[nodiscard]] Outcome next(cv::Mat1b& frame, double& time_s);

    [[nodiscard]] bool isCamera() const { return m_isCamera; }
    [[nodiscard]] double rate_Hz() const { return m_rate_Hz; }          ///< 0: unknown
    [[nodiscard]] std::uint64_t framesTotal() const { return m_total; } ///< 0: unknown
    [[nodiscard]] std::uint64_t framesRead() const { return m_read; }
    /// Frames that are missing according to the timestamps: the decoder skipped them, or the driver dropped
    /// them. 0 when the rate is unknown.
    [[nodiscard]] std::uint64_t framesSkipped() const { return m_skipped; }

private:
    VideoStream() = default;
    [[nodiscard]] double captureTime_s();
    [[nodiscard]] bool isEarly(std::int64_t asked_ns, std::int64_t now_ns) const;

    std::unique_ptr<cv::VideoCapture> m_capture;
    cv::Mat m_image;
    bool m_isCamera = false;
    VideoChannel m_channel = VideoChannel::grey;
    double m_rate_Hz = 0.0;
    std::uint64_t m_total = 0;
    std::uint64_t m_read = 0; ///< also those that could not be decoded
    std::uint64_t m_skipped = 0;
    int m_failures = 0;          ///< in a row
    std::int64_t m_asked_ns = 0; ///< for the first frame; 0: not yet
    double m_first_ms = 0.0;
    double m_last_s = 0.0;
};

/// Whether a source names a connected camera, by its number, and not a file.
[[nodiscard]] bool isCameraNumber(const std::string& source);

} // namespace teleta::camera
