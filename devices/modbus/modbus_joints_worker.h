// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/threads/worker_wait.h"
#include "devices/modbus/input_reader.h"
#include "devices/modbus/modbus_joints_config.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

namespace teleta::modbus {

/// Reads the joints when they are due:
///   due_k = epoch + k / rate
/// A late reading skips those that were due in the meantime; they count as lost.
/// Thread: run() is the worker's; open() before it; the others from any.
class ModbusJointsWorker {
public:
    /// map: with joints.
    ModbusJointsWorker(const RegisterMap& map, LinkOpener opener, ModbusJointsConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token.
    void wake() { m_wait.wake(); }

    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() { return m_joints.samples(); }
    [[nodiscard]] core::DeviceStatus status() const { return m_joints.status(); }

private:
    [[nodiscard]] bool connect(const std::stop_token& stop);
    /// False: the connection is lost.
    [[nodiscard]] bool readOnce();
    void deliver();
    void countSkipped();
    [[nodiscard]] std::int64_t due_ns() const;
    [[nodiscard]] std::int64_t now_ns() const { return m_wait.now_ns(); }

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
};

} // namespace teleta::modbus
