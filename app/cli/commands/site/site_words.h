// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/site/control_arbiter.h"

namespace teleta::cli {

/// As scripts read them. Thread: any (pure).
[[nodiscard]] const char* toString(site::Mode mode);
[[nodiscard]] const char* toString(site::CommandRefusal why);

} // namespace teleta::cli
