// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/export_description.h"

#include "backend/core/failure.h"
#include "backend/core/unit_names.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace teleta::recording {

namespace {

using nlohmann::ordered_json;

struct DescriptionText {
    Q_DECLARE_TR_FUNCTIONS(RecordingExport)
};

/// Of a whole file; nothing: goOn ended it.
core::Expected<std::optional<std::string>> sha256(const std::string& path,
                                                  const std::function<bool()>& goOn) {
    constexpr qint64 kPiece = 4 << 20;
    QFile file(QString::fromStdString(path));
    QCryptographicHash sum(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::ioFailed, DescriptionText::tr("the recording cannot be read"),
                            {}, {path});
    while (!file.atEnd()) {
        if (goOn && !goOn())
            return std::optional<std::string>();
        const QByteArray piece = file.read(kPiece);
        if (piece.isEmpty())
            return core::failed(core::ErrorKind::ioFailed, file.errorString(), {}, {path});
        sum.addData(piece);
    }
    return std::optional(sum.result().toHex().toStdString());
}

std::string utcText(const QDateTime& utc) {
    return utc.isValid() ? utc.toUTC().toString(Qt::ISODateWithMs).toStdString() : std::string();
}

ordered_json textOrNull(const std::string& text) {
    return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

/// By the name of the column; otherwise what the stream says.
std::string unitOf(const StreamInfo* stream, const std::string& column) {
    if (const auto unit = core::unitOfColumn(column); unit && !unit->empty())
        return std::string(*unit);
    if (stream == nullptr)
        return {};
    const auto own = std::ranges::find(stream->columns, column, &Column::name);
    if (own != stream->columns.end())
        return own->unit;
    return stream->kind == StreamKind::array && column != "utc_s" ? stream->unit : std::string();
}

ordered_json description(const DescribedTable& table) {
    ordered_json columns = ordered_json::array();
    for (const std::string& column : table.columns)
        columns.push_back({{"name", column}, {"unit", textOrNull(unitOf(table.stream, column))}});
    const std::string name = QFileInfo(QString::fromStdString(table.path)).fileName().toStdString();
    ordered_json described{{"file", name}};
    if (table.stream != nullptr)
        described.update({{"stream", table.stream->name},
                          {"kind", toString(table.stream->kind)},
                          {"source", textOrNull(table.stream->source)},
                          {"nominal_rate_hz", table.stream->nominalRate_Hz}});
    described["rows"] = table.rows;
    described["damaged_blocks"] = table.damagedBlocks;
    described["columns"] = std::move(columns);
    return described;
}

} // namespace

std::string unixSeconds(const Recording& recording, std::int64_t time_ns) {
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    if (recording.anchors().empty())
        return "NA";
    const TimeAnchor& anchor = recording.anchors().front();
    const std::int64_t unix_ns = anchor.utc.toMSecsSinceEpoch() * 1'000'000 + (time_ns - anchor.time_ns);
    const std::int64_t size_ns = unix_ns < 0 ? -unix_ns : unix_ns;
    char text[32];
    const int length = std::snprintf(text, sizeof text, "%s%lld.%09lld", unix_ns < 0 ? "-" : "",
                                     static_cast<long long>(size_ns / kPerSecond),
                                     static_cast<long long>(size_ns % kPerSecond));
    return {text, static_cast<std::size_t>(length)};
}

core::Expected<std::string> exportDescription(const Recording& recording,
                                              const std::vector<DescribedTable>& tables,
                                              const std::function<bool()>& goOn) {
    TELETA_TRY(const auto sum, sha256(recording.path(), goOn));
    const RecordingHead& head = recording.head();
    ordered_json document{
        {"recording", QFileInfo(QString::fromStdString(recording.path())).fileName().toStdString()},
        {"sha256", sum ? ordered_json(*sum) : ordered_json(nullptr)},
        {"complete", recording.isComplete()},
        {"scene", textOrNull(head.scene)},
        {"app_version", head.appVersion},
        {"exported_by", QCoreApplication::applicationVersion().toStdString()},
        {"start_utc", textOrNull(utcText(recording.utcOf(head.start_ns)))},
        {"anchors", ordered_json::array()},
        {"tables", ordered_json::array()}};
    for (const TimeAnchor& anchor : recording.anchors())
        document["anchors"].push_back(
            {{"time_s", recording.time_s(anchor.time_ns)}, {"utc", utcText(anchor.utc)}});
    for (const DescribedTable& table : tables)
        document["tables"].push_back(description(table));
    return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace teleta::recording
