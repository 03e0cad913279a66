// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/device/arm_report.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/device/required_devices.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/ros/joint_state_joiner.h"
#include "devices/dds/discovery.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"
#include "devices/ros/arm_commander.h"
#include "devices/ros/files/ros_arm_file.h"
#include "devices/ros/joint_watch.h"
#include "devices/ros/node_announcement.h"
#include "devices/ros/trajectory_mover.h"
#include "devices/ros/wrench_readers.h"
#include "devices/ros/wrench_watch.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::ros_arm {

/// What is known of an arm now.
struct RosArmState {
    MoverState mover;
    std::vector<std::string> missing; ///< joints, as messages name them, that are not told or too old
    std::size_t controllers = 0;      ///< readers of the command topic
    bool ready = false;               ///< one reads it, and other programs would have been found
    bool effortMissing = false;       ///< effort_stop needs efforts, and they are not told
    bool forceMissing = false;        ///< force_stop_N needs the force at the wrist, and it is not known
    /// Our wall clock less the newest stamp, where the adapter needs both to agree and they do not.
    std::optional<double> clockOff_s{};
    std::string lacking;      ///< a device that the file requires and that is not live; empty: none
    std::uint64_t unsent = 0; ///< commands that could not be sent in time
    ros::JointCounters counters;
    /// Why it does not move, a translated sentence without a full stop; empty: it may.
    std::string problem;
    core::JointVector rate;   ///< as told, rad/s (prismatic: m/s); empty: not told
    core::JointVector effort; ///< as told, in the unit of the file; empty: not told
    /// Joints that the arm tells and its description does not have, each once since the start.
    std::vector<std::string> unknownJoints{};
};

/// An arm over ROS 2: joint samples from the topic of joint states, and motion through the controller that
/// its file names.
///   connecting -> live <-> stale; stop(): closed
/// Torques are told where the file says that efforts are Nm, without the part of gravity. Who may move it and
/// how far, see TrajectoryMover; what is in the way is in state(). Nothing is sent before the operator's
/// first command, and nothing moves in the first kSettling_ns, in which other programs are found.
/// Thread: as core::ArmSource; state() from any.
class RosArm : public core::ArmSource, public core::ReportingArm {
public:
    static constexpr std::int64_t kSettling_ns = 2'500'000'000;
    /// Joints that are not told for longer than that, once they were, are a fault. The arm is held long
    /// before.
    static constexpr std::int64_t kSilence_ns = 1'000'000'000;

    /// Joins the domain and reads the description; it waits for that, see findChain(). stop must outlive the
    /// arm. required: the devices of the site that moves the arm, which the file may require; null: without a
    /// site. Error: as findChain();
    /// refused, with the obstacles() of the file.
    [[nodiscard]] static core::Expected<std::unique_ptr<RosArm>>
    open(const RosArmFile& file, const core::StopSwitch& stop, const std::function<bool()>& cancelled = {},
         std::shared_ptr<const core::RequiredDevices> required = {});

    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_outlet.samples(); }
    [[nodiscard]] core::BoundedQueue<core::WrenchSample>* wrenches() override {
        return m_file.wrench ? &m_wrenches : nullptr;
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }
    [[nodiscard]] core::ArmDrive drive() const override { return m_state.get().mover.drive; }
    void post(const core::ArmCommand& command) override;

    [[nodiscard]] RosArmState state() const { return m_state.get(); }
    [[nodiscard]] core::ArmReport report() const override;
    /// RosArmState::problem
    [[nodiscard]] std::string hindrance() const override { return m_state.get().problem; }
    [[nodiscard]] const arm_model::SerialChain& chain() const { return *m_chain; }
    [[nodiscard]] std::shared_ptr<const arm_model::SerialChain> sharedChain() const { return m_chain; }
    [[nodiscard]] const RosArmFile& file() const { return m_file; }

private:
    friend core::DeviceThread<RosArm>;
    /// What is open in the domain.
    struct Ends {
        std::shared_ptr<const dds::Participant> participant;
        dds::Discovery discovery;
        dds::Reader<ros::JointState> reader;
        std::unique_ptr<ArmCommander> commander;
        std::optional<WrenchReaders> wrench;
        std::optional<NodeAnnouncement> announcement;
    };

    RosArm(RosArmFile file, std::shared_ptr<const arm_model::SerialChain> chain,
           std::vector<std::string> names, Ends ends, const core::StopSwitch& stop,
           std::shared_ptr<const core::RequiredDevices> required);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_waitSet.wake(); }

    void takeJoints();
    void takeWrench();
    void deliver(const ros::JoinedJoints& joints, std::int64_t read_ns);
    [[nodiscard]] std::int64_t stampAt_ns(std::int64_t now_ns) const;
    [[nodiscard]] core::JointVector torqueOf(const ros::JoinedJoints& joints) const;
    void step(std::int64_t now_ns);
    void lookAround(std::int64_t now_ns);
    void comeToRest();
    [[nodiscard]] QString problemOf(const RosArmState& state) const;

    RosArmFile m_file;
    std::shared_ptr<const arm_model::SerialChain> m_chain;
    core::ArmDescription m_description;
    Ends m_ends;
    const core::StopSwitch& m_stop;
    std::shared_ptr<const core::RequiredDevices> m_required; ///< null: the file requires none
    core::JointOutlet m_outlet;
    core::BoundedQueue<core::WrenchSample> m_wrenches;
    AdapterTiming m_timing;
    TrajectoryMover m_mover;
    core::LatestCopy<RosArmState> m_state;

    // The worker's own.
    JointWatch m_watch;
    std::optional<WrenchWatch> m_wrench; ///< nothing: the file names no force sensor
    dds::WaitSet m_waitSet;
    double m_clockDifference_s = 0.0; ///< our wall clock less the newest stamp
    std::int64_t m_wallAtRead_ns = 0; ///< our wall clock when the newest joints were read
    std::int64_t m_read_ns = 0;       ///< the steady one then
    std::int64_t m_opened_ns = 0;
    std::int64_t m_nextLook_ns = 0;
    std::optional<std::int64_t> m_known_ns; ///< when all joints were known the last time
    std::size_t m_controllers = 0;
    bool m_otherWriter = false;
    std::optional<ros::QosMismatch> m_jointMismatch;      ///< of who publishes the joint states
    std::optional<ros::QosMismatch> m_controllerMismatch; ///< of who subscribes to the commands
    std::vector<std::string> m_unknownJoints;
    std::uint64_t m_unsent = 0;
    bool m_discontinuity = false;

    core::DeviceThread<RosArm> m_thread{*this};
};

} // namespace teleta::ros_arm
