// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/publish/tactile_publisher.h"

#include "backend/core/steady_time.h"
#include "backend/ros/qos_profile.h"
#include "backend/ros/stamps.h"
#include "backend/ros/topic_names.h"
#include "devices/ros/wall_clock.h"

#include <chrono>
#include <span>
#include <string_view>
#include <utility>

namespace teleta::ros_arm {

namespace {

/// A second of an array at 200 Hz, frame by frame.
constexpr std::size_t kTapBlocks = 256;
constexpr std::string_view kFramesEnd = "-frames";
constexpr int kQueueDepth = 5;
constexpr double kLongestBlock_s = 0.005;

std::string nameOf(const recording::StreamInfo& stream) {
    const std::string_view name = stream.name;
    if (stream.kind != recording::StreamKind::array || !name.ends_with(kFramesEnd))
        return {};
    return std::string(name.substr(0, name.size() - kFramesEnd.size()));
}

} // namespace

std::string tactileTopicOf(const recording::StreamInfo& stream) {
    const std::string name = nameOf(stream);
    return name.empty() ? name : '/' + name + "/tactile_state";
}

TactilePublisher::TactilePublisher(std::shared_ptr<const dds::Participant> participant,
                                   std::map<std::string, std::string> frames, bool reliable)
    : m_participant(std::move(participant))
    , m_frames(std::move(frames))
    , m_reliable(reliable)
    , m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

TactilePublisher::~TactilePublisher() {
    m_thread.request_stop();
    m_thread.join();
    for (const auto& array : m_arrays)
        array->tap->close();
}

std::shared_ptr<core::StreamTap> TactilePublisher::addStream(recording::StreamInfo info) {
    auto tap = std::make_shared<core::StreamTap>(kTapBlocks);
    const std::string topic = tactileTopicOf(info);
    if (topic.empty() || info.type != recording::ValueType::float32) {
        tap->close();
        return tap;
    }
    const ros::QosProfile profile =
        m_reliable ? ros::QosProfile{ros::Reliability::reliable, ros::Durability::volatileData, kQueueDepth,
                                     kLongestBlock_s}
                   : ros::kSensorWriter;
    auto writer = dds::Writer<ros::TactileState>::open(m_participant, ros::ddsTopicOf(topic), profile);
    const std::scoped_lock lock(m_mutex);
    if (!writer) {
        m_failure = writer.error();
        tap->close();
        return tap;
    }
    const std::string name = nameOf(info);
    const auto frame = m_frames.find(name);
    m_arrays.push_back(std::make_unique<Array>(Array{name, frame == m_frames.end() ? name : frame->second,
                                                     info.channels(), tap, std::move(*writer)}));
    return tap;
}

std::optional<core::Error> TactilePublisher::failure() const {
    const std::scoped_lock lock(m_mutex);
    return m_failure;
}

void TactilePublisher::run(const std::stop_token& stop) {
    std::vector<Array*> known;
    while (!stop.stop_requested()) {
        {
            const std::scoped_lock lock(m_mutex);
            for (std::size_t i = known.size(); i < m_arrays.size(); ++i)
                known.push_back(m_arrays[i].get());
        }
        for (Array* array : known)
            send(*array);
        std::this_thread::sleep_for(std::chrono::nanoseconds(kPoll_ns));
    }
}

void TactilePublisher::send(Array& array) {
    const std::int64_t toWall_ns = wallClock_ns() - core::steadyNow_ns();
    core::TappedFrames block;
    for (std::size_t left = array.tap->capacity(); left > 0 && array.tap->pop(block); --left) {
        const std::span<float> values(reinterpret_cast<float*>(block.values.data()),
                                      block.values.size() / sizeof(float));
        for (std::size_t i = 0; i < block.frames(); ++i) {
            ::sensor_msgs_msg_dds__ChannelFloat32_ sensor{};
            sensor.name = array.name.data();
            ros::lend(sensor.values, values.subspan(i * array.values, array.values));
            ros::TactileState message{};
            message.header.stamp = ros::stampOf(block.time_ns[i] + toWall_ns);
            message.header.frame_id = array.frame.data();
            ros::lend(message.sensors, std::span(&sensor, 1));
            (void)array.writer.write(message);
        }
    }
}

} // namespace teleta::ros_arm
