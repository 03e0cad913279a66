// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/imported_recording.h"

#include "backend/core/data/json_document.h"
#include "backend/mcap/recorded/recording_notes.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTimeZone>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>

namespace teleta::mcap {

namespace {

using nlohmann::ordered_json;
using recording::StreamInfo;
using recording::TimeAnchor;

constexpr std::size_t kMostStreams = 4096;
constexpr long long kMostValues = 1 << 24;
constexpr std::int64_t kImportMillisecond_ns = 1'000'000;

std::string textIn(const Metadata& note, const char* key) {
    const auto found = note.values.find(key);
    return found == note.values.end() ? std::string() : found->second;
}

const Metadata* noteOf(const FileMap& map, const char* name) {
    const auto found = std::ranges::find(map.metadata, name, &Metadata::name);
    return found == map.metadata.end() ? nullptr : &*found;
}

std::optional<std::int64_t> integerOf(const std::string& text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Empty when they are damaged.
std::vector<TimeAnchor> anchorsOf(const Metadata& note, const std::string& path) {
    const auto document = core::JsonDocument::parse(textIn(note, "anchors"), path);
    if (!document)
        return {};
    constexpr long long kEnd = std::numeric_limits<std::int64_t>::max() / 4;
    core::JsonReader reader(*document);
    std::vector<TimeAnchor> anchors;
    for (const ordered_json& entry : reader.array(reader.root(), 1, kMostStreams)) {
        anchors.push_back(
            {reader.integer(reader.member(entry, "time_ns"), -kEnd, kEnd),
             QDateTime::fromString(QString::fromStdString(reader.text(reader.member(entry, "utc"))),
                                   Qt::ISODateWithMs)});
        if (!anchors.back().utc.isValid())
            return {};
    }
    return reader.error() ? std::vector<TimeAnchor>() : anchors;
}

/// A stream with its number and the first part of its topics; empty when it is damaged.
std::optional<std::tuple<long long, std::string, NotedStream>>
streamOf(const std::string& name, const std::string& text, const std::string& path) {
    const auto document = core::JsonDocument::parse(text, path);
    if (!document)
        return std::nullopt;
    core::JsonReader reader(*document);
    const ordered_json& root = reader.root();
    NotedStream noted;
    StreamInfo& info = noted.info;
    const auto kind = recording::streamKindOf(reader.text(root, "kind", {}));
    const auto type = recording::valueTypeOf(reader.text(root, "type", {}));
    if (!kind || !type)
        return std::nullopt;
    info.name = name;
    info.kind = *kind;
    info.type = *type;
    info.source = reader.text(root, "source", {});
    info.unit = reader.text(root, "unit", {});
    info.details = reader.text(root, "details", {});
    info.nominalRate_Hz = reader.number(root, "rate_hz", 0.0, 1e9, 0.0);
    noted.turnsY = reader.boolean(root, "turns_y", false);
    long long values = 1;
    for (const ordered_json& side : reader.array(reader.member(root, "shape"), 1, 3)) {
        const long long size = reader.integer(side, 0, kMostValues);
        values *= std::max(size, 1LL);
        info.shape.push_back(static_cast<std::size_t>(size));
    }
    for (const ordered_json& column : reader.array(reader.member(root, "columns"), 0, kMostStreams)) {
        const ordered_json& pair = reader.array(column, 2, 2);
        if (pair.size() == 2)
            info.columns.push_back({reader.text(pair[0]), reader.text(pair[1])});
    }
    const long long number = reader.integer(reader.member(root, "number"), 0, kMostStreams);
    const std::string topic = reader.text(reader.member(root, "topic"));
    const bool fits =
        values <= kMostValues && (info.columns.empty() || info.columns.size() == info.channels());
    if (reader.error() || !fits)
        return std::nullopt;
    return std::tuple(number, topic, std::move(noted));
}

std::string attached(McapReader& reader, const char* name) {
    const auto place = std::ranges::find(reader.map().attachments, name, &AttachmentPlace::name);
    if (place == reader.map().attachments.end())
        return {};
    auto attachment = reader.attachment(*place);
    return attachment ? std::move(attachment->data) : std::string();
}

bool readNotes(McapReader& reader, const std::string& path, ImportedRecording& imported) {
    const Metadata* note = noteOf(reader.map(), kRecordingNote);
    const Metadata* streams = noteOf(reader.map(), kStreamsNote);
    if (note == nullptr || streams == nullptr)
        return false;
    const auto start_ns = integerOf(textIn(*note, "start_ns"));
    imported.anchors = anchorsOf(*note, path);
    if (!start_ns || imported.anchors.empty())
        return false;
    std::vector<std::tuple<long long, std::string, NotedStream>> noted;
    for (const auto& [name, text] : streams->values) {
        if (auto stream = streamOf(name, text, path))
            noted.push_back(std::move(*stream));
    }
    std::ranges::stable_sort(noted, {}, [](const auto& stream) { return std::get<0>(stream); });
    for (auto& [number, topic, stream] : noted)
        imported.streams.emplace_back(std::move(topic), std::move(stream));
    imported.head = {.appVersion = textIn(*note, "app_version"),
                     .scene = textIn(*note, "scene"),
                     .sceneText = attached(reader, "scene.toml"),
                     .configuration = attached(reader, "configuration.json"),
                     .start_ns = *start_ns};
    imported.utcOffset_ns = utcOffset_ns(imported.anchors);
    return true;
}

} // namespace

ImportedRecording importedRecording(McapReader& reader, const std::string& path) {
    ImportedRecording imported;
    imported.isExport = readNotes(reader, path, imported);
    if (imported.isExport)
        return imported;
    // Steady times are those of the file. The anchor has milliseconds, so the recording begins with a whole
    // one.
    imported = {};
    std::uint64_t first_ns = 0;
    const auto& chunks = reader.map().chunks;
    for (const ChunkPlace& chunk : chunks) {
        // Chunks without a message have no times.
        if (chunk.last_ns > 0)
            first_ns = first_ns == 0 ? chunk.first_ns : std::min(first_ns, chunk.first_ns);
    }
    constexpr auto kLast_ns = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    const auto start_ms = static_cast<std::int64_t>(std::min(first_ns, kLast_ns)) / kImportMillisecond_ns;
    imported.head.appVersion = QCoreApplication::applicationVersion().toStdString();
    imported.head.start_ns = start_ms * kImportMillisecond_ns;
    const ordered_json source{{"mcap",
                               {{"file", QFileInfo(QString::fromStdString(path)).fileName().toStdString()},
                                {"profile", reader.map().profile},
                                {"library", reader.map().library}}}};
    imported.head.configuration = source.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    imported.anchors.push_back(
        {imported.head.start_ns, QDateTime::fromMSecsSinceEpoch(start_ms, QTimeZone::utc())});
    return imported;
}

} // namespace teleta::mcap
