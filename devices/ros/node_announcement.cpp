// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/node_announcement.h"

#include "backend/ros/messages.h"
#include "backend/ros/node_list.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <span>
#include <type_traits>

namespace teleta::ros_arm {

namespace {

/// Gids of Humble are longer; the rest is 0.
template <typename Gid>
Gid gidOf(const dds::Guid& guid) {
    Gid gid{};
    std::ranges::copy(guid, std::begin(gid.data));
    return gid;
}

template <typename Gid>
std::vector<Gid> gidsOf(const std::vector<dds::Guid>& guids) {
    std::vector<Gid> gids;
    std::ranges::transform(guids, std::back_inserter(gids), gidOf<Gid>);
    return gids;
}

template <std::size_t kSize>
void copyText(char (&to)[kSize], const std::string& text) {
    std::memcpy(to, text.c_str(), std::min(text.size(), kSize - 1));
}

template <typename Message>
core::Expected<dds::AnyWriter> tell(const std::shared_ptr<const dds::Participant>& participant,
                                    const std::string& name, const std::vector<dds::Guid>& readers,
                                    const std::vector<dds::Guid>& writers) {
    using Gid = decltype(Message::gid);
    using Node = std::remove_pointer_t<decltype(Message::node_entities_info_seq._buffer)>;
    TELETA_TRY(dds::AnyWriter writer,
               dds::AnyWriter::open(participant, ros::kNodesTopic, ros::descriptorOf<Message>(),
                                    ros::kLatchedWriter));
    std::vector<Gid> readerGids = gidsOf<Gid>(readers);
    std::vector<Gid> writerGids = gidsOf<Gid>(writers);
    std::array<Node, 1> nodes{};
    copyText(nodes[0].node_namespace, "/");
    copyText(nodes[0].node_name, name);
    ros::lend(nodes[0].reader_gid_seq, std::span(readerGids));
    ros::lend(nodes[0].writer_gid_seq, std::span(writerGids));
    Message message{};
    message.gid = gidOf<Gid>(participant->guid());
    ros::lend(message.node_entities_info_seq, std::span(nodes));
    // Who is not told sees a program without a name.
    (void)writer.writeAny(&message);
    return writer;
}

} // namespace

core::Expected<NodeAnnouncement>
NodeAnnouncement::open(const std::shared_ptr<const dds::Participant>& participant, Distribution distribution,
                       const std::string& name, const std::vector<dds::Guid>& readers,
                       const std::vector<dds::Guid>& writers) {
    TELETA_TRY(dds::AnyWriter writer, distribution == Distribution::humble
                                          ? tell<ros::HumbleNodes>(participant, name, readers, writers)
                                          : tell<ros::JazzyNodes>(participant, name, readers, writers));
    return NodeAnnouncement(std::move(writer));
}

} // namespace teleta::ros_arm
