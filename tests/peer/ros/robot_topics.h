// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arm_physics.h"
#include "dds_node.h"
#include "messages.h"
#include "robot_options.h"

#include <string>
#include <vector>

namespace teleta::peer {

/// What the joints tell at one moment.
struct JointTelling {
    std::vector<std::string> name;
    std::vector<double> position_rad;
    std::vector<double> velocity_radPerS;
    std::vector<double> effort_Nm;
};

/// Counts the readers that a writer has found.
class ReaderCount final : public eprosima::fastdds::dds::DataWriterListener {
public:
    void on_publication_matched(eprosima::fastdds::dds::DataWriter*,
                                const eprosima::fastdds::dds::PublicationMatchedStatus& status) override {
        m_readers = status.current_count;
    }
    [[nodiscard]] int readers() const { return m_readers; }

private:
    std::atomic<int> m_readers{0};
};

/// The topics of the robot. Thread: one at a time.
class RobotTopics {
public:
    /// Publishes the description and the fixed frames.
    RobotTopics(const RobotOptions& options, const std::string& urdf, const ArmPhysics& arm);

    /// False when Fast DDS did not take it.
    bool tellJoints(const JointTelling& joints, std::int64_t stamp_ns);
    bool tellWrench(const std::array<double, 6>& wrench, std::int64_t stamp_ns);
    bool tellFrames(const std::vector<LinkFrame>& frames, std::int64_t stamp_ns);
    bool tellPad(const std::vector<double>& taxels_N);
    /// Replaces the writer of joint states by one of other QoS.
    void tellJointsAs(bool reliable);

    [[nodiscard]] std::vector<trajectory_msgs::msg::JointTrajectory> takeTrajectories() {
        return m_trajectories.take();
    }
    [[nodiscard]] std::vector<std_msgs::msg::Float64MultiArray> takeValues() { return m_values.take(); }
    [[nodiscard]] std::vector<control_msgs::msg::JointJog> takeJogs() { return m_jogs.take(); }
    [[nodiscard]] int commanders() const {
        return m_trajectories.writers() + m_values.writers() + m_jogs.writers();
    }
    [[nodiscard]] int jointReaders() const { return m_jointReaders.readers(); }
    /// Writers on the command topic that do not match.
    [[nodiscard]] int incompatible() const {
        return m_trajectories.incompatible() + m_values.incompatible() + m_jogs.incompatible();
    }

private:
    // Before the node, which calls them until it is gone.
    Inbox<trajectory_msgs::msg::JointTrajectory> m_trajectories;
    Inbox<std_msgs::msg::Float64MultiArray> m_values;
    Inbox<control_msgs::msg::JointJog> m_jogs;
    ReaderCount m_jointReaders;
    DdsNode m_node;
    std::string m_frame;
    eprosima::fastdds::dds::DataWriter* m_joints = nullptr;
    eprosima::fastdds::dds::DataWriter* m_wrench = nullptr;
    eprosima::fastdds::dds::DataWriter* m_pad = nullptr;
    eprosima::fastdds::dds::DataWriter* m_frames = nullptr;
};

} // namespace teleta::peer
