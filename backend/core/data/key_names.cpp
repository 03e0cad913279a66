// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/key_names.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace teleta::core {

namespace {

struct Unit {
    std::string_view suffix; ///< of a key
    std::string_view text;
};
constexpr std::array<Unit, 37> kUnits{{{"_N_per_mm", "N/mm"},
                                       {"_N_per_m", "N/m"},
                                       {"_Ns_per_m", "N s/m"},
                                       {"_m_per_s", "m/s"},
                                       {"_m_per_s2", "m/s²"},
                                       {"_mm_per_s", "mm/s"},
                                       {"_rad_per_s", "rad/s"},
                                       {"_rad_per_s2", "rad/s²"},
                                       {"_deg_per_s", "°/s"},
                                       {"_Nm_per_rad", "N m/rad"},
                                       {"_Nms_per_rad", "N m s/rad"},
                                       {"_per_m", "1/m"},
                                       {"_per_s", "1/s"},
                                       {"_Nm", "N m"},
                                       {"_mN", "mN"},
                                       {"_kN", "kN"},
                                       {"_N", "N"},
                                       {"_mm", "mm"},
                                       {"_cm", "cm"},
                                       {"_um", "µm"},
                                       {"_m", "m"},
                                       {"_ms", "ms"},
                                       {"_us", "µs"},
                                       {"_ns", "ns"},
                                       {"_min", "min"},
                                       {"_s", "s"},
                                       {"_kHz", "kHz"},
                                       {"_MHz", "MHz"},
                                       {"_Hz", "Hz"},
                                       {"_rad", "rad"},
                                       {"_deg", "°"},
                                       {"_kgm2", "kg m²"},
                                       {"_kg", "kg"},
                                       {"_kPa", "kPa"},
                                       {"_Pa", "Pa"},
                                       {"_percent", "%"},
                                       {"_px", "px"}}};

/// The longest unit at the end of a key; empty: none.
Unit unitAtEnd(std::string_view key) {
    Unit longest;
    for (const Unit& unit : kUnits)
        if (key.size() > unit.suffix.size() && key.ends_with(unit.suffix) &&
            unit.suffix.size() > longest.suffix.size())
            longest = unit;
    return longest;
}

std::string_view withoutUnit(std::string_view key) {
    return key.substr(0, key.size() - unitAtEnd(key).suffix.size());
}

char lowered(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Optimal string alignment: insertions, deletions, changes and swaps of neighbours, letter case aside.
std::size_t editDistance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> cost((a.size() + 1) * width);
    const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return cost[i * width + j]; };
    const auto same = [&](std::size_t i, std::size_t j) { return lowered(a[i]) == lowered(b[j]); };
    for (std::size_t i = 0; i <= a.size(); ++i)
        at(i, 0) = i;
    for (std::size_t j = 0; j <= b.size(); ++j)
        at(0, j) = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            at(i, j) = std::min(
                {at(i - 1, j - 1) + (same(i - 1, j - 1) ? 0 : 1), at(i - 1, j) + 1, at(i, j - 1) + 1});
            if (i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1))
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return cost.back();
}

} // namespace

std::string_view unitOf(std::string_view key) {
    return unitAtEnd(key).text;
}

std::string_view nearestName(std::string_view name, const std::vector<std::string_view>& allowed) {
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string_view candidate : allowed) {
        const std::size_t distance = editDistance(name, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

KeyMatch matchKey(std::string_view key, const std::vector<std::string>& allowed) {
    for (const std::string& candidate : allowed) {
        if (!unitOf(candidate).empty() && withoutUnit(candidate) == withoutUnit(key))
            return {unitOf(key).empty() ? KeyMatch::Kind::unitMissing : KeyMatch::Kind::otherUnit, candidate};
    }
    const std::string_view similar = nearestName(key, {allowed.begin(), allowed.end()});
    if (similar.empty())
        return {};
    return {KeyMatch::Kind::similar, std::string(similar)};
}

} // namespace teleta::core
