// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace teleta::core {

/// The words by which files name the values of an enumeration, in the order of the values, which count from
/// 0. Thread: any (pure).
template <typename Enumeration, std::size_t kCount>
struct Words {
    std::array<const char*, kCount> words;

    [[nodiscard]] constexpr const char* of(Enumeration value) const {
        return words[static_cast<std::size_t>(value)];
    }
    /// The inverse; empty for any other word.
    [[nodiscard]] constexpr std::optional<Enumeration> find(std::string_view word) const {
        for (std::size_t i = 0; i < kCount; ++i) {
            if (word == words[i])
                return static_cast<Enumeration>(i);
        }
        return std::nullopt;
    }
};

} // namespace teleta::core
