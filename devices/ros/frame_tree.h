// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/arm_model.h"
#include "backend/ros/messages.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// Frames that hang on others, as /tf_static and /tf report them: of sensors that were mounted on a robot and
/// that its description does not have, and of the robot's links. Thread: one.
class FrameTree {
public:
    /// Frames that may hang on each other.
    static constexpr int kLongestWay = 64;
    static constexpr std::size_t kMostFrames = 10'000;
    static constexpr double kFarthest_m = 1e9; ///< of a frame from its parent, along each axis
    /// A frame of /tf that was not reported for so long is not known any more.
    static constexpr std::int64_t kMovingMemory_ns = 1'000'000'000;

    /// Where a frame is on a robot.
    struct Place {
        std::size_t link = 0; ///< in ArmModel::links
        Eigen::Isometry3d X_Link_Frame = Eigen::Isometry3d::Identity();
        /// When the oldest of the frames that move was read; nothing: none on the way does.
        std::optional<std::int64_t> read_ns;

        [[nodiscard]] bool isKnown(std::int64_t now_ns) const {
            return !read_ns || now_ns - *read_ns <= kMovingMemory_ns;
        }
    };
    /// Where one frame is in another one.
    struct Pose {
        Eigen::Isometry3d X_From_To = Eigen::Isometry3d::Identity();
        double stamp_s = 0.0;    ///< newest of the frames that move; 0: none on the way does
        double oldestBy_s = 0.0; ///< by which the oldest of them is older
    };

    /// Adds frames of /tf_static, or moves known ones. A transform that is not finite, without a rotation, or
    /// farther than kFarthest_m is left out; so are new frames beyond kMostFrames.
    void takeFixed(const ros::TFMessage& message) { take(message, std::nullopt); }
    /// The same of /tf, read at this steady time.
    void takeMoving(const ros::TFMessage& message, std::int64_t read_ns) { take(message, read_ns); }

    /// Where a frame is on a robot: the link of this name, or the one on which it hangs. Nothing: it hangs on
    /// none of them.
    [[nodiscard]] std::optional<Place> placeOf(const std::string& frame,
                                               const arm_model::ArmModel& model) const;

    /// By what was reported alone. Nothing: the frames do not hang together.
    [[nodiscard]] std::optional<Pose> between(const std::string& from, const std::string& to) const;

private:
    struct Hung {
        std::string parent;
        Eigen::Isometry3d X_Parent_Frame;
        std::optional<std::int64_t> read_ns; ///< nothing: it does not move
        double stamp_s = 0.0;
    };
    /// A frame on the way from another one to the root.
    struct Step {
        std::string frame;
        Eigen::Isometry3d X_Step_Start = Eigen::Isometry3d::Identity();
        std::vector<double> stamps_s; ///< of what moves between both
    };

    void take(const ros::TFMessage& message, std::optional<std::int64_t> read_ns);
    [[nodiscard]] std::vector<Step> wayFrom(const std::string& frame) const;

    std::map<std::string, Hung> m_frames;
};

} // namespace teleta::ros_arm
