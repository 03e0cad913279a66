// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/node_list.h"

#include "backend/ros/topic_names.h"

#include <string_view>

namespace teleta::ros {

namespace {

template <typename Message>
std::optional<std::vector<Node>> read(const Message& message) {
    std::vector<Node> nodes;
    for (const auto& info : view(message.node_entities_info_seq)) {
        const std::string_view space(info.node_namespace);
        const std::string_view name(info.node_name);
        if (!isNamePart(name) || (space != "/" && !isTopicName(space)))
            return std::nullopt;
        nodes.push_back({std::string(space == "/" ? std::string_view() : space).append("/").append(name),
                         view(info.reader_gid_seq).size(), view(info.writer_gid_seq).size()});
    }
    return nodes.empty() ? std::nullopt : std::optional(std::move(nodes));
}

} // namespace

std::optional<std::vector<Node>> nodesOf(const HumbleNodes& message) {
    return read(message);
}

std::optional<std::vector<Node>> nodesOf(const JazzyNodes& message) {
    return read(message);
}

} // namespace teleta::ros
