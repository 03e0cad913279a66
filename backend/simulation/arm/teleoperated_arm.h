// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/scene/scene.h"
#include "backend/simulation/arm/delayed_line.h"
#include "backend/simulation/arm/scripted_operator.h"
#include "backend/simulation/arm/simulated_arm.h"
#include "backend/simulation/base/timed_effects.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace teleta::simulation {

/// The arm of a scene with an operator at another place. Each step
///   demand, or what the scripted operator asks -> link -> the newest that has arrived -> SimulatedArm
///   joint sample, with the skin frame that was read with it -> link, in order -> next(), takeArrival() ...
/// STOP goes over the link like any command, once a step. An arm that hears nothing for
/// core::ArmCommand::kJogLifetime_ns stands still (its watchdog). Without news from the arm
/// for that long, the scripted operator waits, and repeats a touch that he missed so much of. Without the
/// effect link_delay nothing is late. Deterministic as SimulatedArm. Thread: one.
class TeleoperatedArm : public core::ArmGenerator {
public:
    /// Error: badInput when the scene is not valid or has no operator.
    [[nodiscard]] static core::Expected<std::unique_ptr<TeleoperatedArm>> make(const scene::Scene& scene,
                                                                               std::uint64_t seed);

    [[nodiscard]] core::ArmDescription description() const override { return m_arm->description(); }
    [[nodiscard]] core::SourceDescription skinDescription() const override {
        return m_arm->skinDescription();
    }
    /// sample: what the arm itself measured in this step.
    void next(const core::ArmDemand& demand, core::JointSample& sample) override;
    bool skinFrame(std::span<float> values) override { return m_arm->skinFrame(values); }
    [[nodiscard]] double time_s() const override { return m_arm->time_s(); }
    [[nodiscard]] bool programDone() const override { return m_operator.done(); }
    void restart() override;
    [[nodiscard]] std::uint64_t presentObjects() const override { return m_arm->presentObjects(); }

    [[nodiscard]] bool isRemote() const override { return true; }
    bool takeArrival(core::ArmArrival& arrival) override;
    [[nodiscard]] core::ArmLinkCounters linkCounters() const override;

    [[nodiscard]] const SimulatedArm& arm() const { return *m_arm; }
    /// What moved the arm in the newest step: what it heard, or nothing.
    [[nodiscard]] core::ArmDrive obeyed() const { return m_obeyed; }
    [[nodiscard]] std::vector<EffectTime> effectTimes() const;

private:
    TeleoperatedArm(std::unique_ptr<SimulatedArm> arm, const scene::Scene& scene, std::uint64_t seed);
    [[nodiscard]] core::ArmDemand asked(const core::ArmDemand& demand, double now_s);
    [[nodiscard]] core::ArmDemand heard(double now_s);

    std::unique_ptr<SimulatedArm> m_arm;
    double m_step_s;
    ScriptedOperator m_operator;
    DelayedLine<core::ArmDemand> m_commands;
    DelayedLine<core::ArmArrival> m_told;
    bool m_timed;
    std::vector<float> m_frame;
    std::uint64_t m_framesLost = 0;

    std::optional<core::JointSample> m_seen; ///< newest sample at the operator's place
    double m_seenAt_s = 0.0;
    core::ArmDemand m_command; ///< newest at the arm
    double m_heardAt_s = 0.0;
    core::ArmDrive m_obeyed = core::ArmDrive::held;
    bool m_operatorLeft = false; ///< the arm was moved, or was not seen, since the scripted operator led it
    double m_linkTime_s = 0.0;
};

/// The arm of a scene for a simulated device: with an operator, at his end of the link.
/// Error: as SimulatedArm::make.
[[nodiscard]] core::Expected<std::unique_ptr<core::ArmGenerator>> makeArm(const scene::Scene& scene,
                                                                          std::uint64_t seed);

} // namespace teleta::simulation
