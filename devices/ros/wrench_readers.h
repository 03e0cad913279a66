// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"
#include "backend/ros/qos_profile.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/ros/frame_readers.h"
#include "devices/ros/wrench_watch.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace teleta::ros_arm {

/// What a WrenchWatch is told: the messages of a sensor of force and torque, and the frames that hang on the
/// robot, still or moving. Thread: one.
struct WrenchReaders {
    /// depth: messages that wait. Error: unavailable, a topic cannot be opened.
    [[nodiscard]] static core::Expected<WrenchReaders>
    open(const std::shared_ptr<const dds::Participant>& participant, const RosWrenchFile& file, int depth) {
        TELETA_TRY(auto forces,
                   dds::Reader<ros::WrenchStamped>::open(participant, ros::ddsTopicOf(file.topic),
                                                         ros::kSensorReader.withDepth(depth)));
        TELETA_TRY(auto frames, FrameReaders::open(participant));
        return WrenchReaders{std::move(forces), std::move(frames)};
    }

    /// Gives frames to the watch, then each message; taken() is called after each of them.
    template <typename Taken>
    void take(WrenchWatch& watch, const Taken& taken) {
        frames.take(watch);
        (void)wrench.take([&](const ros::WrenchStamped& message, const dds::SampleInfo&) {
            const std::int64_t read_ns = core::steadyNow_ns();
            watch.take(message, read_ns);
            taken(read_ns);
        });
    }

    dds::Reader<ros::WrenchStamped> wrench;
    FrameReaders frames;
};

} // namespace teleta::ros_arm
