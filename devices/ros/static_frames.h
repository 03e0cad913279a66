// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/arm_model.h"
#include "backend/ros/messages.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace teleta::ros_arm {

/// Frames that hang on others and do not move, as /tf_static reports them: of sensors that were mounted on a
/// robot and that its description does not have. Thread: one.
class StaticFrames {
public:
    /// Frames that may hang on each other between a link and a frame.
    static constexpr int kLongestWay = 64;
    static constexpr std::size_t kMostFrames = 10'000;

    struct Place {
        std::size_t link = 0; ///< in ArmModel::links
        Eigen::Isometry3d X_Link_Frame = Eigen::Isometry3d::Identity();
    };

    /// Adds frames, or moves known ones. A transform that is not finite, or without a rotation, is left out;
    /// so are new frames beyond kMostFrames.
    void take(const ros::TFMessage& message);

    /// Where a frame is on a robot: the link of this name, or the one on which it hangs. Nothing: it hangs on
    /// none of them.
    [[nodiscard]] std::optional<Place> placeOf(const std::string& frame,
                                               const arm_model::ArmModel& model) const;

private:
    struct Hung {
        std::string parent;
        Eigen::Isometry3d X_Parent_Frame;
    };
    std::map<std::string, Hung> m_frames;
};

} // namespace teleta::ros_arm
