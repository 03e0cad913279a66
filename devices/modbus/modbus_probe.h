// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/threads/pacing_clock.h"
#include "devices/modbus/register_link.h"

#include <memory>
#include <optional>
#include <vector>

namespace teleta::modbus {

/// What a server answered when it was asked for everything in its map.
struct ModbusProbe {
    std::optional<double> frameRate_Hz; ///< frames that the motors can take a second; nothing without motors
    std::optional<double> inputRate_Hz; ///< readings of all inputs a second; nothing without inputs
    std::vector<double> values;         ///< of the map's inputs, in their units
};

/// Connects, sets the motors to zero, measures how fast they take frames and how fast the inputs are read,
/// and closes the connection. Waits for the server, some time-outs at most.
/// Error: unavailable, with the reason. Thread: any.
[[nodiscard]] core::Expected<ModbusProbe> probeModbus(const RegisterMap& map, const LinkOpener& opener,
                                                      const std::shared_ptr<const core::PacingClock>& clock);

} // namespace teleta::modbus
