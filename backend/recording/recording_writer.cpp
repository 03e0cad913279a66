// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recording_writer.h"

#include "backend/core/steady_time.h"
#include "backend/recording/mark_changes.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace teleta::recording {

namespace {

static_assert(std::endian::native == std::endian::little, "blocks are written as they lie in memory");

constexpr std::size_t kFramesPerBlock = 512;
/// If the wall clock deviates this far from the steady clock, it was set.
constexpr std::int64_t kClockStep_ms = 50;
constexpr int kFastestDeflation = 1;

template <typename Value>
QByteArray bytesOf(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()),
            static_cast<qsizetype>(values.size() * sizeof(Value))};
}

QString textOf(const std::string& text) {
    // A null string would be NULL.
    return text.empty() ? QStringLiteral("") : QString::fromStdString(text);
}

double numberOf(double value) {
    // So would NaN.
    return std::isnan(value) ? 0.0 : value;
}

std::size_t bytesOf(const core::TappedFrames& frames) {
    return frames.values.size() + frames.frames() * (sizeof(std::int64_t) + sizeof(double)) +
           static_cast<std::size_t>(frames.image.width_px) * static_cast<std::size_t>(frames.image.height_px);
}

QString shapeText(const std::vector<std::size_t>& shape) {
    QStringList sides;
    for (const std::size_t side : shape)
        sides << QString::number(side);
    return sides.join(QLatin1Char('x'));
}

} // namespace

RecordingWriter::RecordingWriter(std::string path, std::function<QDateTime()> utcNow, bool simulatedTime)
    : m_database(std::move(path))
    , m_utcNow(std::move(utcNow))
    , m_simulatedTime(simulatedTime) {
}

RecordingWriter::RecordingWriter(std::string path, std::vector<TimeAnchor> anchors)
    : m_database(std::move(path))
    , m_given(std::move(anchors))
    , m_simulatedTime(true) {
}

