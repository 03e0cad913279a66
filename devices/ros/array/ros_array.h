// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/ros/source_clock.h"
#include "devices/ros/array/ros_array_file.h"
#include "devices/ros/topic/topic_feed.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::ros_array {

/// What came on the topic since the source was started.
struct RosArrayCounters {
    std::uint64_t messages = 0;
    std::uint64_t frames = 0;    ///< that were of this array
    std::uint64_t misfits = 0;   ///< messages that do not fit the file
    std::uint64_t oddStamps = 0; ///< zero, the same as the one before, or before it

    bool operator==(const RosArrayCounters&) const = default;
};

/// A tactile array over ROS 2.
///   connecting -> live <-> stale; stop(): closed
/// A message that does not fit the file is no frame; the status says in what. Source time is that of the
/// stamps, from the first message; where there is none, or it does not rise, our clock goes on.
/// Thread: as core::TactileSource; counters() from any.
class RosArray : public core::TactileSource {
public:
    /// Joins the domain. Error: as ros_topic::TopicFeed::open().
    [[nodiscard]] static core::Expected<std::unique_ptr<RosArray>> open(RosArrayFile file);

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override { return m_outlet.blocks(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }

    [[nodiscard]] RosArrayCounters counters() const { return m_published.get(); }

private:
    friend core::DeviceThread<RosArray>;
    RosArray(RosArrayFile file, std::unique_ptr<ros_topic::TopicFeed> feed);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_feed->wake(); }
    template <typename Message>
    void take(const Message& message);
    void takeAll();
    void deliver(const ros::Time* stamp, std::int64_t read_ns);
    [[nodiscard]] std::string silence() const;

    RosArrayFile m_file;
    core::SourceDescription m_description;
    std::unique_ptr<ros_topic::TopicFeed> m_feed;
    core::SourceOutlet m_outlet;
    core::LatestCopy<RosArrayCounters> m_published;

    // The worker's own.
    RosArrayCounters m_counters;
    std::vector<float> m_loads;
    core::SampleBlock m_block; ///< what one look at the topic brings
    std::string m_misfit;      ///< why the newest message is no frame; empty: it is one
    ros::SourceClock m_clock;  ///< of the frames
    bool m_discontinuity = false;

    core::DeviceThread<RosArray> m_thread{*this};
};

} // namespace teleta::ros_array
