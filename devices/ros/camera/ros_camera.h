// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_outlet.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/ros/source_clock.h"
#include "devices/ros/camera/ros_camera_file.h"
#include "devices/ros/topic/topic_feed.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

namespace teleta::ros_camera {

/// What came on the topic since the source was started.
struct RosCameraCounters {
    std::uint64_t messages = 0;
    std::uint64_t pictures = 0;
    std::uint64_t misfits = 0;   ///< messages without a picture that can be shown
    std::uint64_t oddStamps = 0; ///< zero, the same as the one before, or before it

    bool operator==(const RosCameraCounters&) const = default;
};

/// A camera over ROS 2. Its frames are colour pictures, see core::colourOf().
///   connecting -> live <-> stale; stop(): closed
/// The newest message wins: what a busy thread did not take in time is replaced by what came after it. A
/// message that is no picture is a lost frame; the status says what is wrong with it. Capture times are those
/// of the stamps, from the first picture; where there is none, or it does not rise, our clock goes on.
/// Thread: as core::CameraSource; counters() from any.
class RosCamera : public core::CameraSource {
public:
    /// Joins the domain. Error: as ros_topic::TopicFeed::open().
    [[nodiscard]] static core::Expected<std::unique_ptr<RosCamera>> open(RosCameraFile file);

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    bool pop(core::CameraFrame& frame) override { return m_outlet.frames().pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    [[nodiscard]] RosCameraCounters counters() const { return m_published.get(); }

private:
    friend core::DeviceThread<RosCamera>;
    RosCamera(RosCameraFile file, std::unique_ptr<ros_topic::TopicFeed> feed);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_feed->wake(); }
    void takeAll();
    template <typename Message>
    void take(const Message& message);

    RosCameraFile m_file;
    core::CameraDescription m_description;
    std::unique_ptr<ros_topic::TopicFeed> m_feed;
    core::CameraOutlet m_outlet;
    core::LatestCopy<RosCameraCounters> m_published;

    // The worker's own.
    RosCameraCounters m_counters;
    std::string m_misfit;     ///< why the newest message is no picture; empty: it is one
    ros::SourceClock m_clock; ///< of the pictures
    bool m_discontinuity = false;

    core::DeviceThread<RosCamera> m_thread{*this};
};

} // namespace teleta::ros_camera
