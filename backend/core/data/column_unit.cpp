// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/column_unit.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace teleta::core {

std::string columnUnit(std::string_view unit) {
    // The micro sign and the Greek letter.
    static constexpr std::array<std::string_view, 2> kMicro{"\u00b5", "\u03bc"};
    if (unit.empty())
        return "counts";
    std::string name;
    while (!unit.empty()) {
        std::size_t read = 1;
        const auto c = static_cast<unsigned char>(unit.front());
        if (std::ranges::any_of(kMicro, [&](std::string_view micro) { return unit.starts_with(micro); })) {
            name += 'u';
            read = kMicro.front().size();
        } else if (c == '/') {
            name += "_per_";
        } else if (std::isalnum(c) != 0) {
            name += static_cast<char>(std::tolower(c));
        }
        unit.remove_prefix(read);
    }
    return name;
}

std::string momentColumnUnit(std::string_view loadUnit) {
    return columnUnit(loadUnit) + (loadUnit == "N" ? "m" : "_m"); // "n_m" would be no unit
}

} // namespace teleta::core
