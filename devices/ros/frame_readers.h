// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/steady_time.h"
#include "backend/ros/messages.h"
#include "backend/ros/qos_profile.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"

#include <memory>
#include <utility>

namespace teleta::ros_arm {

/// The frames of a robot: /tf_static and /tf. Thread: one.
struct FrameReaders {
    static constexpr int kMostAtOnce = 100; ///< as ROS keeps of both topics

    /// Error: unavailable, a topic cannot be opened.
    [[nodiscard]] static core::Expected<FrameReaders>
    open(const std::shared_ptr<const dds::Participant>& participant) {
        TELETA_TRY(auto hung, dds::Reader<ros::TFMessage>::open(participant, ros::ddsTopicOf("/tf_static"),
                                                                ros::kLatchedReader.withDepth(kMostAtOnce)));
        TELETA_TRY(auto told, dds::Reader<ros::TFMessage>::open(participant, ros::ddsTopicOf("/tf"),
                                                                ros::kSensorReader.withDepth(kMostAtOnce)));
        return FrameReaders{std::move(hung), std::move(told)};
    }

    /// Gives what waits to takeFixed() and takeMoving().
    template <typename Taker>
    void take(Taker& taker) {
        (void)fixed.take(
            [&taker](const ros::TFMessage& message, const dds::SampleInfo&) { taker.takeFixed(message); });
        (void)moving.take([&taker](const ros::TFMessage& message, const dds::SampleInfo&) {
            taker.takeMoving(message, core::steadyNow_ns());
        });
    }

    dds::Reader<ros::TFMessage> fixed;
    dds::Reader<ros::TFMessage> moving;
};

} // namespace teleta::ros_arm
