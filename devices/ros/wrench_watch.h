// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/arm_device.h"
#include "backend/ros/messages.h"
#include "devices/ros/files/ros_wrench_file.h"
#include "devices/ros/frame_tree.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace teleta::ros_arm {

/// The force that acts on an arm, as a sensor at its wrist tells it, and whether it is known. Thread: one.
class WrenchWatch {
public:
    WrenchWatch(const RosWrenchFile& file, std::shared_ptr<const arm_model::SerialChain> chain);

    /// Takes frames of /tf_static, in which messages may be.
    void takeFixed(const ros::TFMessage& message);
    /// The same of /tf, read at this steady time.
    void takeMoving(const ros::TFMessage& message, std::int64_t read_ns);
    /// Takes a message that was read at this steady time (not decreasing).
    void take(const ros::WrenchStamped& message, std::int64_t read_ns);

    /// The strongest force on the arm since the last call, or else the newest, along the axes of its base, N;
    /// not finite where the sensor says so. Nothing: none came within the file's time, or the newest is in a
    /// frame that neither the arm's description nor /tf_static has, nor /tf within the last second. q: of the
    /// arm's joints.
    [[nodiscard]] std::optional<Eigen::Vector3d> takeForce_Base_N(const core::JointVector& q,
                                                                  std::int64_t now_ns);

    /// The newest message, moved to the arm's tip and its axes by where the joints are. Nothing: it is not
    /// finite, or its frame is not known. q: of the arm's joints.
    [[nodiscard]] std::optional<core::WrenchSample> atTip(const core::JointVector& q) const;

    /// The size of the newest force, N; NaN where it is no number, 0 before the first one.
    [[nodiscard]] double newest_N() const { return m_force_N.stableNorm(); }

    /// The frame of the newest message, if it is not known; empty: it is.
    [[nodiscard]] const std::string& unknownFrame() const { return m_unknownFrame; }
    [[nodiscard]] std::uint64_t messages() const { return m_messages; }

private:
    void findPlace();

    std::shared_ptr<const arm_model::SerialChain> m_chain;
    std::string m_frame; ///< where messages name none
    double m_sign;
    std::int64_t m_timeout_ns;
    std::optional<std::int64_t> m_read_ns;
    Eigen::Vector3d m_force_N = Eigen::Vector3d::Zero();   ///< the newest, in its frame
    Eigen::Vector3d m_torque_Nm = Eigen::Vector3d::Zero(); ///< of the same message
    double m_stamp_s = 0.0;
    Eigen::Vector3d m_strongest_N = Eigen::Vector3d::Zero();
    bool m_isNew = false; ///< m_strongest_N is since the last call
    FrameTree m_frames;
    std::string m_lastFrame;                 ///< of m_place
    std::optional<FrameTree::Place> m_place; ///< nothing: not known
    std::string m_unknownFrame;
    std::uint64_t m_messages = 0;
};

} // namespace teleta::ros_arm
