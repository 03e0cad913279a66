// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace teleta::simulated {

[[nodiscard]] inline std::int64_t toNs(double time_s) {
    return static_cast<std::int64_t>(std::llround(time_s * 1e9));
}

} // namespace teleta::simulated
