// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/file_map.h"

#include "backend/core/failure.h"
#include "backend/mcap/byte_fields.h"
#include "backend/mcap/chunk_compression.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>
#include <zlib.h>

namespace teleta::mcap {

namespace {

struct FileMapText {
    Q_DECLARE_TR_FUNCTIONS(McapFile)
};

/// How far a chunk and its message indexes reach, by the index of the summary.
struct IndexedChunk {
    std::uint64_t length = 0;
    std::uint64_t indexLength = 0;
};
using ChunkIndexes = std::map<std::uint64_t, IndexedChunk>; ///< by offset

constexpr std::size_t kWindow = std::size_t{64} << 10U;
constexpr std::uint64_t kRunBytes = std::uint64_t{4} << 20U;
/// Of a chunk, up to its compressed bytes, with a word that is longer than any that is known.
constexpr std::size_t kChunkHead = 8 + 8 + 8 + 4 + 4 + 16 + 8;
constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;

/// Reads many small pieces that lie close together.
class Window {
public:
    explicit Window(ByteSource& source)
        : m_source(source) {}

    /// As many bytes from there on as there are, at most so many; valid until the next call.
    std::string_view at(std::uint64_t offset, std::size_t size) {
        const std::uint64_t left = m_source.size() - std::min(offset, m_source.size());
        size = static_cast<std::size_t>(std::min<std::uint64_t>(size, left));
        if (offset < m_start || offset + size > m_start + m_bytes.size()) {
            const std::size_t wanted =
                static_cast<std::size_t>(std::min<std::uint64_t>(std::max(size, kWindow), left));
            m_start = offset;
            if (!m_source.read(offset, wanted, m_bytes))
                m_bytes.clear();
        }
        return std::string_view(m_bytes).substr(static_cast<std::size_t>(offset - m_start), size);
    }

private:
    ByteSource& m_source;
    std::uint64_t m_start = 0;
    std::string m_bytes;
};

/// The chunks that the summary lists; empty when there is no summary, or it does not hold.
ChunkIndexes readChunkIndexes(ByteSource& source, const ReaderLimits& limits) {
    constexpr std::size_t kEnd = kRecordHead + kFooterContent + kMagic.size();
    std::string end;
    if (source.size() < kMagic.size() + kEnd || !source.read(source.size() - kEnd, kEnd, end) ||
        !end.ends_with(kMagic))
        return {};
    FieldReader footer(end);
    const bool isFooter = footer.number<std::uint8_t>() == static_cast<std::uint8_t>(Opcode::footer) &&
                          footer.number<std::uint64_t>() == kFooterContent;
    const auto start = footer.number<std::uint64_t>();
    (void)footer.number<std::uint64_t>(); // start of the offsets of groups
    const auto crc = footer.number<std::uint32_t>();
    const std::uint64_t footerAt = source.size() - kEnd;
    if (!isFooter || start < kMagic.size() || start > footerAt || footerAt - start > limits.recordBytes)
        return {};
    std::string summary;
    constexpr std::size_t kBeforeCrc = kRecordHead + kFooterContent - sizeof(std::uint32_t);
    if (!source.read(start, static_cast<std::size_t>(footerAt - start) + kBeforeCrc, summary))
        return {};
    if (crc != 0 && crc32_z(0, reinterpret_cast<const Bytef*>(summary.data()), summary.size()) != crc)
        return {};
    ChunkIndexes chunks;
    FieldReader records(std::string_view(summary).substr(0, static_cast<std::size_t>(footerAt - start)));
    while (!records.rest().empty()) {
        const auto opcode = records.number<std::uint8_t>();
        FieldReader content(records.longBytes());
        if (records.failed())
            return {};
        if (opcode != static_cast<std::uint8_t>(Opcode::chunkIndex))
            continue;
        (void)content.number<std::uint64_t>();
        (void)content.number<std::uint64_t>();
        const auto offset = content.number<std::uint64_t>();
        IndexedChunk chunk;
        chunk.length = content.number<std::uint64_t>();
        (void)content.text(); // offsets of message indexes
        chunk.indexLength = content.number<std::uint64_t>();
        // An index that leads past the end is no index.
        if (content.failed() || offset > start || chunk.length > start - offset ||
            chunk.indexLength > start - offset - chunk.length || !chunks.emplace(offset, chunk).second)
            return {};
    }
    return chunks;
}

/// Goes through the records of a file.
class Walk {
public:
    Walk(ByteSource& source, const ReaderLimits& limits, const ChunkIndexes& index)
        : m_source(source)
        , m_limits(limits)
        , m_index(index)
        , m_window(source) {
        m_map.bytes = source.size();
        m_map.usesIndex = !index.empty();
    }

