// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/modbus/register_link.h"

namespace teleta::modbus {

/// Connects to the server of a map by libmodbus, over TCP or a serial line (RTU). Resolving the host name may
/// take longer than the timeout. Late answers to earlier requests are discarded before each request; over TCP
/// the transaction number identifies the rest. RTU has no such number, so close the link there after a
/// timeout. Error: unavailable, with the reason.
[[nodiscard]] core::Expected<std::unique_ptr<RegisterLink>> openLibmodbusLink(const RegisterMap& map);

/// The same as an opener that keeps the map.
[[nodiscard]] LinkOpener libmodbusOpener(RegisterMap map);

} // namespace teleta::modbus
