// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/simulated/arm_drive_control.h"
#include "devices/simulated/simulated_worker.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::simulated {

struct SimulatedArmConfig {
    std::size_t queueSamples = 8192; ///< of the joints
    std::size_t queueBlocks = 512;   ///< of the skin
    /// The consumer is woken when so much time of samples has come together.
    double batch_s = 0.005;
    /// Age of the newest sample from which joints and skin are stale; by default core::staleAfter_ns of the
    /// rate of each.
    std::optional<double> staleAfter_s = std::nullopt;
    /// A worker that is later than this does not catch up: the simulated world then stood still meanwhile.
    double longestCatchUp_s = 1.0;
    bool startProgram = true;    ///< the program runs from the start, if there is one
    SimulatedFaults faults{};    ///< of the link, for joints and skin alike
    std::uint64_t faultSeed = 1; ///< which samples and frames are dropped
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

/// Moves a simulated arm in real time, one step per joint period; each step looks at STOP first. Samples of
/// an arm at another site are stamped with the time at which they were read there. Thread: as
/// SimulatedWorker; open() before run().
class SimulatedArmWorker : public SimulatedWorker {
public:
    SimulatedArmWorker(std::unique_ptr<core::ArmGenerator> generator, const core::StopSwitch& stopSwitch,
                       SimulatedArmConfig config);

    void open(core::Wakeup& consumer);

    [[nodiscard]] const core::ArmDescription& description() const { return m_description; }
    [[nodiscard]] const core::SourceDescription& skinDescription() const { return m_skinDescription; }
    [[nodiscard]] ArmDriveControl& drive() { return m_drive; }
    [[nodiscard]] core::JointOutlet& joints() { return m_joints; }
    [[nodiscard]] core::SourceOutlet& skin() { return m_skin; }
    /// As core::ArmSource::presentObjects(). Thread: any.
    [[nodiscard]] std::uint64_t presentObjects() const { return m_present.load(std::memory_order_relaxed); }

private:
    void setState(core::DeviceState state, const std::string& message) override;
    void disconnected() override;
    void makeDue(const SimulatedFaults& faults, std::int64_t now_ns) override;
    std::int64_t idle(const SimulatedFaults& faults, std::int64_t now_ns) override;
    [[nodiscard]] std::string unpluggedMessage() const override;
    void silenceChanged() override { m_joints.flush(); }

    void obeyStop(std::int64_t now_ns);
    void step(const SimulatedFaults& faults);
    void deliverArrivals(const SimulatedFaults& faults);
    void deliverFrame(std::int64_t time_ns, double sourceTime_s, std::optional<std::int64_t> arrived_ns = {});

    std::unique_ptr<core::ArmGenerator> m_generator;
    std::atomic<std::uint64_t> m_present{0};
    const core::StopSwitch& m_stopSwitch;
    SimulatedArmConfig m_config;
    core::ArmDescription m_description;
    core::SourceDescription m_skinDescription;
    ArmDriveControl m_drive;
    core::JointOutlet m_joints;
    core::SourceOutlet m_skin;
    std::int64_t m_jointsStaleAfter_ns;
    std::int64_t m_skinStaleAfter_ns;

    std::vector<float> m_values;
    core::ArmArrival m_arrival;       ///< of an arm at another place
    std::int64_t m_newestRead_ns = 0; ///< when the newest of its samples was read there
    core::ArmLinkCounters m_linkCounted;
    std::optional<core::JointVector> m_reference_rad; ///< of the newest step
    bool m_jointDiscontinuity = false;                ///< of the next sample
    bool m_skinDiscontinuity = false;                 ///< of the next frame
};

} // namespace teleta::simulated
