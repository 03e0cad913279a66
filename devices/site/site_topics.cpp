// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/site_topics.h"

#include <algorithm>
#include <cstddef>

namespace teleta::site_link {

namespace {

constexpr std::size_t kLongestName = 31;

bool isSmallLetter(char c) {
    return c >= 'a' && c <= 'z';
}

} // namespace

bool isSiteName(std::string_view name) {
    return !name.empty() && name.size() <= kLongestName && isSmallLetter(name.front()) &&
           std::ranges::all_of(name,
                               [](char c) { return isSmallLetter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

std::optional<std::string> SiteTopics::consoleOf(std::string_view presenceTopic) const {
    const std::string before = m_prefix + std::string(kConsole);
    const std::string after = '/' + std::string(kPresence);
    if (!presenceTopic.starts_with(before) || !presenceTopic.ends_with(after) ||
        presenceTopic.size() < before.size() + after.size())
        return std::nullopt;
    const std::string_view name =
        presenceTopic.substr(before.size(), presenceTopic.size() - before.size() - after.size());
    return isSiteName(name) ? std::optional(std::string(name)) : std::nullopt;
}

std::optional<std::string> siteOfInfo(std::string_view ddsTopic) {
    constexpr std::string_view kBefore = "rt/teleta/";
    constexpr std::string_view kAfter = "/info";
    if (!ddsTopic.starts_with(kBefore) || !ddsTopic.ends_with(kAfter) ||
        ddsTopic.size() < kBefore.size() + kAfter.size())
        return std::nullopt;
    const std::string_view name =
        ddsTopic.substr(kBefore.size(), ddsTopic.size() - kBefore.size() - kAfter.size());
    return isSiteName(name) ? std::optional(std::string(name)) : std::nullopt;
}

} // namespace teleta::site_link
