// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/arm_drive_control.h"
#include "devices/simulated/joint_outlet.h"
#include "devices/simulated/simulated_arm_config.h"
#include "devices/simulated/simulated_link.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace teleta::simulated {

/// Moves a simulated arm in real time: one step a joint period, when it is due,
///   due_k = epoch + (k + 1) / rate + lag
/// so that a late step does not delay the next ones. Each step looks at STOP first. What comes from an arm at
/// another place is stamped with the time at which it was read there.
/// Thread: run() is the worker's; open() before it; the others from any.
class SimulatedArmWorker {
public:
    SimulatedArmWorker(std::unique_ptr<core::ArmGenerator> generator, const core::StopSwitch& stopSwitch,
                       SimulatedArmConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token and its faults.
    void wake() { m_link.wake(); }

    void setFaults(const SimulatedFaults& faults) { m_link.setFaults(faults); }
    [[nodiscard]] SimulatedFaults faults() const { return m_link.faults(); }

    [[nodiscard]] const core::ArmDescription& description() const { return m_description; }
    [[nodiscard]] const core::SourceDescription& skinDescription() const { return m_skinDescription; }
    [[nodiscard]] ArmDriveControl& drive() { return m_drive; }
    [[nodiscard]] const ArmDriveControl& drive() const { return m_drive; }
    [[nodiscard]] std::int64_t now_ns() const { return m_link.now_ns(); }
    [[nodiscard]] JointOutlet& joints() { return m_joints; }
    [[nodiscard]] const JointOutlet& joints() const { return m_joints; }
    [[nodiscard]] core::SourceOutlet& skin() { return m_skin; }
    [[nodiscard]] const core::SourceOutlet& skin() const { return m_skin; }

private:
    void connect();
    void obeyStop(std::int64_t now_ns);
    void waitForPlug(SimulatedLink::Lock& lock, const std::stop_token& stop);
    void setState(core::DeviceState state, const std::string& message = {});
    void stepDue(const SimulatedFaults& faults, std::int64_t now_ns);
    void step(const SimulatedFaults& faults);
    void deliverArrivals(const SimulatedFaults& faults);
    void deliverFrame(std::int64_t time_ns, double sourceTime_s, std::optional<std::int64_t> arrived_ns = {});

    std::unique_ptr<core::ArmGenerator> m_generator;
    const core::StopSwitch& m_stopSwitch;
    SimulatedArmConfig m_config;
    core::ArmDescription m_description;
    core::SourceDescription m_skinDescription;
    ArmDriveControl m_drive;
    JointOutlet m_joints;
    core::SourceOutlet m_skin;
    SimulatedLink m_link;

    std::vector<float> m_values;
    core::ArmArrival m_arrival;       ///< of an arm at another place
    std::int64_t m_newestRead_ns = 0; ///< when the newest of its samples was read there
    core::ArmLinkCounters m_linkCounted;
    std::optional<core::JointArray> m_reference_rad; ///< of the newest step
    bool m_jointDiscontinuity = false;               ///< of the next sample
    bool m_skinDiscontinuity = false;                ///< of the next frame
};

} // namespace teleta::simulated
