// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/camera_worker.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <utility>

namespace teleta::camera {

namespace {

struct CameraText {
    Q_DECLARE_TR_FUNCTIONS(CameraText)
};

using core::DeviceState;

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr std::int64_t kFullQueue_ns = 2 * kMs_ns; ///< how long a file waits for its consumer at a time

} // namespace

CameraWorker::CameraWorker(VideoStream stream, CameraConfig config)
    : m_config(std::move(config))
    , m_frames(m_config.queueFrames)
    , m_stream(std::move(stream)) {
}

void CameraWorker::open(core::Wakeup& consumer) {
    m_consumer = &consumer;
    m_status = {};
    m_number = 0;
    m_undecodable = 0;
    m_skipped = 0;
    m_rate.reset();
    enter(DeviceState::connecting);
}

void CameraWorker::wake() {
    const std::scoped_lock lock(m_mutex);
    m_condition.notify_all();
}

void CameraWorker::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        if (!m_stream) { // started again
            auto opened =
                VideoStream::open(m_config.source, {m_config.width_px, m_config.height_px, m_config.rate_Hz});
            if (!opened) {
                reconnect(opened.error().message, stop);
                continue;
            }
            m_stream = std::move(*opened);
        }
        const bool camera = m_stream->isCamera();
        std::string reason = stream(stop);
        const bool played = m_stream->framesRead() > 0;
        m_skipped += m_stream->framesSkipped();
        m_stream.reset();
        m_discontinuity = true;
        if (stop.stop_requested())
            break;
        if (camera) {
            reconnect(std::move(reason), stop);
        } else if (!m_config.loop || !played) {
            enter(DeviceState::finished);
            break;
        }
    }
    if (m_status.state != DeviceState::finished)
        enter(DeviceState::closed);
}

std::string CameraWorker::stream(const std::stop_token& stop) {
    const std::int64_t begin_ns = now_ns();
    const bool camera = m_stream->isCamera();
    while (!stop.stop_requested()) {
        cv::Mat1b image;
        double capture_s = 0.0;
        switch (m_stream->next(image, capture_s)) {
        case VideoStream::Outcome::late:
            continue;
        case VideoStream::Outcome::ended:
            return {};
        case VideoStream::Outcome::gone:
            return CameraText::tr("The camera gives no frames any more.").toStdString();
        case VideoStream::Outcome::undecodable:
            image.release();
            ++m_undecodable;
            break;
        case VideoStream::Outcome::frame:
            break;
        }
        if (!camera && m_config.paced)
            waitUntil(begin_ns + static_cast<std::int64_t>(capture_s * 1e9), stop);
        // What is played as fast as it is taken loses nothing.
        while (!camera && !m_config.paced && m_frames.size() >= m_frames.capacity() && !stop.stop_requested())
            waitUntil(now_ns() + kFullQueue_ns, stop);
        if (!stop.stop_requested())
            deliver(std::move(image), capture_s);
    }
    return {};
}

void CameraWorker::deliver(cv::Mat1b image, double capture_s) {
    core::CameraFrame frame;
    frame.image = core::greyImageOf(std::move(image));
    frame.time_ns = now_ns();
    frame.capture_s = capture_s;
    frame.number = m_number++;
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_status.lastData_ns = frame.time_ns;
    ++m_status.framesRead;
    m_rate.add(frame.time_ns);
    m_frames.push(std::move(frame));
    if (m_status.state != DeviceState::live)
        enter(DeviceState::live);
    else
        publish();
}

void CameraWorker::reconnect(std::string reason, const std::stop_token& stop) {
    enter(DeviceState::lost, reason);
    int retry_ms = m_config.firstRetry_ms;
    while (!stop.stop_requested()) {
        waitUntil(now_ns() + retry_ms * kMs_ns, stop);
        retry_ms = std::min(2 * retry_ms, m_config.longestRetry_ms);
        if (stop.stop_requested())
            return;
        enter(DeviceState::reconnecting, reason);
        auto opened =
            VideoStream::open(m_config.source, {m_config.width_px, m_config.height_px, m_config.rate_Hz});
        if (opened) {
            m_stream = std::move(*opened);
            enter(DeviceState::connecting);
            return;
        }
        reason = opened.error().message;
    }
}

void CameraWorker::waitUntil(std::int64_t deadline_ns, const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    while (!stop.stop_requested() && now_ns() < deadline_ns)
        m_config.clock->waitUntil(m_condition, lock, deadline_ns);
}

void CameraWorker::enter(DeviceState state, std::string message) {
    m_status.state = state;
    m_status.since_ns = now_ns();
    m_status.message = std::move(message);
    if (state != DeviceState::live)
        m_rate.reset();
    publish();
}

void CameraWorker::publish() {
    m_status.rate_Hz = m_rate.rate_Hz(m_status.lastData_ns);
    m_status.framesLost = m_undecodable + m_skipped + (m_stream ? m_stream->framesSkipped() : 0);
    m_published.set(m_status);
    m_publishedUndecodable.set(m_undecodable);
    if (m_consumer != nullptr)
        m_consumer->notify();
}

} // namespace teleta::camera
