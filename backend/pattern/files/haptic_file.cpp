// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/core/failure.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct HapticText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr std::string_view kEnding = ".haptic";

/// The envelope over the whole pattern including silence: the length of a file is that of its envelope.
Track wholeEnvelope(const Track& lines, double duration_s) {
    Track whole;
    if (lines.empty() || lines.front().time_s > 0.0)
        whole.push_back({0.0, 0.0});
    if (!lines.empty() && lines.front().time_s > 0.0)
        whole.push_back({lines.front().time_s, 0.0});
    whole.insert(whole.end(), lines.begin(), lines.end());
    if (!lines.empty() && lines.back().time_s < duration_s && lines.back().intensity > 0.0)
        whole.push_back({lines.back().time_s, 0.0});
    if (whole.back().time_s < duration_s || whole.size() < 2)
        whole.push_back({std::max(duration_s, whole.back().time_s), 0.0});
    return whole;
}

std::optional<std::size_t> tactorOfName(std::string_view name) {
    if (!name.ends_with(kEnding))
        return std::nullopt;
    name.remove_suffix(kEnding.size());
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    if (name.size() - digits != 1 || name[digits] < '1' || name[digits] > '6')
        return std::nullopt;
    return static_cast<std::size_t>(name[digits] - '1');
}

/// Adds the envelope of one file and extends the pattern to its length.
core::Expected<void> addEnvelope(std::string text, const std::string& file, std::size_t tactor,
                                 Pattern& pattern) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    (void)reader.integer(reader.member(reader.member(root, "version"), "major"), 1, 1);
    if (const ordered_json* metadata = reader.find(root, "metadata")) {
        const std::string description = reader.text(*metadata, "description", {});
        if (pattern.notes.empty())
            pattern.notes = description;
        const std::string project = reader.text(*metadata, "project", {});
        if (pattern.name.empty())
            pattern.name = project;
    }
    const ordered_json& continuous = reader.member(reader.member(root, "signals"), "continuous");
    const ordered_json& envelopes = reader.member(continuous, "envelopes");
    Track lines;
    for (const ordered_json& point :
         reader.array(reader.member(envelopes, "amplitude"), 2, Pattern::kMostBreakpoints)) {
        const ordered_json& time = reader.member(point, "time");
        const ordered_json& amplitude = reader.member(point, "amplitude");
        lines.push_back({reader.number(time, 0.0, Pattern::kLongest_s), reader.number(amplitude, 0.0, 1.0)});
        if (lines.size() > 1 && lines.back().time_s < lines[lines.size() - 2].time_s)
            reader.fail(time, HapticText::tr("the times decrease"),
                        HapticText::tr("a time that is not before the previous one"));
        if (const ordered_json* emphasis = reader.find(point, "emphasis")) {
            const double strength =
                reader.number(reader.member(*emphasis, "amplitude"), lines.back().intensity, 1.0);
            pattern.objects.push_back({"emphasis",
                                       Ramp{lines.back().time_s,
                                            kEmphasis_s,
                                            {static_cast<int>(tactor)},
                                            strength,
                                            strength,
                                            Easing::linear},
                                       {}});
        }
        if (reader.error())
            return core::Unexpected(*reader.error());
    }
    if (reader.error())
        return core::Unexpected(*reader.error());
    pattern.duration_s = std::max(pattern.duration_s, lines.back().time_s);
    pattern.tracks[tactor] = trimmed(simplified(lines));
    return {};
}

} // namespace

core::Expected<std::string> tactorToHaptic(const Pattern& pattern, std::size_t tactor) {
    TELETA_TRY(const Track lines, linearised(pattern, tactor));
    ordered_json amplitude = ordered_json::array();
    ordered_json frequency = ordered_json::array();
    for (const Breakpoint& point : wholeEnvelope(lines, pattern.duration_s)) {
        amplitude.push_back({{"time", point.time_s}, {"amplitude", point.intensity}});
        frequency.push_back({{"time", point.time_s}, {"frequency", point.intensity}});
    }
    ordered_json envelopes{{"amplitude", std::move(amplitude)}, {"frequency", std::move(frequency)}};
    ordered_json content;
    content["continuous"]["envelopes"] = std::move(envelopes);
    const ordered_json root{{"version", {{"major", 1}, {"minor", 0}, {"patch", 0}}},
                            {"metadata",
                             {{"editor", "TeleTA Console"},
                              {"source", "tactor " + std::to_string(tactor + 1)},
                              {"project", pattern.name},
                              {"tags", pattern.tags},
                              {"description", pattern.notes}}},
                            {"signals", std::move(content)}};
    return core::jsonText(root);
}

core::Expected<std::vector<ZipEntry>> tactorFiles(const Pattern& pattern, const std::string& ending,
                                                  TactorText text) {
    std::vector<ZipEntry> entries;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        TELETA_TRY(std::string content, text(pattern, i));
        entries.push_back({"tactor" + std::to_string(i + 1) + ending, std::move(content)});
    }
    return entries;
}

core::Expected<std::vector<ZipEntry>> patternToHaptics(const Pattern& pattern) {
    return tactorFiles(pattern, std::string(kEnding), tactorToHaptic);
}

core::Expected<Pattern> patternFromHaptics(std::vector<ZipEntry> entries, const std::string& file) {
    Pattern pattern;
    std::array<bool, core::kTactors> taken{};
    for (ZipEntry& entry : entries) {
        const std::optional<std::size_t> tactor = tactorOfName(entry.name);
        if (!tactor || taken[*tactor])
            return core::failed(core::ErrorKind::badInput,
                                HapticText::tr("there is no tactor for the file \"%1\"")
                                    .arg(QString::fromStdString(entry.name)),
                                HapticText::tr("files tactor1.haptic to tactor6.haptic, each once"),
                                {file, 0, 0});
        taken[*tactor] = true;
        TELETA_CHECK(addEnvelope(std::move(entry.content), file + '/' + entry.name, *tactor, pattern));
    }
    return pattern;
}

core::Expected<Pattern> patternFromHaptic(std::string text, const std::string& file) {
    Pattern pattern;
    TELETA_CHECK(addEnvelope(std::move(text), file, 0, pattern));
    return pattern;
}

} // namespace teleta::pattern
