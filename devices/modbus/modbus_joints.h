// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/threads/device_thread.h"
#include "backend/core/threads/worker_wait.h"
#include "devices/modbus/input_reader.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::modbus {

struct ModbusJointsConfig {
    std::size_t queueSamples = 1024;
    int failuresUntilLost = 3; ///< readings in a row without an answer, or with an exception
    std::int64_t firstRetry_ns = 100'000'000;
    std::int64_t longestRetry_ns = 5'000'000'000;
    std::shared_ptr<core::PacingClock> clock = std::make_shared<core::PacingClock>();
};

/// Joint angles and torques of an arm, read from a Modbus server when they are due:
///   due_k = epoch + k / rate
/// A late reading skips those that were due in the meantime; they count as lost. Read-only: the description's
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
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_joints.samples(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_joints.status(); }
    [[nodiscard]] core::ArmDrive drive() const override { return core::ArmDrive::held; }
    [[nodiscard]] std::string hindrance() const override;

private:
    friend core::DeviceThread<ModbusJoints>;
    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_wait.wake(); }

    [[nodiscard]] bool connect(const std::stop_token& stop);
    /// False: the connection is lost.
    [[nodiscard]] bool readOnce();
    void deliver();
    void countSkipped();
    [[nodiscard]] std::int64_t due_ns() const;
    [[nodiscard]] std::int64_t now_ns() const { return m_wait.now_ns(); }

    core::ArmDescription m_description;
    LinkOpener m_opener;
    ModbusJointsConfig m_config;
    double m_rate_Hz;
    InputReader m_reader;
    std::int64_t m_staleAfter_ns;
    core::JointOutlet m_joints;
    core::WorkerWait m_wait;

    // The worker's own.
    std::unique_ptr<RegisterLink> m_link;
    std::vector<double> m_values; ///< the angles, then the torques
    std::int64_t m_epoch_ns = 0;
    std::int64_t m_opened_ns = 0;
    std::uint64_t m_sinceEpoch = 0;
    int m_failures = 0; ///< in a row
    bool m_discontinuity = false;

    core::DeviceThread<ModbusJoints> m_thread{*this};
};

/// Joints of the map's server by libmodbus. Error: the map names no joints.
[[nodiscard]] core::Expected<std::unique_ptr<core::ArmSource>>
makeModbusJoints(const RegisterMap& map, const core::ArmDescription& arm, ModbusJointsConfig config = {});

} // namespace teleta::modbus
