// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace teleta::mcap {

/// The first and the last bytes of each file.
inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

/// The first byte of a record; its length follows as u64.
enum class Opcode : std::uint8_t {
    header = 0x01,
    footer = 0x02,
    schema = 0x03,
    channel = 0x04,
    message = 0x05,
    chunk = 0x06,
    messageIndex = 0x07,
    chunkIndex = 0x08,
    attachment = 0x09,
    attachmentIndex = 0x0A,
    statistics = 0x0B,
    metadata = 0x0C,
    metadataIndex = 0x0D,
    summaryOffset = 0x0E,
    dataEnd = 0x0F,
};

/// Bytes before the content of a record.
inline constexpr std::size_t kRecordHead = 1 + 8;
/// Bytes of a footer's content.
inline constexpr std::size_t kFooterContent = 8 + 8 + 4;

using TextMap = std::map<std::string, std::string>;

/// The definition of a type of messages.
struct Schema {
    std::uint16_t id = 0;
    std::string name;     ///< "sensor_msgs/msg/Image"
    std::string encoding; ///< "ros2msg"
    std::string text;
};

/// A topic.
struct Channel {
    std::uint16_t id = 0;
    std::uint16_t schema = 0; ///< 0: none
    std::string topic;
    std::string encoding; ///< of its messages: "cdr"
    TextMap metadata;
};

/// A file within the file.
struct Attachment {
    std::uint64_t log_ns = 0;
    std::uint64_t create_ns = 0;
    std::string name;
    std::string mediaType;
    std::string data;
};

/// Names and texts about the file.
struct Metadata {
    std::string name;
    TextMap values;
};

} // namespace teleta::mcap