core::Expected<void> RecordingWriter::begin(const RecordingHead& head) {
    m_start_ns = head.start_ns;
    m_newest_ns = head.start_ns;
    core::Expected<void> made = m_database.create();
    if (!made)
        return made;
    made = m_database
               .run(QStringLiteral("INSERT INTO recording VALUES (1, ?, ?, ?, ?, ?)"),
                    {textOf(head.appVersion), textOf(head.scene), textOf(head.sceneText),
                     textOf(head.configuration), static_cast<qlonglong>(head.start_ns)})
               .and_then([&](const QSqlQuery&) { return writeAnchor(); })
               .and_then([&]() -> core::Expected<void> {
                   TELETA_TRY(auto insert,
                              m_database.prepare(QStringLiteral(
                                  "INSERT INTO block (stream, first_ns, last_ns, frames, width, height, "
                                  "discontinuity, time_ns, source_time_s, data) "
                                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")));
                   m_insertBlock = std::move(insert);
                   return {};
               });
    if (!made)
        QFile::remove(QString::fromStdString(m_database.path()));
    return made;
}

core::Expected<void> RecordingWriter::addStream(const StreamInfo& info) {
    long long key = 0;
    const auto insert = [&]() -> core::Expected<void> {
        TELETA_TRY(
            auto made,
            m_database.run(
                QStringLiteral("INSERT INTO stream (name, kind, type, source, shape, unit, rate_hz, details) "
                               "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
                {textOf(info.name), QString::fromLatin1(toString(info.kind)),
                 QString::fromLatin1(toString(info.type)), textOf(info.source), shapeText(info.shape),
                 textOf(info.unit), numberOf(info.nominalRate_Hz), textOf(info.details)}));
        key = made.lastInsertId().toLongLong();
        for (std::size_t i = 0; i < info.columns.size(); ++i) {
            TELETA_CHECK(m_database.run(QStringLiteral("INSERT INTO stream_column VALUES (?, ?, ?, ?)"),
                                        {key, static_cast<qlonglong>(i), textOf(info.columns[i].name),
                                         textOf(info.columns[i].unit)}));
        }
        return {};
    };
    TELETA_CHECK(m_database.inTransaction(insert));
    m_streams.push_back({.info = info, .key = key, .blocks = {}, .newest_ns = {}});
    return {};
}

void RecordingWriter::take(std::size_t index, core::TappedFrames&& frames) {
    Stream& stream = m_streams[index];
    const bool isPicture = stream.info.type == ValueType::grey8;
    const bool hasShape =
        isPicture ? !frames.image.isEmpty() && frames.frames() == 1
                  : frames.frames() > 0 && frames.values.size() == frames.frames() * stream.info.channels() *
                                                                       stream.info.bytesPerValue();
    // What does not fit would be damage.
    if (!hasShape || frames.sourceTime_s.size() != frames.frames() || !frames.hasTimesInOrder()) {
        stream.refused += frames.frames();
        return;
    }
    if (stream.newest_ns && frames.time_ns.front() < *stream.newest_ns)
        frames.discontinuity = true;
    stream.newest_ns = frames.time_ns.back();
    m_newest_ns = std::max(m_newest_ns, frames.time_ns.back());
    m_waitingBytes += bytesOf(frames);
    const bool joins = !isPicture && !frames.discontinuity && !stream.blocks.empty() &&
                       stream.blocks.back().frames() + frames.frames() <= kFramesPerBlock;
    if (!joins) {
        stream.blocks.push_back(std::move(frames));
        return;
    }
    core::TappedFrames& block = stream.blocks.back();
    block.time_ns.insert(block.time_ns.end(), frames.time_ns.begin(), frames.time_ns.end());
    block.sourceTime_s.insert(block.sourceTime_s.end(), frames.sourceTime_s.begin(),
                              frames.sourceTime_s.end());
    block.values.insert(block.values.end(), frames.values.begin(), frames.values.end());
}

void RecordingWriter::setDropped(std::size_t index, std::uint64_t frames) {
    Stream& stream = m_streams[index];
    const std::uint64_t all = frames + stream.refused;
    if (all == stream.dropped)
        return;
    take({.time_ns = m_simulatedTime ? m_newest_ns : core::steadyNow_ns(),
          .kind = kDropped,
          .text = stream.info.name,
          .value = static_cast<double>(all - stream.dropped)});
    stream.dropped = all;
}

std::uint64_t RecordingWriter::dropped() const {
    return std::accumulate(m_streams.begin(), m_streams.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Stream& stream) { return sum + stream.dropped; });
}

void RecordingWriter::take(RecordingEvent event) {
    m_events.push_back(std::move(event));
}

void RecordingWriter::take(MarkChange change) {
    m_markChanges.push_back(std::move(change));
}

core::Expected<void> RecordingWriter::commit() {
    TELETA_CHECK(m_database.inTransaction([&] { return writeAll(); }));
    for (Stream& stream : m_streams) {
        for (const core::TappedFrames& block : stream.blocks)
            m_frames += block.frames();
        stream.blocks.clear();
    }
    for (const RecordingEvent& event : m_events)
        m_marks += event.kind == kMark ? 1 : 0;
    m_events.clear();
    m_waitingBytes = 0;
    for (const MarkChange& change : m_markChanges) {
        if (change.restored_ns)
            ++m_marks;
        else if (!change.note)
            --m_marks;
    }
    m_markChanges.clear();
    return {};
}

core::Expected<void> RecordingWriter::writeAll() {
    TELETA_CHECK(writeAnchor());
    for (const Stream& stream : m_streams) {
        for (const core::TappedFrames& block : stream.blocks) {
            TELETA_CHECK(writeBlock(stream, block));
        }
    }
    for (const RecordingEvent& event : m_events) {
        TELETA_CHECK(m_database.run(
            QStringLiteral("INSERT INTO event (time_ns, kind, text, value) VALUES (?, ?, ?, ?)"),
            {static_cast<qlonglong>(event.time_ns), textOf(event.kind), textOf(event.text),
             numberOf(event.value)}));
    }
    // After the marks themselves.
    return writeMarkChanges(m_database, m_markChanges);
}

core::Expected<void> RecordingWriter::writeBlock(const Stream& stream, const core::TappedFrames& block) {
    QSqlQuery& query = *m_insertBlock;
    const core::GreyImage& image = block.image;
    const QByteArray data =
        image.isEmpty()
            ? bytesOf(block.values)
            // qCompress puts the length before the deflated bytes.
            : qCompress(image.pixels.get(), static_cast<qsizetype>(image.width_px) * image.height_px,
                        kFastestDeflation)
                  .mid(4);
    const QVariantList values{stream.key,
                              static_cast<qlonglong>(block.time_ns.front()),
                              static_cast<qlonglong>(block.time_ns.back()),
                              static_cast<qlonglong>(block.frames()),
                              image.width_px,
                              image.height_px,
                              block.discontinuity ? 1 : 0,
                              bytesOf(block.time_ns),
                              bytesOf(block.sourceTime_s),
                              data};
    for (int i = 0; i < static_cast<int>(values.size()); ++i)
        query.bindValue(i, values[i]);
    return m_database.execute(query);
}

core::Expected<void> RecordingWriter::writeAnchor() {
    // A simulation runs as fast as it can: only its start is a time of the wall clock.
    if (m_anchor && m_simulatedTime)
        return {};
    if (!m_given.empty()) {
        for (const TimeAnchor& anchor : m_given) {
            TELETA_CHECK(insertAnchor(anchor));
        }
        m_anchor = m_given.back();
        return {};
    }
    if (!m_utcNow)
        return {};
    const TimeAnchor now{m_simulatedTime ? m_start_ns : core::steadyNow_ns(), m_utcNow().toUTC()};
    if (m_anchor) {
        const std::int64_t expected_ms = (now.time_ns - m_anchor->time_ns) / 1'000'000;
        if (std::abs(m_anchor->utc.msecsTo(now.utc) - expected_ms) < kClockStep_ms)
            return {};
    }
    TELETA_CHECK(insertAnchor(now));
    m_anchor = now;
    return {};
}

core::Expected<void> RecordingWriter::insertAnchor(const TimeAnchor& anchor) {
    TELETA_CHECK(
        m_database.run(QStringLiteral("INSERT INTO anchor VALUES (?, ?)"),
                       {static_cast<qlonglong>(anchor.time_ns), anchor.utc.toString(Qt::ISODateWithMs)}));
    return {};
}

core::Expected<void> RecordingWriter::finish() {
    m_insertBlock.reset();
    return m_database.finish();
}

std::uint64_t RecordingWriter::bytes() const {
    const QString path = QString::fromStdString(m_database.path());
    return static_cast<std::uint64_t>(QFileInfo(path).size() +
                                      QFileInfo(path + QStringLiteral("-wal")).size());
}

} // namespace teleta::recording
