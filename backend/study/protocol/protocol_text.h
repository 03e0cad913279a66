// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <string>

namespace teleta::study {

/// A protocol as the text of its file (TOML): parseProtocol() gives the same protocol again. Whether it is a
/// valid one is parseProtocol()'s business. Thread: any.
[[nodiscard]] std::string protocolText(const Protocol& protocol);

} // namespace teleta::study