    FileMap run() {
        std::uint64_t at = kMagic.size();
        m_map.wholeBytes = at;
        while (!m_map.isComplete) {
            FieldReader head(m_window.at(at, kRecordHead));
            const auto opcode = static_cast<Opcode>(head.number<std::uint8_t>());
            const auto length = head.number<std::uint64_t>();
            const std::uint64_t content = at + kRecordHead;
            if (head.failed() || length > m_map.bytes - content)
                break;
            std::uint64_t next = content + length;
            if (opcode == Opcode::chunk) {
                if (const auto known = m_index.find(at); known != m_index.end()) {
                    ++m_known;
                    next = std::max(next, at + known->second.length + known->second.indexLength);
                }
            }
            if (!m_inSummary && opcode != Opcode::message)
                m_isRunOpen = false;
            take(opcode, at, content, length);
            at = next;
            m_map.wholeBytes = at;
        }
        if (m_map.isComplete)
            m_map.wholeBytes = m_map.bytes;
        if (m_map.dataEnd == 0)
            m_map.dataEnd = m_map.wholeBytes;
        return std::move(m_map);
    }

    /// Whether each chunk of the index was there.
    [[nodiscard]] bool foundAll() const { return m_known == m_index.size(); }

private:
    void take(Opcode opcode, std::uint64_t at, std::uint64_t content, std::uint64_t length) {
        switch (opcode) {
        case Opcode::schema:
            keep(readSchema(whole(content, length), m_map.schemas));
            break;
        case Opcode::channel:
            keep(readChannel(whole(content, length), m_map.channels));
            break;
        case Opcode::message:
            if (!m_inSummary)
                takeMessage(at, content, length);
            break;
        case Opcode::chunk:
            if (!m_inSummary)
                takeChunk(at, content, length);
            break;
        case Opcode::attachment:
            if (!m_inSummary)
                takeAttachment(at, content, length);
            break;
        case Opcode::metadata:
            if (!m_inSummary)
                takeMetadata(content, length);
            break;
        case Opcode::header:
            takeHeader(content, length);
            break;
        case Opcode::dataEnd:
            takeDataEnd(at, content, length);
            break;
        case Opcode::footer:
            m_map.isComplete = m_inSummary && m_window.at(content + length, kMagic.size()) == kMagic;
            break;
        default:
            break;
        }
    }

    void keep(bool isGood) { m_map.badRecords += isGood ? 0 : 1; }

    /// The first bytes of a content.
    std::string_view start(std::uint64_t content, std::uint64_t length, std::size_t size) {
        return m_window.at(content, static_cast<std::size_t>(std::min<std::uint64_t>(length, size)));
    }

    /// Empty when it is too long.
    std::string_view whole(std::uint64_t content, std::uint64_t length) {
        return length > m_limits.recordBytes ? std::string_view()
                                             : m_window.at(content, static_cast<std::size_t>(length));
    }

    void takeHeader(std::uint64_t content, std::uint64_t length) {
        FieldReader fields(whole(content, length));
        m_map.profile = fields.text();
        m_map.library = fields.text();
        keep(!fields.failed());
    }

    void takeMessage(std::uint64_t at, std::uint64_t content, std::uint64_t length) {
        FieldReader fields(start(content, length, kMessageHead));
        (void)fields.number<std::uint16_t>();
        (void)fields.number<std::uint32_t>();
        const auto log_ns = fields.number<std::uint64_t>();
        if (length < kMessageHead || length > m_limits.chunkBytes) {
            m_isRunOpen = false;
            keep(false);
            return;
        }
        const std::uint64_t bytes = kRecordHead + length;
        if (!m_isRunOpen || m_map.chunks.back().length + bytes > kRunBytes)
            m_map.chunks.push_back({log_ns, log_ns, at, 0, 0, true});
        m_isRunOpen = true;
        ChunkPlace& run = m_map.chunks.back();
        run.length += bytes;
        run.size = run.length;
        run.first_ns = std::min(run.first_ns, log_ns);
        run.last_ns = std::max(run.last_ns, log_ns);
    }

