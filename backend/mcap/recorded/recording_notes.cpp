// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/recording_notes.h"

#include "backend/core/data/json_document.h"
#include "backend/core/number_text.h"
#include "backend/recording/stream_columns.h"

#include <QDateTime>
#include <QTimeZone>

#include <nlohmann/json.hpp>

#include <utility>

namespace teleta::mcap {

namespace {

using nlohmann::ordered_json;
using recording::Column;
using recording::Recording;
using recording::StreamInfo;
using recording::StreamKind;

constexpr std::int64_t kPerSecond_ns = 1'000'000'000;
constexpr std::int64_t kPerMillisecond_ns = 1'000'000;

std::string dump(const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json detailsOf(const StreamInfo& stream) {
    ordered_json details = ordered_json::parse(stream.details, nullptr, /*allow_exceptions=*/false);
    return details.is_object() ? details : ordered_json::object();
}

/// A list of numbers in the settings of an array; empty when it is not there.
ordered_json listOf(const ordered_json& settings, const char* key) {
    const auto found = settings.find(key);
    return found != settings.end() && found->is_array() ? *found : ordered_json::array();
}

std::string numberOrNone(const ordered_json& value) {
    return value.is_number() ? std::string(core::NumberText(value.get<double>()).view()) : "NA";
}

/// A frame file with one frame, as the option --tare takes it.
std::string tareText(const ordered_json& tare) {
    std::string names = "time_s";
    std::string values = "0";
    for (std::size_t i = 0; i < tare.size(); ++i) {
        names.append(",t").append(core::NumberText(i).view());
        values.append(",").append(numberOrNone(tare[i]));
    }
    return names + "\n" + values + "\n";
}

/// As `teleta gains` writes it, but for the errors, which a recording does not have.
std::string gainsText(const ordered_json& gains, std::size_t columns) {
    std::string text = "taxel,row,column,gain,gain_se,state\n";
    for (std::size_t i = 0; i < gains.size(); ++i) {
        for (const std::size_t number : {i, i / columns, i % columns})
            text.append(core::NumberText(number).view()).append(",");
        text.append(numberOrNone(gains[i])).append(",NA,").append(gains[i].is_number() ? "good" : "dead");
        text.append("\n");
    }
    return text;
}

} // namespace

std::string utcText(std::int64_t utc_ns) {
    const std::int64_t past_ns = ((utc_ns % kPerSecond_ns) + kPerSecond_ns) % kPerSecond_ns;
    const QDateTime second =
        QDateTime::fromSecsSinceEpoch((utc_ns - past_ns) / kPerSecond_ns, QTimeZone::utc());
    return QStringLiteral("%1.%2Z")
        .arg(second.toString(QStringLiteral("yyyy-MM-dd'T'HH:mm:ss")))
        .arg(past_ns, 9, 10, QLatin1Char('0'))
        .toStdString();
}

std::int64_t utcOffset_ns(std::span<const recording::TimeAnchor> anchors) {
    if (anchors.empty())
        return 0;
    return anchors.front().utc.toMSecsSinceEpoch() * kPerMillisecond_ns - anchors.front().time_ns;
}

Metadata recordingNote(const Recording& recording, std::span<const std::size_t> streams) {
    ordered_json anchors = ordered_json::array();
    for (const recording::TimeAnchor& anchor : recording.anchors())
        anchors.push_back(
            {{"time_ns", anchor.time_ns}, {"utc", anchor.utc.toString(Qt::ISODateWithMs).toStdString()}});
    ordered_json units = ordered_json::object();
    for (const std::size_t number : streams) {
        const StreamInfo& stream = recording.streams()[number];
        ordered_json& own = units[stream.name] = ordered_json::object();
        if (!stream.unit.empty())
            own["values"] = stream.unit;
        for (const Column& column : stream.columns) {
            if (!column.unit.empty())
                own[column.name] = column.unit;
        }
    }
    const recording::RecordingHead& head = recording.head();
    return {kRecordingNote,
            {{"anchors", dump(anchors)},
             {"app_version", head.appVersion},
             {"scene", head.scene},
             {"start_ns", std::string(core::NumberText(head.start_ns).view())},
             {"start_utc", utcText(head.start_ns + utcOffset_ns(recording.anchors()))},
             {"units", dump(units)}}};
}

Metadata streamsNote(const Recording& recording, std::span<const std::size_t> streams,
                     const std::vector<RosNames>& names) {
    Metadata note{kStreamsNote, {}};
    for (const std::size_t number : streams) {
        const StreamInfo& stream = recording.streams()[number];
        ordered_json columns = ordered_json::array();
        for (const Column& column : stream.columns)
            columns.push_back({column.name, column.unit});
        note.values[stream.name] = dump({{"number", number},
                                         {"topic", names[number].topic},
                                         {"turns_y", names[number].turnsY},
                                         {"kind", toString(stream.kind)},
                                         {"type", toString(stream.type)},
                                         {"source", stream.source},
                                         {"shape", stream.shape},
                                         {"unit", stream.unit},
                                         {"columns", columns},
                                         {"rate_hz", stream.nominalRate_Hz},
                                         {"details", stream.details}});
    }
    return note;
}

std::vector<Attachment> recordingAttachments(const Recording& recording, std::span<const std::size_t> streams,
                                             const std::vector<RosNames>& names) {
    const recording::RecordingHead& head = recording.head();
    const auto start_ns = static_cast<std::uint64_t>(head.start_ns + utcOffset_ns(recording.anchors()));
    std::vector<Attachment> attachments;
    const auto attach = [&](std::string name, const char* mediaType, std::string text) {
        if (!text.empty())
            attachments.push_back({start_ns, start_ns, std::move(name), mediaType, std::move(text)});
    };
    attach("scene.toml", "application/toml", head.sceneText);
    attach("configuration.json", "application/json", head.configuration);
    for (const std::size_t number : streams) {
        const StreamInfo& stream = recording.streams()[number];
        const ordered_json details = detailsOf(stream);
        const std::string& name = names[number].topic;
        if (stream.kind == StreamKind::camera && details.contains("camera"))
            attach(name + "/camera.json", "application/json", core::jsonText(details["camera"]));
        if (stream.kind != StreamKind::array || !details.contains("settings") || stream.shape.size() != 2 ||
            recording::isVectorArray(stream))
            continue;
        const ordered_json tare = listOf(details["settings"], "tare");
        const ordered_json gains = listOf(details["settings"], "taxel_gains");
        attach(name + "/tare.csv", "text/csv", tare.empty() ? std::string() : tareText(tare));
        attach(name + "/gains.csv", "text/csv",
               gains.empty() || stream.shape[1] == 0 ? std::string() : gainsText(gains, stream.shape[1]));
    }
    return attachments;
}

} // namespace teleta::mcap
