// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace teleta::core {

/// Levels of a key in a TOML file: parts between dots and brackets around it, for a header and for what
/// follows it.
inline constexpr int kDeepestToml = 64;
/// The largest TOML file.
inline constexpr std::size_t kMostTomlBytes = std::size_t{16} << 20U;

/// Line and column from 1, in characters.
struct TextPlace {
    long long line = 1;
    long long column = 1;
};

/// Where the keys of a TOML text first go deeper than most levels, counting brackets and the dots of keys;
/// empty: nowhere. toml++ calls itself for every level when it throws a table away, and so ends the program
/// for a key of some ten thousand parts. Works on any text. Thread: any (pure).
[[nodiscard]] std::optional<TextPlace> tomlDeeperThan(std::string_view text, int most);

} // namespace teleta::core
