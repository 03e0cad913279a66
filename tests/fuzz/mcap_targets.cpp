// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/mcap_reader.h"
#include "backend/mcap/recorded/imported_recording.h"
#include "backend/mcap/recorded/message_decoder.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"

#include <array>
#include <string>
#include <string_view>

namespace teleta::fuzz {

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20U;

bool isSound(const mcap::DecodedMessage& decoded, mcap::TopicRole role) {
    std::size_t values = 1;
    for (const std::size_t side : decoded.shape)
        values *= side;
    if (role == mcap::TopicRole::event)
        return true;
    if (!decoded.image.isEmpty())
        return values == static_cast<std::size_t>(decoded.image.width_px) *
                             static_cast<std::size_t>(decoded.image.height_px);
    return values > 0 &&
           (decoded.floats.size() == values || decoded.doubles.size() == decoded.frames * values);
}

} // namespace

bool mcapFile(Bytes bytes) {
    const mcap::ReaderLimits limits{
        .chunkBytes = kMostBytes, .openBytes = kMostBytes, .recordBytes = kMostBytes};
    const std::string text = textOf(bytes);
    auto reader = mcap::McapReader::open(mcap::bytesOf(text), kInput, limits);
    if (!reader) {
        requireExplained(reader.error());
        return false;
    }
    const mcap::FileMap& map = reader->map();
    require(map.wholeBytes <= bytes.size(), "whole records end with the file");
    for (const mcap::AttachmentPlace& place : map.attachments) {
        if (const auto attachment = reader->attachment(place); !attachment)
            requireExplained(attachment.error());
    }
    (void)mcap::importedRecording(*reader, kInput);
    mcap::Message message;
    mcap::DecodedMessage decoded;
    while (reader->next(message)) {
        require(message.data.size() <= kMostBytes, "a message fits into its chunk");
        const auto channel = map.channels.find(message.channel);
        if (channel == map.channels.end())
            continue;
        const mcap::Schema* schema = reader->schemaOf(channel->second);
        const auto role = mcap::roleOf(channel->second, schema, {});
        if (role)
            (void)mcap::decodeMessage(*role, message.data, mcap::schemaColumns(*role, *schema).size(),
                                      decoded);
    }
    (void)reader->checkDataSection();
    return map.isComplete;
}

/// The first byte chooses what the message is read as, the second how many columns it has.
bool mcapMessage(Bytes bytes) {
    constexpr std::array kRoles{
        mcap::TopicRole::arrayImage,    mcap::TopicRole::cameraImage,   mcap::TopicRole::arrayPicture,
        mcap::TopicRole::cameraPicture, mcap::TopicRole::tactileArray,  mcap::TopicRole::multiArray,
        mcap::TopicRole::joints,        mcap::TopicRole::wrench,        mcap::TopicRole::features,
        mcap::TopicRole::touch,         mcap::TopicRole::contacts,      mcap::TopicRole::tactors,
        mcap::TopicRole::event,         mcap::TopicRole::colourPicture, mcap::TopicRole::colourImage};
    if (bytes.size() < 2)
        return false;
    const mcap::TopicRole role = kRoles[bytes[0] % kRoles.size()];
    const std::string text = textOf(bytes);
    const std::string_view message = std::string_view(text).substr(2);
    mcap::DecodedMessage decoded;
    const bool isGood = mcap::decodeMessage(role, message, bytes[1], decoded);
    if (isGood)
        require(isSound(decoded, role), "a message has the values of its shape");
    (void)mcap::imageRoleOf(mcap::TopicRole::arrayImage, message);
    (void)mcap::imageRoleOf(mcap::TopicRole::cameraPicture, message);
    return isGood;
}

} // namespace teleta::fuzz
