// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recording.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/recording/recording_database.h"

#include <QCoreApplication>
#include <QFile>
#include <QSqlError>
#include <QtEndian>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace teleta::recording {

namespace {

struct ReadingText {
    Q_DECLARE_TR_FUNCTIONS(Recording)
};

constexpr std::size_t kMostValues = 1U << 24U;
constexpr int kMostPixels = 1 << 26;

constexpr char kBlock[] = "key, first_ns, frames, width, height, discontinuity, time_ns, source_time_s, data";
constexpr char kForwards[] = "> (?, ?) ORDER BY first_ns, key";
constexpr char kBackwards[] = "< (?, ?) ORDER BY first_ns DESC, key DESC";

/// Where the block of a row is, whose first columns are those of kBlock.
template <typename Position>
Position placeOf(const QSqlQuery& row) {
    return {row.value(1).toLongLong(), row.value(0).toLongLong()};
}

std::optional<std::vector<std::size_t>> shapeOf(const QString& text) {
    std::vector<std::size_t> shape;
    std::size_t values = 1;
    for (const QString& side : text.split(QLatin1Char('x'))) {
        bool isNumber = false;
        const qulonglong size = side.toULongLong(&isNumber);
        if (!isNumber || size > kMostValues || values * std::max<std::size_t>(size, 1) > kMostValues)
            return std::nullopt;
        values *= std::max<std::size_t>(size, 1);
        shape.push_back(size);
    }
    return shape;
}

template <typename Value>
bool copyBytes(const QByteArray& bytes, std::size_t entries, std::vector<Value>& values) {
    if (static_cast<std::size_t>(bytes.size()) != entries * sizeof(Value))
        return false;
    values.resize(entries);
    std::memcpy(values.data(), bytes.constData(), static_cast<std::size_t>(bytes.size()));
    return true;
}

std::optional<core::GreyImage> imageOf(const QByteArray& deflated, int width_px, int height_px) {
    if (width_px < 1 || height_px < 1 || width_px > kMostPixels / height_px)
        return std::nullopt;
    const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
    QByteArray withLength(4, Qt::Uninitialized);
    qToBigEndian(static_cast<quint32>(pixels), withLength.data());
    const QByteArray inflated = qUncompress(withLength + deflated);
    if (static_cast<std::size_t>(inflated.size()) != pixels)
        return std::nullopt;
    std::shared_ptr<std::uint8_t[]> copy(new std::uint8_t[pixels]);
    std::memcpy(copy.get(), inflated.constData(), pixels);
    return core::GreyImage{std::shared_ptr<const std::uint8_t>(copy, copy.get()), width_px, height_px};
}

} // namespace

StreamReader::StreamReader(std::shared_ptr<RecordingDatabase> database, StreamInfo info, long long key)
    : m_database(std::move(database))
    , m_info(std::move(info))
    , m_key(key) {
}

core::Expected<QSqlQuery> StreamReader::select(const char* columns, const char* rule,
                                               const Position& from) const {
    return m_database->run(QStringLiteral("SELECT %1 FROM block WHERE stream = ? AND (first_ns, key) %2")
                               .arg(QLatin1String(columns), QLatin1String(rule)),
                           {m_key, from.first_ns, from.key});
}

std::optional<StreamReader::Position> StreamReader::place(const char* rule, const Position& from) const {
    auto query = select("key, first_ns", rule, from);
    if (!query || !query->next())
        return std::nullopt;
    return placeOf<Position>(*query);
}

/// An unreadable page costs only its block, which the index names. If the index cannot be read either, or the
/// file is gone, the stream ends.
core::Unexpected StreamReader::passOver(core::Unexpected error) {
    m_query.reset();
    m_canGoOn = false;
    if (error.value().kind == core::ErrorKind::badInput) {
        const std::optional<Position> lost = place(kForwards, m_after);
        // Even a damaged index must lead forwards.
        if (lost && *lost > m_after) {
            m_after = *lost;
            m_canGoOn = true;
        }
    }
    return error;
}

