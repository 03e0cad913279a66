// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands/certify/actuator_watch.h"
#include "backend/core/error.h"
#include "devices/modbus/input_reader.h"
#include "devices/modbus/register_link.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace teleta::cli {

/// Reads back, over a connection of its own, whether the motors of a Modbus driver are on: a register differs
/// from `off`, and the driver does not tell that it has turned them off. Thread: any; it has a thread of its
/// own.
class MotorWatch : public ActuatorWatch {
public:
    /// Error: unavailable, as openLibmodbusLink().
    [[nodiscard]] static core::Expected<std::unique_ptr<MotorWatch>> start(const modbus::RegisterMap& map);
    MotorWatch(modbus::RegisterMap map, std::unique_ptr<modbus::RegisterLink> link);

    [[nodiscard]] Look newest() const override;
    [[nodiscard]] std::optional<Look> offSince(std::int64_t from_ns) const override;
    [[nodiscard]] bool wasOnAfter(std::int64_t from_ns) const override;
    [[nodiscard]] std::int64_t longestGap_ns(std::int64_t from_ns) const override;
    [[nodiscard]] bool failed() const override;

private:
    void run(const std::stop_token& stop);
    [[nodiscard]] std::optional<bool> readOn();

    modbus::RegisterMap m_map;
    std::vector<std::uint16_t> m_off;
    std::optional<modbus::InputReader> m_status; ///< where the map has a bit for the time-out
    std::unique_ptr<modbus::RegisterLink> m_link;
    mutable std::mutex m_mutex;
    std::vector<Look> m_looks; ///< guarded by m_mutex; of the last seconds
    bool m_failed = false;     ///< guarded by m_mutex
    std::jthread m_thread;     ///< last, so that it ends first
};

} // namespace teleta::cli
