// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/mcap_writer.h"

#include <algorithm>
#include <zlib.h>

namespace teleta::mcap {

namespace {

std::uint32_t crcOf(std::string_view bytes, std::uint32_t before = 0) {
    return static_cast<std::uint32_t>(
        crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

} // namespace

core::Expected<McapWriter> McapWriter::create(const std::string& path, WriterOptions options) {
    TELETA_TRY(auto file, core::OutputFile::create(path));
    return McapWriter(std::move(file), std::move(options));
}

McapWriter::McapWriter(core::OutputFile file, WriterOptions options)
    : m_file(std::move(file))
    , m_options(std::move(options))
    , m_compressor(m_options.compression) {
    std::string head(kMagic);
    appendRecord(head, Opcode::header, [&] {
        appendText(head, m_options.profile);
        appendText(head, m_options.library);
    });
    write(head);
}

void McapWriter::write(std::string_view bytes) {
    m_file.write(bytes);
    m_crc = crcOf(bytes, m_crc);
    m_size += bytes.size();
}

std::uint16_t McapWriter::addSchema(const std::string& name, const std::string& text) {
    const auto [known, isNew] =
        m_schemaIds.try_emplace({name, text}, static_cast<std::uint16_t>(m_schemas.size() + 1));
    const std::uint16_t id = known->second;
    if (!isNew)
        return id;
    if (!m_places.empty())
        closeChunk();
    std::string& record = m_schemas.emplace_back();
    appendRecord(record, Opcode::schema, [&] {
        appendNumber(record, id);
        appendText(record, name);
        appendText(record, "ros2msg");
        appendText(record, text);
    });
    m_chunk += record;
    return id;
}

std::uint16_t McapWriter::addChannel(std::uint16_t schema, const std::string& topic) {
    if (!m_places.empty())
        closeChunk();
    const auto id = static_cast<std::uint16_t>(m_channels.size());
    std::string& record = m_channels.emplace_back();
    appendRecord(record, Opcode::channel, [&] {
        appendNumber(record, id);
        appendNumber(record, schema);
        appendText(record, topic);
        appendText(record, "cdr");
        appendMap(record, {{"offered_qos_profiles", ""}});
    });
    m_counts.push_back(0);
    m_chunk += record;
    return id;
}

void McapWriter::keepPlace(std::uint16_t channel, std::uint64_t log_ns, std::size_t start) {
    m_places.push_back({log_ns, start, m_chunk.size() - start, channel});
    m_first_ns = m_messages == 0 ? log_ns : std::min(m_first_ns, log_ns);
    m_last_ns = std::max(m_last_ns, log_ns);
    ++m_messages;
    ++m_counts[channel];
    if (m_chunk.size() >= m_options.chunkBytes)
        closeChunk();
}

void McapWriter::putInOrder() {
    if (std::ranges::is_sorted(m_places, {}, &Place::log_ns))
        return;
    m_scratch.assign(m_chunk, 0, m_places.front().offset);
    std::ranges::stable_sort(m_places, {}, &Place::log_ns);
    for (Place& place : m_places) {
        const std::size_t offset = m_scratch.size();
        m_scratch.append(m_chunk, place.offset, place.size);
        place.offset = offset;
    }
    m_chunk.swap(m_scratch);
}

void McapWriter::closeChunk() {
    if (m_chunk.empty())
        return;
    if (!m_places.empty())
        putInOrder();
    const std::uint64_t first_ns = m_places.empty() ? 0 : m_places.front().log_ns;
    const std::uint64_t last_ns = m_places.empty() ? 0 : m_places.back().log_ns;
    const std::uint64_t size = m_chunk.size();
    const std::string_view word = toString(m_compressor.compression());
    const std::string_view stored = m_compressor.compress(m_chunk);
    const std::uint64_t offset = m_size;

    std::string head;
    appendRecord(head, Opcode::chunk, [&] {
        appendNumber(head, first_ns);
        appendNumber(head, last_ns);
        appendNumber(head, size);
        appendNumber(head, crcOf(m_chunk));
        appendText(head, word);
        appendNumber(head, static_cast<std::uint64_t>(stored.size()));
    });
    // The stored bytes belong to the record as well.
    putNumber(head, 1, static_cast<std::uint64_t>(head.size() - kRecordHead + stored.size()));
    write(head);
    write(stored);
    const std::uint64_t length = m_size - offset;

    std::map<std::uint16_t, std::vector<const Place*>> byChannel;
    for (const Place& place : m_places)
        byChannel[place.channel].push_back(&place);
    std::string indexes;
    std::map<std::uint16_t, std::uint64_t> offsets;
    for (const auto& [channel, places] : byChannel) {
        offsets[channel] = m_size + indexes.size();
        appendRecord(indexes, Opcode::messageIndex, [&, channel = channel, &places = places] {
            appendNumber(indexes, channel);
            appendNumber(indexes, static_cast<std::uint32_t>(places.size() * 2 * sizeof(std::uint64_t)));
            for (const Place* place : places) {
                appendNumber(indexes, place->log_ns);
                appendNumber(indexes, static_cast<std::uint64_t>(place->offset));
            }
        });
    }
    write(indexes);

    appendRecord(m_chunkIndexes, Opcode::chunkIndex, [&] {
        appendNumber(m_chunkIndexes, first_ns);
        appendNumber(m_chunkIndexes, last_ns);
        appendNumber(m_chunkIndexes, offset);
        appendNumber(m_chunkIndexes, length);
        appendNumber(m_chunkIndexes, static_cast<std::uint32_t>(
                                         offsets.size() * (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
        for (const auto& [channel, at] : offsets) {
            appendNumber(m_chunkIndexes, channel);
            appendNumber(m_chunkIndexes, at);
        }
        appendNumber(m_chunkIndexes, static_cast<std::uint64_t>(indexes.size()));
        appendText(m_chunkIndexes, word);
        appendNumber(m_chunkIndexes, static_cast<std::uint64_t>(stored.size()));
        appendNumber(m_chunkIndexes, size);
    });
    ++m_chunks;
    m_chunk.clear();
    m_places.clear();
}

void McapWriter::add(const Attachment& attachment) {
    closeChunk();
    const std::uint64_t offset = m_size;
    std::string record;
    appendRecord(record, Opcode::attachment, [&] {
        appendNumber(record, attachment.log_ns);
        appendNumber(record, attachment.create_ns);
        appendText(record, attachment.name);
        appendText(record, attachment.mediaType);
        appendNumber(record, static_cast<std::uint64_t>(attachment.data.size()));
        record.append(attachment.data);
        appendNumber(record, crcOf(std::string_view(record).substr(kRecordHead)));
    });
    write(record);
    appendRecord(m_attachmentIndexes, Opcode::attachmentIndex, [&] {
        appendNumber(m_attachmentIndexes, offset);
        appendNumber(m_attachmentIndexes, static_cast<std::uint64_t>(record.size()));
        appendNumber(m_attachmentIndexes, attachment.log_ns);
        appendNumber(m_attachmentIndexes, attachment.create_ns);
        appendNumber(m_attachmentIndexes, static_cast<std::uint64_t>(attachment.data.size()));
        appendText(m_attachmentIndexes, attachment.name);
        appendText(m_attachmentIndexes, attachment.mediaType);
    });
    ++m_attachments;
}

void McapWriter::add(const Metadata& metadata) {
    closeChunk();
    const std::uint64_t offset = m_size;
    std::string record;
    appendRecord(record, Opcode::metadata, [&] {
        appendText(record, metadata.name);
        appendMap(record, metadata.values);
    });
    write(record);
    appendRecord(m_metadataIndexes, Opcode::metadataIndex, [&] {
        appendNumber(m_metadataIndexes, offset);
        appendNumber(m_metadataIndexes, static_cast<std::uint64_t>(record.size()));
        appendText(m_metadataIndexes, metadata.name);
    });
    ++m_metadata;
}

void McapWriter::closeGroup(Opcode opcode, const std::string& summary, std::size_t start,
                            std::string& offsets) const {
    if (summary.size() == start)
        return;
    appendRecord(offsets, Opcode::summaryOffset, [&] {
        appendNumber(offsets, static_cast<std::uint8_t>(opcode));
        appendNumber(offsets, m_size + start);
        appendNumber(offsets, static_cast<std::uint64_t>(summary.size() - start));
    });
}

void McapWriter::appendStatistics(std::string& summary) const {
    appendRecord(summary, Opcode::statistics, [&] {
        appendNumber(summary, m_messages);
        appendNumber(summary, static_cast<std::uint16_t>(m_schemas.size()));
        appendNumber(summary, static_cast<std::uint32_t>(m_channels.size()));
        appendNumber(summary, m_attachments);
        appendNumber(summary, m_metadata);
        appendNumber(summary, m_chunks);
        appendNumber(summary, m_first_ns);
        appendNumber(summary, m_last_ns);
        appendNumber(summary, static_cast<std::uint32_t>(m_counts.size() *
                                                         (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
        for (std::size_t channel = 0; channel < m_counts.size(); ++channel) {
            appendNumber(summary, static_cast<std::uint16_t>(channel));
            appendNumber(summary, m_counts[channel]);
        }
    });
}

core::Expected<void> McapWriter::finish() {
    closeChunk();
    std::string dataEnd;
    appendRecord(dataEnd, Opcode::dataEnd, [&] { appendNumber(dataEnd, m_crc); });
    write(dataEnd);

    std::string summary;
    std::string offsets;
    const auto group = [&](Opcode opcode, const auto& fill) {
        const std::size_t start = summary.size();
        fill();
        closeGroup(opcode, summary, start, offsets);
    };
    group(Opcode::schema, [&] {
        for (const std::string& record : m_schemas)
            summary += record;
    });
    group(Opcode::channel, [&] {
        for (const std::string& record : m_channels)
            summary += record;
    });
    group(Opcode::statistics, [&] { appendStatistics(summary); });
    group(Opcode::chunkIndex, [&] { summary += m_chunkIndexes; });
    group(Opcode::attachmentIndex, [&] { summary += m_attachmentIndexes; });
    group(Opcode::metadataIndex, [&] { summary += m_metadataIndexes; });

    const std::uint64_t summaryStart = m_size;
    const std::uint64_t offsetStart = m_size + summary.size();
    summary += offsets;
    appendRecord(summary, Opcode::footer, [&] {
        appendNumber(summary, summaryStart);
        appendNumber(summary, offsetStart);
        appendNumber(summary, std::uint32_t{0});
    });
    // Up to itself; the length of the footer is known by now.
    const std::size_t crcAt = summary.size() - sizeof(std::uint32_t);
    putNumber(summary, crcAt, crcOf(std::string_view(summary).substr(0, crcAt)));
    summary += kMagic;
    write(summary);
    return m_file.finish();
}

} // namespace teleta::mcap
