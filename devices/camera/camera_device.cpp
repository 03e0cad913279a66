// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_device.h"

#include "backend/core/device/backoff.h"

#include <QCoreApplication>
#include <QString>

#include <filesystem>
#include <utility>

namespace teleta::camera {

namespace {

struct CameraText {
    Q_DECLARE_TR_FUNCTIONS(CameraText)
};

using core::DeviceState;

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr std::int64_t kFullQueue_ns = 2 * kMs_ns; ///< how long a file waits for its consumer at a time

VideoStream::Options optionsOf(const CameraConfig& config) {
    return {.width_px = config.width_px,
            .height_px = config.height_px,
            .rate_Hz = config.rate_Hz,
            .channel = config.channel};
}

} // namespace

core::Expected<std::unique_ptr<CameraDevice>> CameraDevice::open(CameraConfig config) {
    TELETA_TRY(VideoStream stream, VideoStream::open(config.source, optionsOf(config)));
    core::CameraDescription description;
    description.recorded = !isCameraNumber(config.source);
    description.name = description.recorded ? std::filesystem::path(config.source).filename().string()
                                            : "/dev/video" + config.source;
    description.nominalRate_Hz = stream.rate_Hz();
    return std::unique_ptr<CameraDevice>(
        new CameraDevice(std::move(stream), std::move(description), std::move(config)));
}

CameraDevice::CameraDevice(VideoStream stream, core::CameraDescription description, CameraConfig config)
    : m_description(std::move(description))
    , m_config(std::move(config))
    , m_outlet(m_config.queueFrames)
    , m_wait(m_config.clock)
    , m_stream(std::move(stream)) {
}

void CameraDevice::open(core::Wakeup& consumer) {
    m_number = 0;
    m_undecodable = 0;
    m_outlet.open(consumer, now_ns());
}

void CameraDevice::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        if (!m_stream) { // started again
            if (const auto opened = openStream(); !opened) {
                reconnect(opened.error().message, stop);
                continue;
            }
        }
        const bool camera = m_stream->isCamera();
        std::string reason = stream(stop);
        const bool played = m_stream->framesRead() > 0;
        m_stream.reset();
        m_discontinuity = true;
        if (stop.stop_requested())
            break;
        if (camera) {
            reconnect(std::move(reason), stop);
        } else if (!m_config.loop || !played) {
            m_outlet.setState(DeviceState::finished, now_ns());
            break;
        }
    }
    if (m_outlet.state() != DeviceState::finished)
        m_outlet.setState(DeviceState::closed, now_ns());
}

std::string CameraDevice::stream(const std::stop_token& stop) {
    const std::int64_t begin_ns = now_ns();
    const bool camera = m_stream->isCamera();
    std::uint64_t skipped = 0;
    while (!stop.stop_requested()) {
        cv::Mat1b image;
        double capture_s = 0.0;
        const VideoStream::Outcome outcome = m_stream->next(image, capture_s);
        if (const std::uint64_t more = m_stream->framesSkipped() - skipped; more > 0) {
            skipped += more;
            m_outlet.lose(more);
        }
        switch (outcome) {
        case VideoStream::Outcome::late:
            continue;
        case VideoStream::Outcome::ended:
            return {};
        case VideoStream::Outcome::gone:
            return CameraText::tr("The camera stopped sending frames.").toStdString();
        case VideoStream::Outcome::undecodable:
            image.release();
            ++m_undecodable;
            m_outlet.lose(1);
            break;
        case VideoStream::Outcome::frame:
            break;
        }
        if (!camera && m_config.paced)
            m_wait.until(begin_ns + static_cast<std::int64_t>(capture_s * 1e9), stop);
        // As fast as possible, playing waits for the consumer and loses nothing.
        while (!camera && !m_config.paced && m_outlet.isFull() && !stop.stop_requested())
            m_wait.until(now_ns() + kFullQueue_ns, stop);
        if (!stop.stop_requested())
            deliver(std::move(image), capture_s);
    }
    return {};
}

void CameraDevice::deliver(cv::Mat1b image, double capture_s) {
    core::CameraFrame frame;
    frame.image = core::greyImageOf(std::move(image));
    frame.time_ns = now_ns();
    frame.capture_s = capture_s;
    frame.number = m_number++;
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::move(frame));
}

core::Expected<void> CameraDevice::openStream() {
    TELETA_TRY(m_stream, VideoStream::open(m_config.source, optionsOf(m_config)));
    return {};
}

void CameraDevice::reconnect(std::string reason, const std::stop_token& stop) {
    m_outlet.setState(DeviceState::lost, now_ns(), reason);
    core::Backoff retry(m_config.firstRetry_ms * kMs_ns, m_config.longestRetry_ms * kMs_ns);
    while (m_wait.until(now_ns() + retry.next_ns(), stop)) {
        m_outlet.setState(DeviceState::reconnecting, now_ns(), reason);
        const auto opened = openStream();
        if (opened) {
            m_outlet.setState(DeviceState::connecting, now_ns());
            return;
        }
        reason = opened.error().message;
    }
}

} // namespace teleta::camera
