// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/threads/pacing_clock.h"
#include "devices/modbus/input_reader.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace teleta::modbus {

/// The motors of a bracelet in the registers of a Modbus server. A frame is one write of all six, followed by
/// the watchdog register, which counts up. The status and the board's inputs are read ten times a second, but
/// while motors turn only if the frame took at most 20 ms, since the next one may be that of STOP. The
/// server's answer to the write is the frame's echo. Any failure ends the connection and zeroes the motors:
/// with an answer if the server still answers, otherwise blindly. Thread: one at a time; write waits for the
/// answers.
class ModbusBraceletPort : public core::BraceletPort {
public:
    /// map: with tactors. clock: not null.
    ModbusBraceletPort(const RegisterMap& map, std::unique_ptr<RegisterLink> link,
                       std::shared_ptr<const core::PacingClock> clock);

    /// The frame's timeout is not sent: the server's own watchdog stops the motors.
    [[nodiscard]] bool write(std::uint16_t sequence, const core::Drive& drive,
                             std::uint16_t timeout_ms) override;
    [[nodiscard]] Read read(core::BoardReport& report) override;
    [[nodiscard]] std::string failure() const override { return m_failure; }

private:
    [[nodiscard]] Answer writeAll(const core::Drive& drive);
    [[nodiscard]] Answer readBoard();
    void zeroOnTheWayOut(const Answer& answer);
    [[nodiscard]] bool statusBit(std::optional<int> bit) const;

    TactorRegisters m_tactors;
    std::optional<std::uint16_t> m_watchdogAddress;
    std::optional<StatusRegister> m_status;
    bool m_tellsSupply;
    bool m_tellsTemperature;
    std::unique_ptr<RegisterLink> m_link;
    std::shared_ptr<const core::PacingClock> m_clock;
    InputReader m_boardReader; ///< status, supply, temperature, as far as the map has them
    std::vector<double> m_boardValues;
    std::int64_t m_boardRead_ns = 0;
    bool m_boardWasRead = false;
    std::uint16_t m_watchdog = 0;
    std::deque<core::BoardReport> m_reports;
    std::string m_failure;
};

} // namespace teleta::modbus
