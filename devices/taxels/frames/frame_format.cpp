// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/frame_format.h"

#include <nlohmann/json.hpp>

namespace teleta::taxels {

std::size_t ValueField::bytes() const {
    if (count == 0)
        return 0;
    const std::size_t last = count - 1;
    return last / perGroup * groupBytes() + (last % perGroup + 1) * sizeOf(field.type);
}

std::optional<std::size_t> positionOf(long long at, std::size_t bytes, std::size_t length) {
    const auto whole = static_cast<long long>(length);
    const long long begin = at < 0 ? whole + at : at;
    if (begin < 0 || begin > whole || static_cast<std::size_t>(whole - begin) < bytes)
        return std::nullopt;
    return static_cast<std::size_t>(begin);
}

bool isJsonPointer(const std::string& text) {
    try {
        const nlohmann::json::json_pointer pointer(text);
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

} // namespace teleta::taxels
