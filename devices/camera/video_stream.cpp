// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/video_stream.h"

#include "backend/core/device/node_claim.h"
#include "backend/core/failure.h"
#include "backend/core/file_descriptor.h"
#include "backend/core/steady_time.h"
#include "backend/opencv/opencv_parts.h"

#include <QCoreApplication>
#include <QString>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <linux/videodev2.h>
#include <optional>
#include <sys/ioctl.h>
#include <vector>

namespace teleta::camera {

namespace {

struct VideoText {
    Q_DECLARE_TR_FUNCTIONS(Camera)
};

constexpr double kUnknownRate_Hz = 30.0;
constexpr int kMostFailures = 25; ///< pictures in a row that cannot be decoded are the end of a file
constexpr double kHighestRate_Hz = 10000.0;
constexpr double kLongestGap = 1e6; ///< frames; what is longer is a damaged time stamp

/// OpenCV waits ten seconds for a frame of a camera that hangs, which also delays stopping it. It reads the
/// variable at the first frame; it is set before any thread reads the environment.
const bool kWaitIsLimited [[maybe_unused]] =
    ::setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", std::to_string(VideoStream::kLongestWait_s).c_str(), 0) ==
    0;

/// Problems are returned as errors; OpenCV would log them as well. To debug OpenCV, set its variable.
const bool kIsQuiet [[maybe_unused]] = [] {
    if (std::getenv("OPENCV_LOG_LEVEL") == nullptr)
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    return true;
}();

std::optional<int> cameraNumber(const std::string& source) {
    int number = 0;
    const auto [end, error] = std::from_chars(source.data(), source.data() + source.size(), number);
    if (error != std::errc() || end != source.data() + source.size() || number < 0)
        return std::nullopt;
    return number;
}

/// In OpenCV's order: blue, green, red.
int indexOf(VideoChannel channel) {
    return channel == VideoChannel::blue ? 0 : channel == VideoChannel::green ? 1 : 2;
}

/// Red, green and blue side by side.
cv::Mat1b colourBytes(const cv::Mat& image) {
    cv::Mat rgb;
    cv::cvtColor(image, rgb,
                 image.channels() == 1   ? cv::COLOR_GRAY2RGB
                 : image.channels() == 4 ? cv::COLOR_BGRA2RGB
                                         : cv::COLOR_BGR2RGB);
    return rgb.reshape(1);
}

core::FileDescriptor openNode(int number, int flags) {
    return core::FileDescriptor(
        ::open(("/dev/video" + std::to_string(number)).c_str(), O_RDWR | O_CLOEXEC | flags));
}

/// Size of a camera's pictures with its present settings; empty: unknown.
cv::Size ownSize(int number) {
    const core::FileDescriptor node = openNode(number, 0);
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (!node.isOpen() || ::ioctl(node.get(), VIDIOC_G_FMT, &format) != 0)
        return {};
    return {static_cast<int>(format.fmt.pix.width), static_cast<int>(format.fmt.pix.height)};
}

/// Why a camera does not open: while one program reads it, no other can change its format.
bool isTaken(int number) {
    const core::FileDescriptor node = openNode(number, O_NONBLOCK);
    if (!node.isOpen())
        return errno == EBUSY;
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    v4l2_requestbuffers buffers{};
    buffers.count = 1;
    buffers.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffers.memory = V4L2_MEMORY_MMAP;
    const auto refused = [&node](unsigned long request, void* argument) {
        return ::ioctl(node.get(), request, argument) != 0 && errno == EBUSY;
    };
    return (::ioctl(node.get(), VIDIOC_G_FMT, &format) == 0 && refused(VIDIOC_S_FMT, &format)) ||
           refused(VIDIOC_REQBUFS, &buffers);
}

core::Unexpected failed(core::ErrorKind kind, const QString& message, const QString& expected,
                        const std::string& source) {
    return core::failed(kind, message, expected, {source, 0, 0});
}

} // namespace

bool isCameraNumber(const std::string& source) {
    return cameraNumber(source).has_value();
}

core::Expected<VideoStream> VideoStream::open(const std::string& source, const Options& options) {
    VideoStream stream;
    stream.m_channel = options.channel;
    try {
        if (const std::optional<int> number = cameraNumber(source)) {
            TELETA_TRY(stream.m_capture, opencv::videoCapture());
            stream.m_isCamera = true;
            // Without a size OpenCV asks for 640 x 480.
            cv::Size size(options.width_px, options.height_px);
            if (size.empty())
                size = ownSize(*number);
            std::vector<int> wanted;
            if (!size.empty())
                wanted = {cv::CAP_PROP_FRAME_WIDTH, size.width, cv::CAP_PROP_FRAME_HEIGHT, size.height};
            stream.m_capture->open(*number, cv::CAP_V4L2, wanted);
            if (!stream.m_capture->isOpened() && isTaken(*number))
                return core::usedByAnother(VideoText::tr("camera %1").arg(*number).toStdString());
            if (!stream.m_capture->isOpened())
                return failed(core::ErrorKind::unavailable,
                              VideoText::tr("camera %1 cannot be opened").arg(*number), {}, source);
            if (options.rate_Hz > 0.0)
                stream.m_capture->set(cv::CAP_PROP_FPS, options.rate_Hz);
        } else {
            std::error_code ignored;
            if (source.find('%') == std::string::npos && !std::filesystem::exists(source, ignored))
                return failed(core::ErrorKind::notFound, VideoText::tr("the file does not exist"), {},
                              source);
            if (std::filesystem::is_fifo(source, ignored))
                return failed(core::ErrorKind::badInput, VideoText::tr("this is a pipe"),
                              VideoText::tr("a video, or the number of a camera"), source);
            if (std::filesystem::is_directory(source, ignored))
                return failed(core::ErrorKind::badInput, VideoText::tr("this is a folder"),
                              VideoText::tr("a video, or the number of a camera"), source);
            TELETA_TRY(stream.m_capture, opencv::videoCapture());
            stream.m_capture->open(source, cv::CAP_ANY);
            if (!stream.m_capture->isOpened())
                return failed(
                    core::ErrorKind::badInput, VideoText::tr("the file is not a readable video"),
                    VideoText::tr("a video, a pattern like frame_%04d.png, or the number of a camera"),
                    source);
        }
        const double rate_Hz = stream.m_capture->get(cv::CAP_PROP_FPS);
        stream.m_rate_Hz = rate_Hz > 0.0 && rate_Hz < kHighestRate_Hz ? rate_Hz : 0.0;
        const double total = stream.m_isCamera ? 0.0 : stream.m_capture->get(cv::CAP_PROP_FRAME_COUNT);
        stream.m_total = total > 0.0 && total < 1e12 ? static_cast<std::uint64_t>(total) : 0;
    } catch (const cv::Exception& error) {
        return failed(core::ErrorKind::badInput, QString::fromStdString(error.err), {}, source);
    }
    return stream;
}

VideoStream::Outcome VideoStream::next(cv::Mat1b& frame, double& time_s) {
    try {
        const std::int64_t asked_ns = core::steadyNow_ns();
        if (m_asked_ns == 0)
            m_asked_ns = asked_ns;
        if (!m_capture->grab()) {
            if (m_isCamera && m_read == 0 && isEarly(asked_ns, core::steadyNow_ns()))
                return Outcome::late;
            // OpenCV takes a damaged picture for the end; the file tells how many there should be.
            if (m_isCamera || m_read >= m_total || ++m_failures > kMostFailures)
                return m_isCamera ? Outcome::gone : Outcome::ended;
            time_s = m_last_s += m_read == 0 ? 0.0 : 1.0 / (m_rate_Hz > 0.0 ? m_rate_Hz : kUnknownRate_Hz);
            ++m_read;
            return Outcome::undecodable;
        }
        m_failures = 0;
        time_s = captureTime_s();
        ++m_read;
        if (!m_capture->retrieve(m_image) || m_image.empty() || m_image.depth() != CV_8U)
            return Outcome::undecodable;
        if (m_channel == VideoChannel::colour)
            frame = colourBytes(m_image);
        else if (m_image.channels() == 1)
            m_image.copyTo(frame);
        else if (m_channel != VideoChannel::grey)
            cv::extractChannel(m_image, frame, indexOf(m_channel));
        else
            cv::cvtColor(m_image, frame, m_image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
        return Outcome::frame;
    } catch (const cv::Exception&) {
        time_s = m_last_s;
        if (++m_failures > kMostFailures)
            return m_isCamera ? Outcome::gone : Outcome::ended;
        return Outcome::undecodable;
    }
}

/// A camera that is gone fails at once; one that starts slowly keeps the reader waiting.
bool VideoStream::isEarly(std::int64_t asked_ns, std::int64_t now_ns) const {
    return core::elapsed_s(asked_ns, now_ns) > 0.5 * kLongestWait_s &&
           core::elapsed_s(m_asked_ns, now_ns) < kLongestFirstWait_s;
}

double VideoStream::captureTime_s() {
    const double time_ms = m_capture->get(cv::CAP_PROP_POS_MSEC);
    const double rate_Hz = m_rate_Hz > 0.0 ? m_rate_Hz : kUnknownRate_Hz;
    if (m_read == 0) {
        m_first_ms = time_ms;
        m_last_s = 0.0;
        return 0.0;
    }
    // Without timestamps a container gives 0; damaged ones go back or far ahead.
    const double stamped_s = (time_ms - m_first_ms) * 1e-3;
    if (!std::isfinite(stamped_s) || stamped_s <= m_last_s ||
        (stamped_s - m_last_s) * rate_Hz >= kLongestGap) {
        m_last_s += 1.0 / rate_Hz;
        return m_last_s;
    }
    if (const double periods = (stamped_s - m_last_s) * m_rate_Hz; periods > 1.5)
        m_skipped += static_cast<std::uint64_t>(std::lround(periods)) - 1;
    m_last_s = stamped_s;
    return m_last_s;
}

} // namespace teleta::camera