/// False when the block is incomplete.
bool StreamReader::readRow(const QSqlQuery& query, core::TappedFrames& block) {
    const auto frames = query.value(2).toLongLong();
    if (frames < 1 || frames >= static_cast<long long>(kMostValues))
        return false;
    const auto count = static_cast<std::size_t>(frames);
    const QByteArray data = query.value(8).toByteArray();
    core::TappedFrames read;
    read.discontinuity = query.value(5).toInt() != 0;
    if (!copyBytes(query.value(6).toByteArray(), count, read.time_ns) ||
        !copyBytes(query.value(7).toByteArray(), count, read.sourceTime_s) || !read.hasTimesInOrder())
        return false;
    if (m_info.type == ValueType::grey8) {
        auto image = imageOf(data, query.value(3).toInt(), query.value(4).toInt());
        if (!image || count != 1)
            return false;
        read.image = std::move(*image);
    } else if (!copyBytes(data, count * m_info.channels() * m_info.bytesPerValue(), read.values)) {
        return false;
    }
    block = std::move(read);
    m_at = placeOf<Position>(query);
    return true;
}

core::Expected<bool> StreamReader::next(core::TappedFrames& block) {
    m_canGoOn = true;
    if (m_query == nullptr) {
        auto query = m_database->prepare(
            QStringLiteral("SELECT %1 FROM block WHERE stream = ? AND (first_ns, key) %2 LIMIT 1")
                .arg(QLatin1String(kBlock), QLatin1String(kForwards)));
        if (!query)
            return passOver(core::Unexpected(query.error()));
        m_query = std::make_shared<QSqlQuery>(std::move(*query));
    }
    for (const qlonglong value : {static_cast<qlonglong>(m_key), m_after.first_ns, m_after.key})
        m_query->addBindValue(value);
    if (const auto done = m_database->execute(*m_query); !done)
        return passOver(core::Unexpected(done.error()));
    if (!m_query->next()) {
        if (m_query->lastError().isValid())
            return passOver(m_database->failed(m_query->lastError()));
        m_query->finish();
        return false;
    }
    const QString key = m_query->value(0).toString();
    const Position at = placeOf<Position>(*m_query);
    // Even a damaged index must lead forwards.
    m_canGoOn = at > m_after;
    m_after = std::max(m_after, at);
    const bool isWhole = m_canGoOn && readRow(*m_query, block);
    // A statement that stays open would keep others from changing marks.
    m_query->finish();
    if (!isWhole)
        return m_database->damaged(ReadingText::tr("block %1 of the stream \"%2\" is incomplete")
                                       .arg(key, QString::fromStdString(m_info.name)));
    return true;
}

core::Expected<bool> StreamReader::previous(core::TappedFrames& block) {
    for (Position before = m_at;;) {
        auto query = select(kBlock, kBackwards, before);
        core::Expected<void> read;
        if (!query)
            read = core::Unexpected(query.error());
        while (query && query->next()) {
            if (readRow(*query, block)) {
                m_after = m_at;
                m_query.reset();
                return true;
            }
            before = std::min(before, placeOf<Position>(*query));
        }
        if (query && query->lastError().isValid())
            read = m_database->failed(query->lastError());
        if (read)
            return false;
        // As passOver(), backwards.
        const std::optional<Position> lost =
            read.error().kind == core::ErrorKind::badInput ? place(kBackwards, before) : std::nullopt;
        if (!lost || *lost >= before)
            return core::Unexpected(read.error());
        before = *lost;
    }
}

core::Expected<void> StreamReader::seek(std::int64_t time_ns) {
    TELETA_TRY(auto query,
               m_database->run(QStringLiteral("SELECT first_ns FROM block WHERE stream = ? AND first_ns <= ? "
                                              "ORDER BY first_ns DESC LIMIT 1"),
                               {m_key, static_cast<qlonglong>(time_ns)}));
    m_after = {};
    if (query.next())
        m_after = {query.value(0).toLongLong(), std::numeric_limits<qlonglong>::min()};
    else if (query.lastError().isValid())
        return m_database->failed(query.lastError());
    m_at = m_after;
    m_query.reset();
    return {};
}

Recording::Recording(std::shared_ptr<RecordingDatabase> database)
    : m_database(std::move(database)) {
}

