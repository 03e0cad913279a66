// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace teleta::core {

/// Formats a text as a TOML basic string, including the quotation marks. Thread: any (pure).
[[nodiscard]] inline std::string quotedToml(const std::string& text) {
    constexpr char kHex[] = "0123456789ABCDEF";
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            (result += '\\') += c;
        else if (byte < 0x20 || byte == 0x7F)
            ((result += "\\u00") += kHex[byte >> 4U]) += kHex[byte & 15U];
        else
            result += c;
    }
    return result + '"';
}

} // namespace teleta::core
