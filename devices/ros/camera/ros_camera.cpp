// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/camera/ros_camera.h"

#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "devices/ros/camera/camera_message.h"

#include <utility>

namespace teleta::ros_camera {

namespace {

constexpr std::size_t kQueueFrames = 8;
/// The newest message alone is decoded.
constexpr int kReaderDepth = 1;

const dds_topic_descriptor_t& typeOf(PictureFormat format) {
    return format == PictureFormat::image ? ros::descriptorOf<ros::Image>()
                                          : ros::descriptorOf<ros::CompressedImage>();
}

} // namespace

core::Expected<std::unique_ptr<RosCamera>> RosCamera::open(RosCameraFile file) {
    TELETA_TRY(auto feed,
               ros_topic::TopicFeed::open(file.domain, file.topic, typeOf(file.format), kReaderDepth));
    return std::unique_ptr<RosCamera>(new RosCamera(std::move(file), std::move(feed)));
}

RosCamera::RosCamera(RosCameraFile file, std::unique_ptr<ros_topic::TopicFeed> feed)
    : m_file(std::move(file))
    , m_description{.name = m_file.name, .nominalRate_Hz = m_file.rate_Hz}
    , m_feed(std::move(feed))
    , m_outlet(kQueueFrames) {
}

void RosCamera::open(core::Wakeup& consumer) {
    m_counters = {};
    m_published.set(m_counters);
    m_misfit.clear();
    m_clock = {};
    m_outlet.open(consumer, core::steadyNow_ns());
}

void RosCamera::run(const std::stop_token& stop) {
    const std::int64_t staleAfter_ns = core::staleAfter_ns(m_file.rate_Hz);
    const std::int64_t start_ns = core::steadyNow_ns();
    while (!stop.stop_requested()) {
        m_feed->wait();
        takeAll();
        const std::int64_t now_ns = core::steadyNow_ns();
        const core::DeviceState state = m_outlet.state();
        if (now_ns - m_clock.lastRead_ns().value_or(start_ns) > staleAfter_ns)
            m_outlet.setState(state == core::DeviceState::connecting ? state : core::DeviceState::stale,
                              now_ns, m_feed->silence(m_misfit));
    }
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
    m_discontinuity = true;
}

void RosCamera::takeAll() {
    const std::uint64_t misfits = m_counters.misfits;
    m_feed->take([this](const void* message) {
        if (m_file.format == PictureFormat::image)
            take(*static_cast<const ros::Image*>(message));
        else
            take(*static_cast<const ros::CompressedImage*>(message));
    });
    if (m_counters.misfits > misfits)
        m_outlet.lose(m_counters.misfits - misfits);
    m_counters.oddStamps = m_clock.oddStamps();
    if (m_published.get() != m_counters)
        m_published.set(m_counters);
}

template <typename Message>
void RosCamera::take(const Message& message) {
    const std::int64_t read_ns = core::steadyNow_ns();
    ++m_counters.messages;
    auto picture = pictureOf(message);
    if (!picture) {
        ++m_counters.misfits;
        m_misfit = picture.error().message;
        return;
    }
    m_misfit.clear();
    core::CameraFrame frame;
    frame.image = core::bytesOf(std::move(*picture));
    frame.time_ns = read_ns;
    frame.capture_s = m_clock.at(&message.header.stamp, read_ns);
    frame.number = m_counters.pictures++;
    frame.discontinuity = std::exchange(m_discontinuity, false);
    m_outlet.deliver(std::move(frame));
}

} // namespace teleta::ros_camera
