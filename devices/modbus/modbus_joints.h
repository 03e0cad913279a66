// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/threads/device_thread.h"
#include "devices/modbus/modbus_joints_worker.h"

namespace teleta::modbus {

/// Joint angles and torques of an arm, read from a Modbus server. Read-only: the description's
/// fastest_radPerS is 0, commands have no effect, and there is no skin. A sample's reference is its angle,
/// since the server reports no other one.
///   connecting -> live <-> stale; lost -> reconnecting -> connecting; stop(): closed
/// Thread: as core::ArmSource.
class ModbusJoints : public core::ArmSource {
public:
    /// map: with joints. arm: the geometry, which no register holds; its name, rate and limits are replaced.
    ModbusJoints(const RegisterMap& map, LinkOpener opener, const core::ArmDescription& arm,
                 ModbusJointsConfig config = {});

    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_worker.joints(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.status(); }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }

    void post(const core::ArmCommand& /*command*/) override {}
    void setProgramRunning(bool /*running*/) override {}
    void restartProgram() override {}

private:
    core::ArmDescription m_description;
    ModbusJointsWorker m_worker;
    core::DeviceThread<ModbusJointsWorker> m_thread{m_worker};
};

/// Joints of the map's server by libmodbus. Error: the map names no joints.
[[nodiscard]] core::Expected<std::unique_ptr<core::ArmSource>>
makeModbusJoints(const RegisterMap& map, const core::ArmDescription& arm, ModbusJointsConfig config = {});

} // namespace teleta::modbus
