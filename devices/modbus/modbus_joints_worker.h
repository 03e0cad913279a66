// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/rate_meter.h"
#include "backend/core/threads/latest_copy.h"
#include "devices/modbus/input_reader.h"
#include "devices/modbus/modbus_joints_config.h"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::modbus {

/// Reads the joints when they are due:
///   due_k = epoch + k / rate
/// A reading that is late leaves out those that were due meanwhile; they count as lost.
/// Thread: run() is the worker's; open() before it; the others from any.
class ModbusJointsWorker {
public:
    /// map: with joints.
    ModbusJointsWorker(const RegisterMap& map, LinkOpener opener, ModbusJointsConfig config);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    /// Ends a wait of run(), so that it looks at its stop token.
    void wake();

    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() { return m_joints; }
    [[nodiscard]] core::DeviceStatus status() const { return m_published.get(); }

private:
    using Lock = std::unique_lock<std::mutex>;

    [[nodiscard]] bool connect(Lock& lock, const std::stop_token& stop);
    [[nodiscard]] bool waitUntil(Lock& lock, const std::stop_token& stop, std::int64_t deadline_ns);
    /// False: the connection is lost.
    [[nodiscard]] bool readOnce();
    void deliver();
    void countSkipped();
    void setState(core::DeviceState state, std::string message = {});
    void publish();
    [[nodiscard]] std::int64_t due_ns() const;
    [[nodiscard]] std::int64_t now_ns() const { return m_config.clock->now_ns(); }

    LinkOpener m_opener;
    ModbusJointsConfig m_config;
    double m_rate_Hz;
    InputReader m_reader;
    std::int64_t m_staleAfter_ns;
    core::BoundedQueue<core::JointSample> m_joints;
    core::Wakeup* m_consumer = nullptr;

    std::mutex m_mutex; ///< of the condition only; the rest is the worker's
    std::condition_variable m_condition;
    std::unique_ptr<RegisterLink> m_link;
    std::vector<double> m_values; ///< the angles, then the torques
    std::int64_t m_epoch_ns = 0;
    std::int64_t m_connected_ns = 0;
    std::int64_t m_opened_ns = 0;
    std::uint64_t m_sinceEpoch = 0;
    int m_failures = 0; ///< in a row
    bool m_discontinuity = false;
    std::uint64_t m_lost = 0;
    std::uint64_t m_overflowAtOpen = 0;
    core::RateMeter m_rate;
    core::DeviceStatus m_status;
    core::LatestCopy<core::DeviceStatus> m_published;
};

} // namespace teleta::modbus
