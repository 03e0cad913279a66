// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/mcap_reader.h"

#include "backend/core/failure.h"
#include "backend/mcap/byte_fields.h"
#include "backend/mcap/chunk_compression.h"

#include <QCoreApplication>

#include <algorithm>
#include <numeric>
#include <utility>
#include <zlib.h>

namespace teleta::mcap {

namespace {

struct McapReaderText {
    Q_DECLARE_TR_FUNCTIONS(McapFile)
};

constexpr std::size_t kMessageFields = 2 + 4 + 8 + 8;

bool hasCrc(std::string_view bytes, std::uint32_t crc) {
    return crc == 0 || crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == crc;
}

} // namespace

struct McapReader::OpenChunk {
    struct Place {
        std::uint64_t log_ns;
        std::size_t offset; ///< of the record's content
        std::size_t size;
    };
    std::string records;
    std::vector<Place> messages; ///< by time
    std::size_t at = 0;

    [[nodiscard]] std::uint64_t log_ns() const { return messages[at].log_ns; }
};

McapReader::~McapReader() = default;
McapReader::McapReader(McapReader&&) noexcept = default;
McapReader& McapReader::operator=(McapReader&&) noexcept = default;

core::Expected<McapReader> McapReader::open(std::unique_ptr<ByteSource> source, std::string name,
                                            const ReaderLimits& limits) {
    TELETA_TRY(auto map, readFileMap(*source, name, limits));
    McapReader reader(std::move(source), std::move(name), limits, std::move(map));
    if (reader.m_map.channels.empty())
        reader.findChannels();
    return reader;
}

McapReader::McapReader(std::unique_ptr<ByteSource> source, std::string name, const ReaderLimits& limits,
                       FileMap map)
    : m_source(std::move(source))
    , m_name(std::move(name))
    , m_limits(limits)
    , m_map(std::move(map))
    , m_order(m_map.chunks.size()) {
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    std::ranges::stable_sort(m_order, {}, [this](std::size_t chunk) { return m_map.chunks[chunk].first_ns; });
}

const Schema* McapReader::schemaOf(const Channel& channel) const {
    const auto found = m_map.schemas.find(channel.schema);
    return found == m_map.schemas.end() ? nullptr : &found->second;
}

/// A file without a summary names its channels within its chunks.
void McapReader::findChannels() {
    std::string records;
    for (const ChunkPlace& place : m_map.chunks) {
        if (place.isRun || !readRecords(place, records))
            continue;
        FieldReader fields(records);
        while (!fields.rest().empty() && !fields.failed()) {
            const auto opcode = static_cast<Opcode>(fields.number<std::uint8_t>());
            const std::string_view content = fields.longBytes();
            if (opcode == Opcode::schema)
                (void)readSchema(content, m_map.schemas);
            else if (opcode == Opcode::channel)
                (void)readChannel(content, m_map.channels);
        }
    }
}

bool McapReader::readRecords(const ChunkPlace& place, std::string& records) {
    if (place.length > m_limits.chunkBytes + m_limits.recordBytes)
        return false;
    std::string stored;
    if (!m_source->read(place.offset, static_cast<std::size_t>(place.length), stored))
        return false;
    if (place.isRun) {
        records = std::move(stored);
        return true;
    }
    FieldReader fields(std::string_view(stored).substr(kRecordHead));
    (void)fields.number<std::uint64_t>();
    (void)fields.number<std::uint64_t>();
    const auto size = fields.number<std::uint64_t>();
    const auto crc = fields.number<std::uint32_t>();
    const auto compression = compressionOf(fields.text());
    const std::string_view compressed = fields.longBytes();
    return !fields.failed() && compression && size <= m_limits.chunkBytes &&
           decompress(*compression, compressed, static_cast<std::size_t>(size), records) &&
           hasCrc(records, crc);
}

void McapReader::findMessages(OpenChunk& chunk, bool isRun) {
    FieldReader fields(chunk.records);
    while (!fields.rest().empty()) {
        const auto opcode = static_cast<Opcode>(fields.number<std::uint8_t>());
        const std::string_view content = fields.longBytes();
        if (fields.failed()) {
            ++m_damagedRecords;
            break;
        }
        bool isGood = true;
        if (opcode == Opcode::message) {
            FieldReader message(content);
            (void)message.number<std::uint16_t>();
            (void)message.number<std::uint32_t>();
            const auto log_ns = message.number<std::uint64_t>();
            isGood = content.size() >= kMessageFields;
            if (isGood)
                chunk.messages.push_back({log_ns,
                                          static_cast<std::size_t>(content.data() - chunk.records.data()),
                                          content.size()});
        } else if (opcode == Opcode::schema && !isRun) {
            isGood = readSchema(content, m_map.schemas);
        } else if (opcode == Opcode::channel && !isRun) {
            isGood = readChannel(content, m_map.channels);
        }
        m_damagedRecords += isGood ? 0 : 1;
    }
    if (!std::ranges::is_sorted(chunk.messages, {}, &OpenChunk::Place::log_ns))
        std::ranges::stable_sort(chunk.messages, {}, &OpenChunk::Place::log_ns);
}

std::unique_ptr<McapReader::OpenChunk> McapReader::load(const ChunkPlace& place) {
    auto chunk = std::make_unique<OpenChunk>();
    if (!readRecords(place, chunk->records)) {
        ++m_damagedChunks;
        return nullptr;
    }
    findMessages(*chunk, place.isRun);
    if (chunk->messages.empty())
        return nullptr;
    return chunk;
}

/// Opens the chunks that may have a message before those of the open ones.
void McapReader::openChunks() {
    while (m_nextChunk < m_order.size()) {
        const ChunkPlace& place = m_map.chunks[m_order[m_nextChunk]];
        const bool isLate =
            std::ranges::all_of(m_open, [&](const auto& chunk) { return place.first_ns > chunk->log_ns(); });
        if (!m_open.empty() && (isLate || m_openBytes + place.size > m_limits.openBytes))
            return;
        ++m_nextChunk;
        if (auto chunk = load(place)) {
            m_openBytes += chunk->records.size();
            m_open.push_back(std::move(chunk));
        }
    }
}

bool McapReader::next(Message& message) {
    // The records of the last message were needed until now.
    const auto read =
        std::ranges::find_if(m_open, [](const auto& chunk) { return chunk->at == chunk->messages.size(); });
    if (read != m_open.end()) {
        m_openBytes -= (*read)->records.size();
        m_open.erase(read);
    }
    openChunks();
    if (m_open.empty())
        return false;
    const auto first =
        std::ranges::min_element(m_open, {}, [](const auto& chunk) { return chunk->log_ns(); });
    OpenChunk& chunk = **first;
    const OpenChunk::Place& place = chunk.messages[chunk.at];
    FieldReader fields(std::string_view(chunk.records).substr(place.offset, place.size));
    message.channel = fields.number<std::uint16_t>();
    message.sequence = fields.number<std::uint32_t>();
    message.log_ns = fields.number<std::uint64_t>();
    message.publish_ns = fields.number<std::uint64_t>();
    message.data = fields.rest();
    ++chunk.at;
    return true;
}

core::Expected<Attachment> McapReader::attachment(const AttachmentPlace& place) {
    const auto damaged = [&] {
        return core::failed(
            core::ErrorKind::badInput,
            McapReaderText::tr("the attachment \"%1\" is damaged").arg(QString::fromStdString(place.name)),
            {}, {m_name});
    };
    std::string record;
    if (place.length > m_limits.recordBytes ||
        !m_source->read(place.offset, static_cast<std::size_t>(place.length), record))
        return damaged();
    const std::string_view content = std::string_view(record).substr(kRecordHead);
    FieldReader fields(content);
    Attachment attachment;
    attachment.log_ns = fields.number<std::uint64_t>();
    attachment.create_ns = fields.number<std::uint64_t>();
    attachment.name = fields.text();
    attachment.mediaType = fields.text();
    attachment.data = fields.longBytes();
    const std::size_t checked = content.size() - fields.rest().size();
    const auto crc = fields.number<std::uint32_t>();
    if (fields.failed() || !hasCrc(content.substr(0, checked), crc))
        return damaged();
    return attachment;
}

std::optional<bool> McapReader::checkDataSection(const std::function<bool()>& goOn) {
    if (!m_map.dataCrc)
        return std::nullopt;
    constexpr std::uint64_t kPiece = std::uint64_t{1} << 20U;
    std::string piece;
    uLong crc = 0;
    for (std::uint64_t at = 0; at < m_map.dataEnd; at += piece.size()) {
        if (goOn && !goOn())
            return std::nullopt;
        if (!m_source->read(at, static_cast<std::size_t>(std::min(kPiece, m_map.dataEnd - at)), piece))
            return false;
        crc = crc32_z(crc, reinterpret_cast<const Bytef*>(piece.data()), piece.size());
    }
    return crc == *m_map.dataCrc;
}

} // namespace teleta::mcap
