// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/mcap_export.h"

#include "backend/core/failure.h"
#include "backend/mcap/mcap_writer.h"
#include "backend/mcap/recorded/recording_notes.h"
#include "backend/mcap/recorded/ros_names.h"
#include "backend/mcap/recorded/stream_encoder.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace teleta::mcap {

namespace {

using recording::Recording;
using recording::RecordingEvent;
using recording::StreamReader;

struct McapExportText {
    Q_DECLARE_TR_FUNCTIONS(McapExport)
};

constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();
/// zstd and lz4 compress the pictures of a chunk; otherwise they are compressed one by one.
constexpr int kPictureStored = 0;
constexpr int kPictureFast = 1;

/// The streams that are asked for, in the recording's order.
core::Expected<std::vector<std::size_t>> chosenStreams(const Recording& recording,
                                                       const std::vector<std::string>& wanted) {
    const auto& streams = recording.streams();
    std::vector<std::size_t> chosen(streams.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    if (wanted.empty())
        return chosen;
    QStringList known;
    for (const recording::StreamInfo& stream : streams)
        known << QString::fromStdString(stream.name);
    for (const std::string& name : wanted) {
        if (!known.contains(QString::fromStdString(name)))
            return core::failed(
                core::ErrorKind::refused,
                McapExportText::tr("there is no stream \"%1\"").arg(QString::fromStdString(name)),
                McapExportText::tr("one of %1").arg(known.join(QStringLiteral(", "))), {recording.path()});
    }
    std::erase_if(chosen, [&](std::size_t number) {
        return std::ranges::find(wanted, streams[number].name) == wanted.end();
    });
    return chosen;
}

/// A stream on its way into the file.
class StreamExport {
public:
    StreamExport(const Recording& recording, std::size_t number, StreamEncoder encoder, McapWriter& writer)
        : m_reader(recording.reader(number))
        , m_encoder(std::move(encoder))
        , m_writer(writer) {
        for (const TopicType& topic : m_encoder.topics())
            m_channels.push_back(
                writer.addChannel(writer.addSchema(topic.schemaName, topic.schemaText), topic.topic));
    }

    /// Of the frame that is written next; kNever_ns after the last one.
    [[nodiscard]] std::int64_t time_ns() const { return m_block ? m_block->time_ns[m_frame] : kNever_ns; }
    [[nodiscard]] std::uint64_t damagedBlocks() const { return m_damaged; }
    [[nodiscard]] const std::vector<TopicType>& topics() const { return m_encoder.topics(); }
    [[nodiscard]] std::uint64_t messages() const { return m_messages; }

    /// Error: ioFailed.
    [[nodiscard]] core::Expected<void> nextBlock() {
        m_frame = 0;
        if (!m_block)
            m_block.emplace();
        for (;;) {
            const core::Expected<bool> any = m_reader.next(*m_block);
            if (any && *any)
                return {};
            if (!any && any.error().kind != core::ErrorKind::badInput)
                return core::Unexpected(any.error());
            m_damaged += any ? 0 : 1;
            // Where not even the index can be read the stream ends.
            if (any || !m_reader.canGoOn()) {
                m_block.reset();
                return {};
            }
        }
    }

    /// Writes the frames up to a time, at most the rest of the block; returns how many.
    std::size_t write(std::int64_t until_ns, std::int64_t offset_ns) {
        const std::size_t first = m_frame;
        while (m_frame < m_block->frames() && (m_frame == first || m_block->time_ns[m_frame] <= until_ns)) {
            const std::int64_t utc_ns = std::max<std::int64_t>(m_block->time_ns[m_frame] + offset_ns, 0);
            const std::size_t frames = m_encoder.framesOfMessage(*m_block, m_frame);
            for (std::size_t topic = 0; topic < m_channels.size(); ++topic) {
                m_writer.addMessage(m_channels[topic], static_cast<std::uint32_t>(m_messages),
                                    static_cast<std::uint64_t>(utc_ns), [&](std::string& bytes) {
                                        m_encoder.encode(topic, *m_block, m_frame, frames, utc_ns, bytes);
                                    });
            }
            ++m_messages;
            m_frame += frames;
        }
        return m_frame - first;
    }
    [[nodiscard]] bool needsBlock() const { return m_block && m_frame >= m_block->frames(); }

private:
    StreamReader m_reader;
    StreamEncoder m_encoder;
    McapWriter& m_writer;
    std::vector<std::uint16_t> m_channels;
    std::optional<core::TappedFrames> m_block; ///< empty after the last one
    std::size_t m_frame = 0;
    std::uint64_t m_damaged = 0;
    std::uint64_t m_messages = 0; ///< of each topic
};

/// Counts frames over the streams that are written.
double framesOf(const Recording& recording, const std::vector<std::size_t>& streams) {
    double frames = 0.0;
    for (const std::size_t number : streams) {
        if (const auto extent = recording.extent(number); extent && *extent)
            frames += static_cast<double>((*extent)->frames);
    }
    return frames;
}

class Export {
public:
    Export(const Recording& recording, McapWriter& writer, const McapExportOptions& options)
        : m_recording(recording)
        , m_writer(writer)
        , m_options(options)
        , m_offset_ns(utcOffset_ns(recording.anchors())) {}

    [[nodiscard]] core::Expected<McapExport> write(const std::vector<std::size_t>& chosen) {
        const std::vector<RosNames> names = rosNames(m_recording.streams());
        m_writer.add(recordingNote(m_recording, chosen));
        m_writer.add(streamsNote(m_recording, chosen, names));
        for (const Attachment& attachment : recordingAttachments(m_recording, chosen, names))
            m_writer.add(attachment);
        const int level = m_options.compression == Compression::none ? kPictureFast : kPictureStored;
        McapExport result;
        for (const std::size_t number : chosen) {
            StreamEncoder encoder(m_recording.streams()[number], names[number], level);
            if (encoder.topics().empty()) {
                result.leftOut.push_back(m_recording.streams()[number].name);
                continue;
            }
            if (names[number].turnsY)
                result.turned.push_back(m_recording.streams()[number].name);
            m_streams.push_back(
                std::make_unique<StreamExport>(m_recording, number, std::move(encoder), m_writer));
            TELETA_CHECK(m_streams.back()->nextBlock());
        }
        const TopicType events = eventTopic();
        m_eventChannel =
            m_writer.addChannel(m_writer.addSchema(events.schemaName, events.schemaText), events.topic);
        TELETA_CHECK(writeFrames(m_options.goOn ? framesOf(m_recording, chosen) : 0.0));
        for (const auto& stream : m_streams) {
            result.damagedBlocks += stream->damagedBlocks();
            for (const TopicType& topic : stream->topics())
                result.topics.push_back({topic.topic, topic.schemaName, stream->messages()});
        }
        result.topics.push_back({events.topic, events.schemaName, m_recording.events().size()});
        return result;
    }

private:
    [[nodiscard]] core::Expected<void> writeFrames(double all) {
        double done = 0.0;
        while (!m_writer.failed()) {
            // The stream that is next, and how long it stays so.
            StreamExport* next = nullptr;
            std::int64_t until_ns = kNever_ns;
            for (const auto& stream : m_streams) {
                if (next == nullptr || stream->time_ns() < next->time_ns()) {
                    until_ns = next == nullptr ? kNever_ns : next->time_ns();
                    next = stream.get();
                } else {
                    until_ns = std::min(until_ns, stream->time_ns());
                }
            }
            const std::int64_t time_ns = next == nullptr ? kNever_ns : next->time_ns();
            writeEvents(time_ns);
            if (time_ns == kNever_ns)
                return {};
            if (m_event < m_recording.events().size())
                until_ns = std::min(until_ns, m_recording.events()[m_event].time_ns - 1);
            done += static_cast<double>(next->write(until_ns, m_offset_ns));
            if (!next->needsBlock())
                continue;
            TELETA_CHECK(next->nextBlock());
            if (m_options.goOn && !m_options.goOn(done, all))
                return core::failed(core::ErrorKind::cancelled,
                                    McapExportText::tr("interrupted; nothing was written"), {},
                                    {m_recording.path()});
        }
        return m_writer.finish(); // says why it failed
    }

    void writeEvents(std::int64_t until_ns) {
        const std::vector<RecordingEvent>& events = m_recording.events();
        for (; m_event < events.size() && events[m_event].time_ns <= until_ns; ++m_event) {
            const std::int64_t utc_ns = std::max<std::int64_t>(events[m_event].time_ns + m_offset_ns, 0);
            m_writer.addMessage(m_eventChannel, static_cast<std::uint32_t>(m_event),
                                static_cast<std::uint64_t>(utc_ns),
                                [&](std::string& bytes) { encodeEvent(events[m_event], utc_ns, bytes); });
        }
    }

    const Recording& m_recording;
    McapWriter& m_writer;
    const McapExportOptions& m_options;
    std::int64_t m_offset_ns;
    std::vector<std::unique_ptr<StreamExport>> m_streams;
    std::uint16_t m_eventChannel = 0;
    std::size_t m_event = 0; ///< that is written next
};

} // namespace

core::Expected<McapExport> exportMcap(const Recording& recording, const std::string& path,
                                      const McapExportOptions& options) {
    if (!options.overwrite && QFileInfo::exists(QString::fromStdString(path)))
        return core::failed(core::ErrorKind::refused,
                            McapExportText::tr("a file of this name already exists"),
                            McapExportText::tr("another name"), {path});
    TELETA_TRY(const auto chosen, chosenStreams(recording, options.streams));
    WriterOptions writing;
    writing.library = "teleta " + QCoreApplication::applicationVersion().toStdString();
    writing.compression = options.compression;
    writing.chunkBytes = options.chunkBytes;
    TELETA_TRY(auto writer, McapWriter::create(path, std::move(writing)));
    TELETA_TRY(auto result, Export(recording, writer, options).write(chosen));
    TELETA_CHECK(writer.finish());
    result.path = path;
    result.bytes = writer.bytes();
    return result;
}

} // namespace teleta::mcap
