// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/passwords.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace teleta::core {

std::string withoutPasswords(std::string text) {
    static constexpr std::string_view kHidden = "***";
    const auto hide = [&text](std::size_t begin, std::size_t end) {
        text.replace(begin, end - begin, kHidden);
        return begin + kHidden.size();
    };
    constexpr std::string_view kScheme = "://";
    for (std::size_t at = text.find(kScheme); at != std::string::npos; at = text.find(kScheme, at)) {
        at += kScheme.size();
        // The last @ before the host's end: an @ in a password should be written %40, but who knows.
        const std::size_t end = std::min(text.find_first_of("/? \n\t\"'", at), text.size());
        const std::size_t host = text.rfind('@', end);
        const std::size_t colon = text.find(':', at);
        if (host != std::string::npos && host > at && colon < host)
            at = hide(colon + 1, host);
    }
    constexpr std::string_view kKey = "password=";
    for (std::size_t at = text.find(kKey); at != std::string::npos; at = text.find(kKey, at)) {
        at += kKey.size();
        at = hide(at, std::min(text.find_first_of("&; \n\t\"'", at), text.size()));
    }
    return text;
}

} // namespace teleta::core
