// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace teleta::core {

/// Seconds from one reading of the steady clock to another; negative when they are in reverse order.
[[nodiscard]] constexpr double elapsed_s(std::int64_t from_ns, std::int64_t to_ns) {
    return static_cast<double>(to_ns - from_ns) * 1e-9;
}

} // namespace teleta::core
