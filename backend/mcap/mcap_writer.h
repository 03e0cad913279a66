// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/output_file.h"
#include "backend/core/error.h"
#include "backend/mcap/byte_fields.h"
#include "backend/mcap/chunk_compression.h"
#include "backend/mcap/mcap_types.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::mcap {

struct WriterOptions {
    std::string profile = "ros2";
    std::string library; ///< name and version of the program
    Compression compression = Compression::zstd;
    std::size_t chunkBytes = std::size_t{4} << 20U; ///< a chunk is closed when its records have so many
};

/// Writes an MCAP file: schemas, channels and messages in chunks, then a summary with indexes. The file
/// appears under its name with finish(). Memory: two chunks and the indexes, 60 bytes a chunk and 10 more for
/// each of its channels. Thread: one. Source: MCAP specification, version 0.
class McapWriter {
public:
    /// Error: ioFailed.
    [[nodiscard]] static core::Expected<McapWriter> create(const std::string& path, WriterOptions options);

    /// A type of messages, defined in ros2msg; returns its number, the same for one that is there already.
    std::uint16_t addSchema(const std::string& name, const std::string& text);
    /// A topic with messages in CDR; returns its number.
    std::uint16_t addChannel(std::uint16_t schema, const std::string& topic);

    /// Adds a message. log_ns: UTC; messages of a chunk are put in its order. encode(std::string&): appends
    /// the message in CDR.
    template <typename Encode>
    void addMessage(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_ns,
                    const Encode& encode) {
        const std::size_t start = m_chunk.size();
        appendRecord(m_chunk, Opcode::message, [&] {
            appendNumber(m_chunk, channel);
            appendNumber(m_chunk, sequence);
            appendNumber(m_chunk, log_ns);
            appendNumber(m_chunk, log_ns);
            encode(m_chunk);
        });
        keepPlace(channel, log_ns, start);
    }

    void add(const Attachment& attachment);
    void add(const Metadata& metadata);

    /// The file cannot be written; there is no use in going on, and finish() says why.
    [[nodiscard]] bool failed() const { return m_file.failed(); }
    [[nodiscard]] std::uint64_t messages() const { return m_messages; }
    /// In the file, without the chunk that is being filled.
    [[nodiscard]] std::uint64_t bytes() const { return m_size; }

    /// Completes the file. Error: ioFailed; no file is left then.
    [[nodiscard]] core::Expected<void> finish();

private:
    struct Place {
        std::uint64_t log_ns;
        std::size_t offset; ///< within the records of the chunk
        std::size_t size;
        std::uint16_t channel;
    };

    McapWriter(core::OutputFile file, WriterOptions options);
    void keepPlace(std::uint16_t channel, std::uint64_t log_ns, std::size_t start);
    void putInOrder();
    void closeChunk();
    void write(std::string_view bytes);
    /// Ends a group of records of the summary that begins at an offset in `summary`.
    void closeGroup(Opcode opcode, const std::string& summary, std::size_t start, std::string& offsets) const;
    void appendStatistics(std::string& summary) const;

    core::OutputFile m_file;
    WriterOptions m_options;
    ChunkCompressor m_compressor;
    std::string m_chunk;         ///< records of the chunk that is being filled
    std::vector<Place> m_places; ///< of its messages
    std::string m_scratch;
    std::map<std::pair<std::string, std::string>, std::uint16_t> m_schemaIds; ///< by name and text
    std::vector<std::string> m_schemas;                                       ///< records
    std::vector<std::string> m_channels;                                      ///< records
    std::string m_chunkIndexes;                                               ///< records, as the next two
    std::string m_attachmentIndexes;
    std::string m_metadataIndexes;
    std::uint32_t m_chunks = 0;
    std::uint32_t m_attachments = 0;
    std::uint32_t m_metadata = 0;
    std::vector<std::uint64_t> m_counts; ///< messages of each channel
    std::uint64_t m_messages = 0;
    std::uint64_t m_first_ns = 0;
    std::uint64_t m_last_ns = 0;
    std::uint64_t m_size = 0; ///< bytes written
    std::uint32_t m_crc = 0;  ///< of them
};

} // namespace teleta::mcap
