// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/modbus/register_link.h"

namespace teleta::modbus {

/// Connects to the server of a map by libmodbus, over TCP or a serial line (RTU). A host's name is resolved
/// first, which may take longer than the time-out. Whatever came late for an earlier request is thrown away
/// before each request; over TCP the number of the transaction tells the rest. RTU has no such number, so a
/// caller that lets a request time out there should close the link. Error: unavailable, with the reason.
[[nodiscard]] core::Expected<std::unique_ptr<RegisterLink>> openLibmodbusLink(const RegisterMap& map);

/// The same as an opener that keeps the map.
[[nodiscard]] LinkOpener libmodbusOpener(RegisterMap map);

} // namespace teleta::modbus
