// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_depth.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace teleta::core {

namespace {

/// The position behind the text in quotes that begins at one.
std::size_t behindString(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string_view three(text.data() + begin, std::min<std::size_t>(3, text.size() - begin));
    const bool isLong = three.size() == 3 && three[1] == quote && three[2] == quote;
    std::size_t i = begin + (isLong ? 3 : 1);
    while (i < text.size()) {
        if (text[i] == '\\' && quote == '"') {
            i += 2;
        } else if (!isLong && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        } else if (isLong && text.substr(i, 3) == three) {
            // Up to two quotes may stand right before the closing ones.
            i += 3;
            for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more)
                ++i;
            return i;
        } else {
            ++i;
        }
    }
    return text.size();
}

TextPlace placeOf(std::string_view text, std::size_t offset) {
    TextPlace place;
    for (const char c : text.substr(0, offset)) {
        if (c == '\n') {
            ++place.line;
            place.column = 1;
        } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
            ++place.column;
        }
    }
    return place;
}

} // namespace

std::optional<TextPlace> tomlDeeperThan(std::string_view text, int most) {
    std::vector<int> outer; // dots of the keys in front of the open brackets
    int outerDots = 0;
    int dots = 0;
    for (std::size_t i = 0; i < text.size();) {
        switch (text[i]) {
        case '"':
        case '\'':
            i = behindString(text, i);
            continue;
        case '#':
            i = std::min(text.find('\n', i), text.size());
            continue;
        case '{':
        case '[':
            outer.push_back(dots);
            outerDots += dots;
            dots = 0;
            break;
        case '}':
        case ']':
            if (!outer.empty()) {
                dots = outer.back();
                outerDots -= dots;
                outer.pop_back();
            }
            break;
        case ',':
            dots = 0;
            break;
        case '\n':
            // The key of an array that goes on is among the outer ones.
            dots = 0;
            break;
        case '.':
            ++dots;
            break;
        default:
            break;
        }
        if (static_cast<int>(outer.size()) + outerDots + dots > most)
            return placeOf(text, i);
        ++i;
    }
    return std::nullopt;
}

} // namespace teleta::core
