// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/messages.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace teleta::test {

/// A transform as /tf and /tf_static tell it.
struct ToldFrame {
    std::string frame;
    std::string parent;
    std::array<double, 3> p_m{};
    std::array<double, 4> quaternion{1.0, 0.0, 0.0, 0.0}; ///< w, x, y, z
    double stamp_s = 0.0;
};

/// Calls told() with a message of these transforms.
template <typename Told>
void tellFrames(std::vector<ToldFrame> frames, const Told& told) {
    std::vector<std::remove_pointer_t<decltype(ros::TFMessage{}.transforms._buffer)>> transforms;
    for (ToldFrame& frame : frames) {
        auto& one = transforms.emplace_back();
        one.header.frame_id = frame.parent.data();
        one.header.stamp.sec = static_cast<std::int32_t>(std::floor(frame.stamp_s));
        one.header.stamp.nanosec =
            static_cast<std::uint32_t>(std::llround(1e9 * (frame.stamp_s - std::floor(frame.stamp_s))));
        one.child_frame_id = frame.frame.data();
        one.transform.translation = {frame.p_m[0], frame.p_m[1], frame.p_m[2]};
        const auto& [w, x, y, z] = frame.quaternion;
        one.transform.rotation = {x, y, z, w};
    }
    ros::TFMessage message{};
    ros::lend(message.transforms, std::span(transforms));
    told(message);
}

} // namespace teleta::test
