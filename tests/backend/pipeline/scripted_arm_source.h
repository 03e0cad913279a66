// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "tests/backend/pipeline/scripted_arm.h"

#include <atomic>
#include <vector>

namespace teleta::test {

/// An arm whose samples the test itself puts into the queue.
class ScriptedArmSource : public core::ArmSource {
public:
    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override {
        m_consumer = &consumer;
        ++starts;
    }
    void stop() override { ++stops; }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_joints; }
    [[nodiscard]] core::BoundedQueue<core::WrenchSample>* wrenches() override {
        return hasWrench ? &m_wrenches : nullptr;
    }
    void wakeAtEachSample(bool each) override { wakesAtEach = each; }
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::jog; }
    void post(const core::ArmCommand& command) override { commands.push_back(command); }
    void setProgramRunning(bool) override {}
    void restartProgram() override {}

    /// As if it were played from a recording. Before anything is processed.
    void setRecorded() { m_description.recorded = true; }
    bool push(core::JointSample sample) {
        const bool fits = m_joints.push(std::move(sample));
        if (m_consumer != nullptr)
            m_consumer->notify();
        return fits;
    }

    bool push(core::WrenchSample sample) { return m_wrenches.push(std::move(sample)); }

    bool hasWrench = false; ///< it has a sensor of force and torque
    std::atomic<bool> wakesAtEach{false};
    std::atomic<int> starts{0};
    std::atomic<int> stops{0};
    std::vector<core::ArmCommand> commands;

private:
    core::ArmDescription m_description = paperArm();
    core::BoundedQueue<core::JointSample> m_joints{4096};
    core::BoundedQueue<core::WrenchSample> m_wrenches{4096};
    core::Wakeup* m_consumer = nullptr;
};

} // namespace teleta::test
