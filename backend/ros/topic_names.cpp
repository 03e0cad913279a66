// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/topic_names.h"

#include <algorithm>

namespace teleta::ros {

namespace {

constexpr std::string_view kTopicPrefix = "rt";
constexpr std::string_view kDdsMiddle = "::msg::dds_::";
constexpr std::string_view kRosMiddle = "/msg/";
constexpr std::size_t kLongestName = 253;

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

} // namespace

bool isNamePart(std::string_view part) {
    return !part.empty() && isLetter(part.front()) &&
           std::ranges::all_of(part, [](char c) { return isLetter(c) || isDigit(c); });
}

bool isTopicName(std::string_view name) {
    if (name.empty() || name.size() > kLongestName || name.front() != '/')
        return false;
    while (!name.empty()) {
        name.remove_prefix(1);
        const std::size_t end = std::min(name.find('/'), name.size());
        if (!isNamePart(name.substr(0, end)))
            return false;
        name.remove_prefix(end);
    }
    return true;
}

std::string ddsTopicOf(std::string_view topic) {
    return std::string(kTopicPrefix).append(topic);
}

std::optional<std::string> rosTopicOf(std::string_view ddsTopic) {
    if (!ddsTopic.starts_with(kTopicPrefix) || !isTopicName(ddsTopic.substr(kTopicPrefix.size())))
        return std::nullopt;
    return std::string(ddsTopic.substr(kTopicPrefix.size()));
}

std::optional<std::string> ddsTypeOf(std::string_view type) {
    const std::size_t middle = type.find(kRosMiddle);
    if (middle == std::string_view::npos)
        return std::nullopt;
    const std::string_view package = type.substr(0, middle);
    const std::string_view name = type.substr(middle + kRosMiddle.size());
    if (!isNamePart(package) || !isNamePart(name))
        return std::nullopt;
    return std::string(package).append(kDdsMiddle).append(name).append("_");
}

std::string rosTypeOf(std::string_view ddsType) {
    const std::size_t middle = ddsType.find(kDdsMiddle);
    if (middle != std::string_view::npos && ddsType.ends_with('_')) {
        const std::string_view package = ddsType.substr(0, middle);
        std::string_view name = ddsType.substr(middle + kDdsMiddle.size());
        name.remove_suffix(name.empty() ? 0 : 1);
        if (isNamePart(package) && isNamePart(name))
            return std::string(package).append(kRosMiddle).append(name);
    }
    return std::string(ddsType);
}

} // namespace teleta::ros
