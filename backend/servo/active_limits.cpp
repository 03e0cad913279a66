// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo/active_limits.h"

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

} // namespace teleta::servo
