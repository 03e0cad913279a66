// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace teleta::site_link {

inline constexpr std::string_view kDeclined = "declined";

/// RequestResult.message of an offer or a take-over that another console declined; reason: may be empty.
/// Thread: any (pure).
[[nodiscard]] inline std::string declineMessage(std::string_view reason) {
    return std::string(kDeclined) + (reason.empty() ? "" : ": ") + std::string(reason);
}

/// Its reason, empty without one. Nothing: the message says something else. Thread: any (pure).
[[nodiscard]] inline std::optional<std::string> declineReason(std::string_view message) {
    constexpr std::string_view kBetween = ": ";
    if (!message.starts_with(kDeclined))
        return std::nullopt;
    message.remove_prefix(kDeclined.size());
    if (message.empty())
        return std::string();
    return message.starts_with(kBetween) ? std::optional(std::string(message.substr(kBetween.size())))
                                         : std::nullopt;
}

} // namespace teleta::site_link
