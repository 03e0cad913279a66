// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/recording/stream_sink.h"
#include "backend/ros/messages.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace teleta::ros_arm {

/// The topic of an array's frames, "/pad/tactile_state" of the stream "pad-frames"; empty: another stream.
[[nodiscard]] std::string tactileTopicOf(const recording::StreamInfo& stream);

/// Sends the frames of arrays to ROS 2 programs, as tactile_msgs/TactileState: one topic an array, one sensor
/// a message with the array's name and its values in their order (row by row; of vectors x, y, z of each
/// taxel), as the device tells them, without tare and gains. The stamp is this computer's wall clock at the
/// read. Other streams are not sent. Thread: any; a thread of its own sends, data threads never wait.
class TactilePublisher : public recording::StreamSink {
public:
    static constexpr std::int64_t kPoll_ns = 4'000'000;

    /// frames: frame_id of each array's header, by its name; an array without one has its own name there.
    /// reliable: for readers that ask for it, which a best-effort writer does not match.
    TactilePublisher(std::shared_ptr<const dds::Participant> participant,
                     std::map<std::string, std::string> frames, bool reliable);
    ~TactilePublisher() override;

    [[nodiscard]] std::shared_ptr<core::StreamTap> addStream(recording::StreamInfo info) override;
    void add(recording::RecordingEvent) override {}

    /// Why a topic could not be opened; empty: none failed.
    [[nodiscard]] std::optional<core::Error> failure() const;

private:
    struct Array {
        std::string name;
        std::string frame;
        std::size_t values = 0; ///< of a frame
        std::shared_ptr<core::StreamTap> tap;
        dds::Writer<ros::TactileState> writer;
    };

    void run(const std::stop_token& stop);
    static void send(Array& array);

    std::shared_ptr<const dds::Participant> m_participant;
    std::map<std::string, std::string> m_frames;
    bool m_reliable;
    mutable std::mutex m_mutex;
    std::vector<std::unique_ptr<Array>> m_arrays; ///< grows only
    std::optional<core::Error> m_failure;
    std::jthread m_thread;
};

} // namespace teleta::ros_arm
