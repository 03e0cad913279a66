// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/key_names.h"

#include "backend/core/unit_names.h"

#include <algorithm>
#include <cstddef>

namespace teleta::core {

namespace {

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
