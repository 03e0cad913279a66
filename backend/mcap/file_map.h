// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/mcap/byte_source.h"
#include "backend/mcap/mcap_types.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace teleta::mcap {

/// What a reader takes at most into memory at once.
struct ReaderLimits {
    /// Records of a chunk, as they are kept and decompressed. Larger chunks are left out and counted.
    std::size_t chunkBytes = std::size_t{64} << 20U;
    /// Chunks that overlap in time, together.
    std::size_t openBytes = std::size_t{32} << 20U;
    /// Any other record, and the summary.
    std::size_t recordBytes = std::size_t{64} << 20U;
};

/// Where messages are: a chunk, or a run of messages outside of chunks.
struct ChunkPlace {
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = 0;
    std::uint64_t offset = 0; ///< of the record
    std::uint64_t length = 0; ///< of the record, or of all records of a run
    std::uint64_t size = 0;   ///< of the records of a chunk
    bool isRun = false;
};

struct AttachmentPlace {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::string name;
    std::string mediaType;
    std::uint64_t size = 0; ///< of its data
};

/// What is where in a file.
struct FileMap {
    std::string profile;
    std::string library;
    std::vector<ChunkPlace> chunks; ///< in the file's order
    std::vector<AttachmentPlace> attachments;
    std::vector<Metadata> metadata;
    std::map<std::uint16_t, Schema> schemas; ///< outside of chunks, as the next
    std::map<std::uint16_t, Channel> channels;
    std::uint64_t badChunks = 0;          ///< that cannot be what they say
    std::uint64_t badRecords = 0;         ///< others
    bool usesIndex = false;               ///< chunks were found by the index of the summary
    bool isComplete = false;              ///< the file ends with a footer
    std::uint64_t bytes = 0;              ///< of the file
    std::uint64_t wholeBytes = 0;         ///< up to the end of the last whole record
    std::uint64_t dataEnd = 0;            ///< where the data section ends
    std::optional<std::uint32_t> dataCrc; ///< of the data section; empty: not known
};

/// Finds out what is where: with the index of the summary where there is one that holds, otherwise record by
/// record to the last whole one. name: of the file, for errors. Error: badInput, it is not an MCAP file.
[[nodiscard]] core::Expected<FileMap> readFileMap(ByteSource& source, const std::string& name,
                                                  const ReaderLimits& limits);

/// Reads the content of a Schema or Channel record into the map of its kind, which keeps the first one of a
/// number. False: it is damaged, or the number is 0 where that means "none".
[[nodiscard]] bool readSchema(std::string_view content, std::map<std::uint16_t, Schema>& schemas);
[[nodiscard]] bool readChannel(std::string_view content, std::map<std::uint16_t, Channel>& channels);

} // namespace teleta::mcap
