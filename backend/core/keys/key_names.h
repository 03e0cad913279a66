// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace teleta::core {

/// The allowed name that a misspelt one most likely stands for: the smallest number of inserted, deleted,
/// changed and swapped characters, letter case aside, at most a third of the length. Empty when none is near.
/// Thread: any (pure).
[[nodiscard]] std::string_view nearestName(std::string_view name,
                                           const std::vector<std::string_view>& allowed);

/// What an unknown key most likely stands for.
struct KeyMatch {
    enum class Kind {
        none,
        unitMissing, ///< "radius" for "radius_m"
        otherUnit,   ///< "radius_mm" for "radius_m"
        similar,     ///< "radus_m" for "radius_m"
    };
    Kind kind = Kind::none;
    std::string name; ///< the allowed key
};

/// Thread: any (pure).
[[nodiscard]] KeyMatch matchKey(std::string_view key, const std::vector<std::string>& allowed);

} // namespace teleta::core
