// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <string>

namespace teleta::study {

/// A protocol as TOML: parseProtocol() gives the same protocol back. Validity is not checked here but by
/// parseProtocol(). Thread: any.
[[nodiscard]] std::string protocolText(const Protocol& protocol);

} // namespace teleta::study
