// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/modbus/register_map.h"

#include <chrono>
#include <cstdint>
#include <memory>

namespace teleta::modbus {

/// A simulated motor driver: a real Modbus TCP server on this computer's loopback address, with the registers
/// of a map and a watchdog. It turns its motors off when the watchdog register stands still, or, without such
/// a register, when nothing is written. Then the motors' registers are at `off`, and the bit of the time-out
/// is set if the map has one. It serves several connections. Thread: any; it has a thread of its own.
class SimulatedDriver {
public:
    /// map: with motors; its link is not used. watchdog: time until the motors are turned off.
    /// Error: unavailable, when no port can be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<SimulatedDriver>>
    start(const RegisterMap& map, std::chrono::milliseconds watchdog = std::chrono::milliseconds(100));
    virtual ~SimulatedDriver() = default;
    SimulatedDriver(const SimulatedDriver&) = delete;
    SimulatedDriver& operator=(const SimulatedDriver&) = delete;

    /// On 127.0.0.1.
    [[nodiscard]] virtual std::uint16_t port() const = 0;
    /// How often the watchdog turned motors off.
    [[nodiscard]] virtual std::uint64_t timeouts() const = 0;

protected:
    SimulatedDriver() = default;
};

} // namespace teleta::modbus
