// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
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

/// Says whether the frequencies are those of the program: equal to the amplitudes.
bool followsAmplitude(JsonReader& reader, const ordered_json& frequencies, const Track& lines) {
    std::size_t k = 0;
    for (const ordered_json& point : frequencies) {
        const double time_s = reader.number(point, "time", 0.0, Pattern::kLongest_s, 0.0);
        const double frequency = reader.number(point, "frequency", 0.0, 1.0, 0.0);
        if (k >= lines.size() || lines[k].time_s != time_s || lines[k].intensity != frequency)
            return false;
        ++k;
    }
    return k == lines.size();
}

void readFrequencies(JsonReader& reader, const ordered_json& envelopes, const Track& lines,
                     LossCounter& losses) {
    const ordered_json* const found = reader.find(envelopes, "frequency");
    if (found == nullptr)
        return;
    const ordered_json& frequencies = reader.array(*found, 0, Pattern::kMostBreakpoints);
    if (frequencies.empty() || followsAmplitude(reader, frequencies, lines))
        return;
    losses.add(LossKind::frequency, reader.number(frequencies.front(), "time", 0.0, Pattern::kLongest_s, 0.0),
               frequencies.size());
}

/// An emphasis on the envelope's last point so far.
void addEmphasis(JsonReader& reader, const ordered_json& emphasis, const Breakpoint& at, std::size_t tactor,
                 Pattern& pattern, LossCounter& losses) {
    const double strength = reader.number(reader.member(emphasis, "amplitude"), at.intensity, 1.0);
    pattern.objects.push_back(
        {"emphasis",
         Ramp{at.time_s, kBurst_s, {static_cast<int>(tactor)}, strength, strength, Easing::linear},
         {}});
    losses.add(LossKind::burst, at.time_s);
    if (reader.find(emphasis, "frequency") != nullptr)
        losses.add(LossKind::frequency, at.time_s);
}

/// Extends a pattern to the length of a file, and beyond it for a burst that would be cut.
void extendTo(double end_s, double burstEnd_s, Pattern& pattern, LossCounter& losses) {
    pattern.duration_s = std::max(pattern.duration_s, end_s);
    const double needed_s = std::min(burstEnd_s, Pattern::kLongest_s);
    if (needed_s <= pattern.duration_s)
        return;
    const double longer_s = std::round(1e4 * (needed_s - pattern.duration_s)) / 1e4;
    losses.note(LossKind::longer, 1, QString::number(longer_s).toStdString());
    pattern.duration_s = needed_s;
}

core::Expected<std::string> addHaptic(std::string text, const std::string& file, std::size_t tactor,
                                      Pattern& pattern, LossCounter& losses) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    (void)reader.integer(reader.member(reader.member(root, "version"), "major"), 1, 1);
    std::string source;
    if (const ordered_json* metadata = reader.find(root, "metadata")) {
        const std::string description = reader.text(*metadata, "description", {});
        if (pattern.notes.empty())
            pattern.notes = description;
        const std::string project = reader.text(*metadata, "project", {});
        if (pattern.name.empty())
            pattern.name = project;
        if (reader.text(*metadata, "editor", {}) == kEditorName)
            source = reader.text(*metadata, "source", {});
    }
    const ordered_json& continuous = reader.member(reader.member(root, "signals"), "continuous");
    const ordered_json& envelopes = reader.member(continuous, "envelopes");
    Track lines;
    double lastBurst_s = -1.0;
    for (const ordered_json& point :
         reader.array(reader.member(envelopes, "amplitude"), 1, Pattern::kMostBreakpoints)) {
        const ordered_json& time = reader.member(point, "time");
        const ordered_json& amplitude = reader.member(point, "amplitude");
        lines.push_back({reader.number(time, 0.0, Pattern::kLongest_s), reader.number(amplitude, 0.0, 1.0)});
        if (lines.size() > 1 && lines.back().time_s < lines[lines.size() - 2].time_s)
            reader.fail(time, HapticText::tr("the times decrease"),
                        HapticText::tr("a time that is not before the previous one"));
        if (const ordered_json* emphasis = reader.find(point, "emphasis")) {
            addEmphasis(reader, *emphasis, lines.back(), tactor, pattern, losses);
            lastBurst_s = lines.back().time_s;
        }
        if (pattern.objects.size() > Pattern::kMostObjects)
            reader.fail(point, HapticText::tr("there are too many emphases"),
                        HapticText::tr("at most %1").arg(Pattern::kMostObjects));
        if (reader.error())
            return core::Unexpected(*reader.error());
    }
    if (!reader.error())
        readFrequencies(reader, envelopes, lines, losses);
    if (reader.error())
        return core::Unexpected(*reader.error());
    const double end_s = lines.back().time_s;
    if (lines.size() == 1 && lastBurst_s < 0.0 && lines.front().intensity > 0.0)
        losses.add(LossKind::point, end_s);
    extendTo(end_s, lastBurst_s < 0.0 ? 0.0 : lastBurst_s + kBurst_s, pattern, losses);
    if (lines.size() > 1)
        pattern.tracks[tactor] = trimmed(simplified(lines));
    return source;
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
                             {{"editor", kEditorName},
                              {"source", std::string(kSourceTactor) + std::to_string(tactor + 1)},
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

core::Expected<PatternImport> patternFromHaptics(std::vector<ZipEntry> entries, const std::string& file) {
    return importSignals(std::move(entries), file, std::string(kEnding), addHaptic);
}

core::Expected<PatternImport> patternFromHaptic(std::string text, const std::string& file,
                                                const ImportOptions& options) {
    return importSignal(std::move(text), file, options, addHaptic);
}

} // namespace teleta::pattern
