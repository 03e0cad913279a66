// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/joint_vector.h"
#include "backend/ros/messages.h"
#include "devices/ros/frame_tree.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

namespace teleta::ros_arm {

/// How far the tip is from where the robot's own frames have it.
struct FrameObservation {
    std::uint64_t messages = 0; ///< of /tf
    bool connected = false;     ///< the frames lead from the base to the tip
    std::uint64_t compared = 0; ///< poses of the tip whose joints were known
    double farthest_m = 0.0;
    double largestTurn_rad = 0.0;
};

/// Compares the robot's own frames, /tf and /tf_static, with the arm's description and its joints: they
/// differ where the description is another robot's, or joints have other zeros. A pose is compared with the
/// joints at its stamp, interpolated between two samples. Thread: one.
class FrameCheck {
public:
    /// Samples of joints, and poses that wait for them. The oldest go.
    static constexpr std::size_t kKept = 256;
    /// Samples farther apart are not interpolated.
    static constexpr double kLongestGap_s = 0.1;
    /// Poses are left out whose frames were reported at times that differ by more.
    static constexpr double kSameTime_s = 0.001;

    explicit FrameCheck(std::shared_ptr<const arm_model::SerialChain> chain);

    void takeFixed(const ros::TFMessage& message) { m_tree.takeFixed(message); }
    void takeMoving(const ros::TFMessage& message, std::int64_t read_ns);
    /// A sample of the arm's joints with its own stamp. One that is not newer than the last is left out.
    void takeJoints(const core::JointVector& position, double stamp_s);

    [[nodiscard]] const FrameObservation& seen() const { return m_seen; }

private:
    struct Joints {
        double stamp_s;
        core::JointVector position;
    };

    void compareWaiting();
    void compare(const FrameTree::Pose& pose, const core::JointVector& position);

    std::shared_ptr<const arm_model::SerialChain> m_chain;
    FrameTree m_tree;
    std::deque<Joints> m_joints;
    std::deque<FrameTree::Pose> m_waiting;
    FrameObservation m_seen;
};

} // namespace teleta::ros_arm
