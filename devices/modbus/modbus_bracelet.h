// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_link.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/modbus/register_link.h"

#include <memory>

namespace teleta::modbus {

/// Connects to the motors of a map: sets them to zero before anything else, then measures how long a frame
/// takes and takes from it the rate that the description tells:
///   maximumRate_Hz = min(200, 0.8 / median write time)
/// Error: the map has no motors; the server is not there or refuses the registers. map and clock are kept.
[[nodiscard]] core::BraceletOpener modbusBraceletOpener(RegisterMap map, LinkOpener link,
                                                        std::shared_ptr<const core::PacingClock> clock);

/// Opens the motors of a map by libmodbus as a bracelet, which keeps itself connected. stopSwitch must
/// outlive it. Error: as above.
[[nodiscard]] core::Expected<std::unique_ptr<core::BraceletLink>>
openModbusBracelet(const RegisterMap& map, const core::StopSwitch& stopSwitch,
                   core::BraceletLinkConfig config = {});

} // namespace teleta::modbus
