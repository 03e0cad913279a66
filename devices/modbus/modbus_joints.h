// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/threads/device_thread.h"
#include "devices/modbus/modbus_joints_worker.h"

namespace teleta::modbus {

/// Joint angles and torques of an arm that a Modbus server tells: read-only. The arm cannot be moved through
/// it, so the description's fastest_radPerS is 0 and commands have no effect; there is no skin. The reference
/// of a sample is its angle, since the server does not tell another one.
///   connecting -> live <-> stale; lost -> reconnecting -> connecting; stop(): closed
/// Thread: as core::ArmSource.
class ModbusJoints : public core::ArmSource {
public:
    /// map: with joints. arm: the geometry, which no register tells; name, rate and what says that it moves
    /// are the device's.
    ModbusJoints(const RegisterMap& map, LinkOpener opener, const core::ArmDescription& arm,
                 ModbusJointsConfig config = {});
    ~ModbusJoints() override;

    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override;
    void stop() override;
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_worker.joints(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker.status(); }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }

    void post(const core::ArmCommand& /*command*/) override {}
    void setProgramRunning(bool /*running*/) override {}
    void restartProgram() override {}

private:
    core::ArmDescription m_description;
    ModbusJointsWorker m_worker;
    core::DeviceThread m_thread;
};

/// Joints of the map's server by libmodbus. Error: the map names no joints.
[[nodiscard]] core::Expected<std::unique_ptr<core::ArmSource>>
makeModbusJoints(const RegisterMap& map, const core::ArmDescription& arm, ModbusJointsConfig config = {});

} // namespace teleta::modbus
