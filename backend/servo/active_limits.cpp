// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/active_limits.h"

#include <algorithm>

namespace teleta::servo {

const char* toString(Limit limit) {
    switch (limit) {
    case Limit::toolSpeed:
        return "tool_speed";
    case Limit::turnRate:
        return "turn_rate";
    case Limit::force:
        return "force";
    case Limit::saturation:
        return "saturation";
    case Limit::deviation:
        return "deviation";
    case Limit::jointSpeed:
        return "joint_speed";
    case Limit::jointEnd:
        return "joint_end";
    case Limit::singular:
        return "singular";
    case Limit::gap:
        return "gap";
    case Limit::badInput:
        return "bad_input";
    }
    return "";
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
        std::size_t i = 0;
        while (i < kLimits && name != toString(static_cast<Limit>(i)))
            ++i;
        if (i == kLimits)
            return std::nullopt;
        limits.m_bits.set(i);
        names.remove_prefix(std::min(names.size(), name.size() + 1));
    }
    return limits;
}

} // namespace teleta::servo
