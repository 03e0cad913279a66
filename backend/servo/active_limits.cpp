// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/active_limits.h"

#include <algorithm>
#include <array>

namespace teleta::servo {

namespace {

constexpr std::array<const char*, kLimits> kLimitNames{"tool_speed", "turn_rate",   "force",     "saturation",
                                                       "deviation",  "joint_speed", "joint_end", "singular",
                                                       "gap",        "bad_input"};

} // namespace

const char* toString(Limit limit) {
    return kLimitNames[static_cast<std::size_t>(limit)];
}

std::string ActiveLimits::names() const {
    std::string names;
    for (std::size_t i = 0; i < kLimits; ++i) {
        if (!m_bits[i])
            continue;
        if (!names.empty())
            names += '+';
        names += toString(static_cast<Limit>(i));
    }
    return names;
}

std::optional<ActiveLimits> ActiveLimits::fromNames(std::string_view names) {
    ActiveLimits limits;
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find('+'));
        const auto known = std::ranges::find(kLimitNames, name);
        if (known == kLimitNames.end())
            return std::nullopt;
        limits.m_bits.set(static_cast<std::size_t>(known - kLimitNames.begin()));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
    }
    return limits;
}

} // namespace teleta::servo
