// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/mcap/byte_source.h"
#include "backend/mcap/file_map.h"
#include "backend/mcap/mcap_types.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::mcap {

/// A message, valid until the next one is read.
struct Message {
    std::uint16_t channel = 0;
    std::uint32_t sequence = 0;
    std::uint64_t log_ns = 0;
    std::uint64_t publish_ns = 0;
    std::string_view data;
};

/// Reads an MCAP file: what is where first, then its messages in the order of their times, chunk by chunk.
/// Chunks that overlap are open at once, as long as their records fit ReaderLimits::openBytes. What is
/// damaged is left out and counted. Thread: one. Source: MCAP specification, version 0.
class McapReader {
public:
    /// name: of the file, for errors. Error: badInput, it is not an MCAP file; ioFailed.
    [[nodiscard]] static core::Expected<McapReader> open(std::unique_ptr<ByteSource> source, std::string name,
                                                         const ReaderLimits& limits = {});
    ~McapReader();
    McapReader(McapReader&&) noexcept;
    McapReader& operator=(McapReader&&) noexcept;

    [[nodiscard]] const FileMap& map() const { return m_map; }
    /// Null when the channel has none.
    [[nodiscard]] const Schema* schemaOf(const Channel& channel) const;
    /// Chunks that were damaged so far, and other records.
    [[nodiscard]] std::uint64_t badChunks() const { return m_map.badChunks + m_damagedChunks; }
    [[nodiscard]] std::uint64_t badRecords() const { return m_map.badRecords + m_damagedRecords; }

    /// The next message; false after the last one.
    [[nodiscard]] bool next(Message& message);

    /// How much of the file has been read, 0 to 1.
    [[nodiscard]] double share() const {
        return m_order.empty() ? 1.0 : static_cast<double>(m_nextChunk) / static_cast<double>(m_order.size());
    }

    /// Error: badInput, it is damaged or too large.
    [[nodiscard]] core::Expected<Attachment> attachment(const AttachmentPlace& place);

    /// Whether the checksum of the data section is right; empty: the file has none, or goOn() returned false.
    [[nodiscard]] std::optional<bool> checkDataSection(const std::function<bool()>& goOn = {});

private:
    struct OpenChunk;

    McapReader(std::unique_ptr<ByteSource> source, std::string name, const ReaderLimits& limits, FileMap map);
    /// Reads and checks the records of a chunk. Empty: it is damaged.
    [[nodiscard]] std::unique_ptr<OpenChunk> load(const ChunkPlace& place);
    [[nodiscard]] bool readRecords(const ChunkPlace& place, std::string& records);
    void findMessages(OpenChunk& chunk, bool isRun);
    void openChunks();
    void findChannels();

    std::unique_ptr<ByteSource> m_source;
    std::string m_name;
    ReaderLimits m_limits;
    FileMap m_map;
    std::uint64_t m_damagedChunks = 0;
    std::uint64_t m_damagedRecords = 0;
    std::vector<std::size_t> m_order; ///< chunks by their first time
    std::size_t m_nextChunk = 0;      ///< within them
    std::vector<std::unique_ptr<OpenChunk>> m_open;
    std::size_t m_openBytes = 0;
};

} // namespace teleta::mcap
