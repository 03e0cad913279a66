// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_list.h"

#include "backend/core/failure.h"
#include "backend/core/file_descriptor.h"
#include "backend/core/steady_time.h"
#include "devices/camera/video_stream.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <system_error>

namespace teleta::camera {

namespace {

struct ListText {
    Q_DECLARE_TR_FUNCTIONS(Camera)
};

constexpr std::string_view kPrefix = "video";
constexpr std::int64_t kMeasure_ns = 1'000'000'000;
constexpr int kMostUndecodable = 25; ///< frames before the first good one

std::optional<int> nodeNumber(const std::string& name) {
    int number = 0;
    if (!name.starts_with(kPrefix))
        return std::nullopt;
    const char* const end = name.data() + name.size();
    const auto [last, error] = std::from_chars(name.data() + kPrefix.size(), end, number);
    return error == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

/// Empty: it is not a camera.
std::optional<CameraInfo> ask(int number) {
    CameraInfo info{.number = number, .name = {}};
    const std::string path = "/dev/video" + std::to_string(number);
    const core::FileDescriptor node(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
    if (!node.isOpen()) {
        info.error = core::Error{
            core::ErrorKind::unavailable, std::generic_category().message(errno), {}, {path, 0, 0}};
        return info;
    }
    v4l2_capability capability{};
    if (::ioctl(node.get(), VIDIOC_QUERYCAP, &capability) != 0)
        return std::nullopt;
    const std::uint32_t can = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? capability.device_caps
                                                                                    : capability.capabilities;
    if ((can & (V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_VIDEO_CAPTURE_MPLANE)) == 0)
        return std::nullopt;
    const char* const card = reinterpret_cast<const char*>(capability.card);
    info.name.assign(card, ::strnlen(card, sizeof capability.card));
    return info;
}

} // namespace

std::vector<CameraInfo> listCameras() {
    std::vector<int> numbers;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/dev", ignored)) {
        if (const auto number = nodeNumber(entry.path().filename().string()))
            numbers.push_back(*number);
    }
    std::ranges::sort(numbers);
    std::vector<CameraInfo> cameras;
    for (const int number : numbers) {
        if (auto info = ask(number))
            cameras.push_back(std::move(*info));
    }
    return cameras;
}

core::Expected<CameraProbe> probeCamera(const std::string& source, int width_px, int height_px,
                                        double rate_Hz) {
    auto stream =
        VideoStream::open(source, {.width_px = width_px, .height_px = height_px, .rate_Hz = rate_Hz});
    TELETA_CHECK(stream);
    CameraProbe probe{.nominalRate_Hz = stream->rate_Hz()};
    std::int64_t first_ns = 0;
    std::uint64_t frames = 0;
    std::int64_t now_ns = core::steadyNow_ns();
    for (int undecodable = 0; undecodable < kMostUndecodable;) {
        cv::Mat1b image;
        double time_s = 0.0;
        const VideoStream::Outcome outcome = stream->next(image, time_s);
        now_ns = core::steadyNow_ns();
        if (outcome == VideoStream::Outcome::ended || outcome == VideoStream::Outcome::gone)
            break;
        if (outcome == VideoStream::Outcome::late)
            continue;
        if (outcome == VideoStream::Outcome::undecodable) {
            ++undecodable;
            continue;
        }
        if (frames++ == 0) {
            first_ns = now_ns;
            probe.width_px = image.cols;
            probe.height_px = image.rows;
        }
        if (!stream->isCamera() || now_ns - first_ns > kMeasure_ns)
            break;
    }
    if (frames == 0)
        return core::failed(core::ErrorKind::unavailable, ListText::tr("no frame arrived"), {},
                            {source, 0, 0});
    if (stream->isCamera() && frames > 1)
        probe.measuredRate_Hz =
            1e9 * static_cast<double>(frames - 1) / static_cast<double>(now_ns - first_ns);
    return probe;
}

} // namespace teleta::camera
