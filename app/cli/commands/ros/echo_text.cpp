// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/ros/echo_text.h"

#include "backend/core/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace teleta::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string oneLine(const Json& value);

std::string escaped(const std::string& text) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20U && byte != 0x7fU) {
            result += c;
            continue;
        }
        result += "\\x";
        result += kDigits[byte >> 4U];
        result += kDigits[byte & 15U];
    }
    return result;
}

std::string oneLine(const Json& value) {
    if (value.is_string())
        return "\"" + escaped(value.get<std::string>()) + "\"";
    if (value.is_number_float())
        return std::string(core::NumberText(value.get<double>()).view());
    if (!value.is_array())
        return value.dump();
    std::string text = "[";
    for (const Json& item : value)
        text += (text.size() > 1 ? ", " : "") + oneLine(item);
    return text + "]";
}

bool isFlat(const Json& value) {
    return value.is_primitive() || (value.is_array() && std::ranges::all_of(value, [](const Json& item) {
                                        return item.is_primitive();
                                    }));
}

void write(std::string& text, const Json& value, std::size_t depth) {
    const std::string indent(2 * depth, ' ');
    if (value.is_array()) {
        for (const Json& item : value) {
            text += indent + "-\n";
            write(text, item, depth + 1);
        }
        return;
    }
    for (const auto& [key, item] : value.items()) {
        text += indent + key + ":";
        if (isFlat(item)) {
            text += " " + oneLine(item) + "\n";
        } else {
            text += "\n";
            write(text, item, depth + 1);
        }
    }
}

} // namespace

std::string echoText(const Json& message) {
    std::string text;
    write(text, message, 0);
    return text + "---\n";
}

} // namespace teleta::cli