    void takeChunk(std::uint64_t at, std::uint64_t content, std::uint64_t length) {
        FieldReader fields(start(content, length, kChunkHead));
        ChunkPlace chunk{.offset = at, .length = kRecordHead + length};
        chunk.first_ns = fields.number<std::uint64_t>();
        chunk.last_ns = fields.number<std::uint64_t>();
        chunk.size = fields.number<std::uint64_t>();
        (void)fields.number<std::uint32_t>();
        const bool isKnown = compressionOf(fields.text()).has_value();
        if (fields.failed() || !isKnown || chunk.size > m_limits.chunkBytes || length > m_limits.chunkBytes)
            ++m_map.badChunks;
        else if (chunk.size > 0)
            m_map.chunks.push_back(chunk);
    }

    void takeAttachment(std::uint64_t at, std::uint64_t content, std::uint64_t length) {
        FieldReader fields(start(content, length, kWindow));
        AttachmentPlace place{.offset = at, .length = kRecordHead + length, .name = {}, .mediaType = {}};
        (void)fields.number<std::uint64_t>();
        (void)fields.number<std::uint64_t>();
        place.name = fields.text();
        place.mediaType = fields.text();
        place.size = fields.number<std::uint64_t>();
        keep(!fields.failed());
        if (!fields.failed())
            m_map.attachments.push_back(std::move(place));
    }

    void takeMetadata(std::uint64_t content, std::uint64_t length) {
        FieldReader fields(whole(content, length));
        Metadata metadata;
        metadata.name = fields.text();
        metadata.values = fields.map();
        keep(!fields.failed());
        if (!fields.failed())
            m_map.metadata.push_back(std::move(metadata));
    }

    void takeDataEnd(std::uint64_t at, std::uint64_t content, std::uint64_t length) {
        FieldReader fields(start(content, length, sizeof(std::uint32_t)));
        const auto crc = fields.number<std::uint32_t>();
        m_inSummary = true;
        m_map.dataEnd = at;
        if (!fields.failed() && crc != 0)
            m_map.dataCrc = crc;
    }

    ByteSource& m_source;
    const ReaderLimits& m_limits;
    const ChunkIndexes& m_index;
    Window m_window;
    FileMap m_map;
    std::size_t m_known = 0;
    bool m_inSummary = false;
    bool m_isRunOpen = false; ///< the last chunk is a run that goes on
};

} // namespace

bool readSchema(std::string_view content, std::map<std::uint16_t, Schema>& schemas) {
    FieldReader fields(content);
    Schema schema;
    schema.id = fields.number<std::uint16_t>();
    schema.name = fields.text();
    schema.encoding = fields.text();
    schema.text = fields.text();
    if (fields.failed() || schema.id == 0)
        return false;
    const std::uint16_t id = schema.id;
    schemas.try_emplace(id, std::move(schema));
    return true;
}

bool readChannel(std::string_view content, std::map<std::uint16_t, Channel>& channels) {
    FieldReader fields(content);
    Channel channel;
    channel.id = fields.number<std::uint16_t>();
    channel.schema = fields.number<std::uint16_t>();
    channel.topic = fields.text();
    channel.encoding = fields.text();
    channel.metadata = fields.map();
    if (fields.failed())
        return false;
    const std::uint16_t id = channel.id;
    channels.try_emplace(id, std::move(channel));
    return true;
}

core::Expected<FileMap> readFileMap(ByteSource& source, const std::string& name, const ReaderLimits& limits) {
    std::string magic;
    if (!source.read(0, kMagic.size(), magic) || magic != kMagic)
        return core::failed(core::ErrorKind::badInput, FileMapText::tr("this is not an MCAP file"),
                            FileMapText::tr("an MCAP file, version 0"), {name});
    const ChunkIndexes index = readChunkIndexes(source, limits);
    if (!index.empty()) {
        Walk walk(source, limits, index);
        FileMap map = walk.run();
        if (walk.foundAll())
            return map;
    }
    return Walk(source, limits, {}).run();
}

} // namespace teleta::mcap