bool Recording::looksLikeOne(const std::string& path) {
    if (RecordingDatabase::isWrittenHere(path))
        return true;
    QFile file(QString::fromStdString(path));
    return core::requireFile(path) && file.open(QIODevice::ReadOnly) &&
           RecordingDatabase::beginsLikeOne(file);
}

core::Expected<Recording> Recording::open(const std::string& path) {
    Recording recording(std::make_shared<RecordingDatabase>(path));
    TELETA_CHECK(recording.m_database->openForReading()
                     .and_then([&] { return recording.readHead(); })
                     .and_then([&] { return recording.readAnchors(); })
                     .and_then([&] { return recording.readStreams(); })
                     .and_then([&] { return recording.readColumns(); })
                     .and_then([&] { return recording.readEvents(); }));
    return recording;
}

const std::string& Recording::path() const {
    return m_database->path();
}

template <typename Row>
core::Expected<void> Recording::forEachRow(QSqlQuery& query, const Row& row) const {
    while (query.next()) {
        TELETA_CHECK(row());
    }
    // The end of the table and an unreadable page look alike.
    if (query.lastError().isValid())
        return m_database->failed(query.lastError());
    return {};
}

core::Expected<void> Recording::readHead() {
    TELETA_TRY(auto query,
               m_database->run(QStringLiteral(
                   "SELECT app_version, scene, scene_text, configuration, start_ns FROM recording")));
    if (!query.next() && query.lastError().isValid())
        return m_database->failed(query.lastError());
    if (!query.isValid())
        return core::failed(core::ErrorKind::badInput, ReadingText::tr("the recording was never started"), {},
                            {path()});
    const auto text = [&](int column) { return query.value(column).toString().toStdString(); };
    m_head = {text(0), text(1), text(2), text(3), query.value(4).toLongLong()};
    return {};
}

core::Expected<void> Recording::readAnchors() {
    TELETA_TRY(auto query,
               m_database->run(QStringLiteral("SELECT time_ns, utc FROM anchor ORDER BY time_ns, rowid")));
    return forEachRow(query, [&]() -> core::Expected<void> {
        m_anchors.push_back({query.value(0).toLongLong(),
                             QDateTime::fromString(query.value(1).toString(), Qt::ISODateWithMs)});
        if (!m_anchors.back().utc.isValid())
            return m_database->damaged(
                ReadingText::tr("\"%1\" is not a time").arg(query.value(1).toString()));
        return {};
    });
}

core::Expected<void> Recording::readStreams() {
    TELETA_TRY(
        auto query,
        m_database->run(QStringLiteral(
            "SELECT key, name, kind, type, source, shape, unit, rate_hz, details FROM stream ORDER BY key")));
    return forEachRow(query, [&]() -> core::Expected<void> {
        const auto text = [&](int column) { return query.value(column).toString(); };
        const auto kind = streamKindOf(text(2).toStdString());
        const auto type = valueTypeOf(text(3).toStdString());
        const auto shape = shapeOf(text(5));
        if (!kind || !type || !shape)
            return m_database->damaged(
                ReadingText::tr("the stream \"%1\" is described by \"%2\"")
                    .arg(text(1), QStringList{text(2), text(3), text(5)}.join(QLatin1Char(' '))));
        m_keys.push_back(query.value(0).toLongLong());
        m_streams.push_back({.name = text(1).toStdString(),
                             .kind = *kind,
                             .type = *type,
                             .source = text(4).toStdString(),
                             .shape = *shape,
                             .unit = text(6).toStdString(),
                             .columns = {},
                             .nominalRate_Hz = query.value(7).toDouble(),
                             .details = text(8).toStdString()});
        return {};
    });
}

