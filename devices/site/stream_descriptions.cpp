// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/stream_descriptions.h"

#include "backend/core/data/json_document.h"
#include "backend/core/data/taxel_places.h"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace teleta::site_link {

namespace {

using nlohmann::ordered_json;

constexpr double kFastest_Hz = 1e6;
constexpr double kLargestSide = 1e5;
constexpr std::size_t kMostStreams = 256;
/// Three components of each taxel.
constexpr std::size_t kMostColumns = 3 * core::TaxelPlaces::kMost;

ordered_json detailsOf(const recording::StreamInfo& stream) {
    return ordered_json::parse(stream.details, nullptr, /*allow_exceptions=*/false);
}

bool isGreyWith(const recording::StreamInfo& stream, const char* key) {
    if (stream.kind != recording::StreamKind::camera || stream.type != recording::ValueType::grey8 ||
        stream.shape.size() != 2)
        return false;
    const ordered_json details = detailsOf(stream);
    return details.is_object() && details.contains(key);
}

} // namespace

std::string describeStreams(const std::vector<recording::StreamInfo>& streams) {
    ordered_json all = ordered_json::array();
    for (const recording::StreamInfo& stream : streams) {
        ordered_json columns = ordered_json::array();
        for (const recording::Column& column : stream.columns)
            columns.push_back({{"name", column.name}, {"unit", column.unit}});
        all.push_back({{"name", stream.name},
                       {"kind", recording::toString(stream.kind)},
                       {"type", recording::toString(stream.type)},
                       {"source", stream.source},
                       {"shape", stream.shape},
                       {"unit", stream.unit},
                       {"columns", columns},
                       {"rate_hz", stream.nominalRate_Hz},
                       {"details", stream.details}});
    }
    return core::jsonText({{"streams", all}});
}

core::Expected<std::vector<recording::StreamInfo>> readStreams(const std::string& text,
                                                               const std::string& from) {
    TELETA_TRY(const auto document, core::JsonDocument::parse(text, from));
    core::JsonReader reader(document);
    std::vector<recording::StreamInfo> streams;
    for (const ordered_json& one : reader.array(reader.member(reader.root(), "streams"), 0, kMostStreams)) {
        recording::StreamInfo stream;
        stream.name = reader.text(one, "name", {});
        const auto kind = recording::streamKindOf(reader.text(one, "kind", {}));
        const auto type = recording::valueTypeOf(reader.text(one, "type", {}));
        if (!kind || !type)
            continue; // of a newer site
        stream.kind = *kind;
        stream.type = *type;
        stream.source = reader.text(one, "source", {});
        for (const ordered_json& side : reader.array(reader.member(one, "shape"), 0, 3))
            stream.shape.push_back(static_cast<std::size_t>(reader.number(side, 0.0, kLargestSide)));
        stream.unit = reader.text(one, "unit", {});
        for (const ordered_json& column : reader.array(reader.member(one, "columns"), 0, kMostColumns))
            stream.columns.push_back({reader.text(column, "name", {}), reader.text(column, "unit", {})});
        stream.nominalRate_Hz = reader.number(reader.member(one, "rate_hz"), 0.0, kFastest_Hz);
        stream.details = reader.text(one, "details", {});
        streams.push_back(std::move(stream));
    }
    if (reader.error())
        return core::Unexpected(*reader.error());
    return streams;
}

bool isGel(const recording::StreamInfo& stream) {
    return isGreyWith(stream, "marker_gel");
}

bool isGelAtRest(const recording::StreamInfo& stream) {
    return isGreyWith(stream, "marker_gel_rest");
}

std::string frameOf(const recording::StreamInfo& stream, const std::vector<recording::StreamInfo>& all) {
    using recording::StreamKind;
    const auto detail = [](const ordered_json& details, const char* key) {
        const auto found = details.is_object() ? details.find(key) : details.end();
        return found != details.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    if (stream.kind == StreamKind::joints)
        return detail(detailsOf(stream), "base_link");
    if (stream.kind == StreamKind::wrench)
        return detail(detailsOf(stream), "frame");
    for (const recording::StreamInfo& joints : all) {
        if (stream.kind != StreamKind::array || joints.kind != StreamKind::joints)
            continue;
        const ordered_json details = detailsOf(joints);
        if (detail(details, "skin_stream") == stream.name && details.contains("pad"))
            return detail(details["pad"], "link");
    }
    return {};
}

} // namespace teleta::site_link
