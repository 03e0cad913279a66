// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace teleta::simulation {

/// Time that an effect took since the start, in s.
struct EffectTime {
    std::string_view name;
    double time_s = 0.0;
};

} // namespace teleta::simulation