core::Expected<void> Recording::readColumns() {
    TELETA_TRY(auto query, m_database->run(QStringLiteral(
                               "SELECT stream, name, unit FROM stream_column ORDER BY stream, number")));
    const core::Expected<void> read = forEachRow(query, [&]() -> core::Expected<void> {
        const auto key = std::ranges::find(m_keys, query.value(0).toLongLong());
        if (key != m_keys.end())
            m_streams[static_cast<std::size_t>(key - m_keys.begin())].columns.push_back(
                {query.value(1).toString().toStdString(), query.value(2).toString().toStdString()});
        return {};
    });
    if (!read)
        return read;
    for (const StreamInfo& stream : m_streams) {
        if (!stream.columns.empty() && stream.columns.size() != stream.channels())
            return m_database->damaged(ReadingText::tr("the stream \"%1\" has %2 columns instead of %3")
                                           .arg(QString::fromStdString(stream.name))
                                           .arg(stream.columns.size())
                                           .arg(stream.channels()));
    }
    return {};
}

core::Expected<void> Recording::readEvents() {
    TELETA_TRY(auto query, m_database->run(QStringLiteral(
                               "SELECT time_ns, kind, text, value FROM event ORDER BY time_ns, key")));
    return forEachRow(query, [&]() -> core::Expected<void> {
        m_events.push_back({query.value(0).toLongLong(), query.value(1).toString().toStdString(),
                            query.value(2).toString().toStdString(), query.value(3).toDouble()});
        return {};
    });
}

bool Recording::isComplete() const {
    return std::ranges::any_of(m_events, [](const RecordingEvent& event) { return event.kind == kStopped; });
}

std::optional<std::size_t> Recording::first(StreamKind kind) const {
    const auto found = std::ranges::find(m_streams, kind, &StreamInfo::kind);
    return found == m_streams.end() ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(found - m_streams.begin()));
}

core::Expected<std::optional<Recording::Extent>> Recording::extent(std::size_t stream) const {
    auto query = m_database->run(
        QStringLiteral("SELECT MIN(first_ns), MAX(last_ns), SUM(frames) FROM block WHERE stream = ?"),
        {m_keys[stream]});
    if (!query && query.error().kind == core::ErrorKind::badInput)
        return readableExtent(stream);
    TELETA_CHECK(query);
    if (!query->next())
        return m_database->failed(query->lastError());
    if (query->value(0).isNull())
        return std::optional<Extent>();
    return std::optional(
        Extent{query->value(0).toLongLong(), query->value(1).toLongLong(), query->value(2).toULongLong()});
}

/// Block by block, where some of them cannot be read.
core::Expected<std::optional<Recording::Extent>> Recording::readableExtent(std::size_t stream) const {
    const StreamReader blocks = reader(stream);
    std::optional<Extent> extent;
    for (StreamReader::Position after;;) {
        auto query = blocks.select("key, first_ns, last_ns, frames", kForwards, after);
        while (query && query->next()) {
            after = std::max(after, placeOf<StreamReader::Position>(*query));
            if (!extent)
                extent = Extent{after.first_ns, after.first_ns, 0};
            extent->last_ns = std::max<std::int64_t>(extent->last_ns, query->value(2).toLongLong());
            extent->frames += query->value(3).toULongLong();
        }
        core::Expected<void> read;
        if (!query)
            read = core::Unexpected(query.error());
        else if (query->lastError().isValid())
            read = m_database->failed(query->lastError());
        if (read)
            return extent;
        const bool isDamage = read.error().kind == core::ErrorKind::badInput;
        const auto lost = isDamage ? blocks.place(kForwards, after) : std::nullopt;
        if (lost && *lost > after) {
            after = *lost;
            continue;
        }
        if (isDamage && extent)
            return extent;
        return core::Unexpected(read.error());
    }
}

StreamReader Recording::reader(std::size_t stream) const {
    return {m_database, m_streams[stream], m_keys[stream]};
}

double Recording::time_s(std::int64_t time_ns) const {
    return static_cast<double>(time_ns - m_head.start_ns) / 1e9;
}

QDateTime Recording::utcOf(std::int64_t time_ns) const {
    const auto after = std::ranges::upper_bound(m_anchors, time_ns, {}, &TimeAnchor::time_ns);
    if (m_anchors.empty())
        return {};
    const TimeAnchor& anchor = after == m_anchors.begin() ? m_anchors.front() : *(after - 1);
    return anchor.utc.addMSecs((time_ns - anchor.time_ns) / 1'000'000);
}

} // namespace teleta::recording
