// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct TactText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr const char* kLeft = "ForearmL";
constexpr const char* kRight = "ForearmR";
constexpr double kIntensityStep = 1e-4;
constexpr long long kMost_ms = static_cast<long long>(Pattern::kLongest_s * 1000.0);

/// Milliseconds at which an intensity may change: corners, and the pieces of the slopes between them.
std::set<long long> cuts(const Tracks& tracks, long long duration_ms) {
    std::set<long long> all{0, duration_ms};
    for (const Track& track : tracks) {
        for (std::size_t k = 0; k < track.size(); ++k) {
            const long long here_ms = std::llround(1000.0 * track[k].time_s);
            all.insert(here_ms);
            if (k == 0 || track[k].intensity == track[k - 1].intensity)
                continue;
            for (long long ms = std::llround(1000.0 * track[k - 1].time_s) + kTactPiece_ms; ms < here_ms;
                 ms += kTactPiece_ms)
                all.insert(ms);
        }
    }
    all.erase(all.upper_bound(duration_ms), all.end());
    return all;
}

ordered_json dots(const core::Intensities& intensities) {
    ordered_json points = ordered_json::array();
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        // Rounded by a division, so that 0.75 stays 0.75.
        const double intensity =
            std::round(intensities[i] / kIntensityStep) / std::round(1.0 / kIntensityStep);
        if (intensity > 0.0)
            points.push_back({{"index", i}, {"intensity", intensity}});
    }
    return points;
}

/// The track of one dot during one piece of feedback; times in s.
Track stretch(JsonReader& reader, const ordered_json& type, double begin_s, double end_s, double intensity) {
    const std::string name = reader.text(type);
    const double middle_s = 0.5 * (begin_s + end_s);
    if (name == "NONE")
        return {{begin_s, intensity}, {end_s, intensity}};
    if (name == "FADE_IN")
        return {{begin_s, 0.0}, {end_s, intensity}};
    if (name == "FADE_OUT")
        return {{begin_s, intensity}, {end_s, 0.0}};
    if (name == "FADE_IN_OUT")
        return {{begin_s, 0.0}, {middle_s, intensity}, {end_s, 0.0}};
    reader.fail(type, TactText::tr("this name is unknown"), "NONE, FADE_IN, FADE_OUT, FADE_IN_OUT");
    return {};
}

void readFeedback(JsonReader& reader, const ordered_json& feedback, long long offset_ms,
                  TrackBuilder& tracks) {
    const ordered_json& end = reader.member(feedback, "endTime");
    const long long begin_ms = offset_ms + reader.integer(reader.member(feedback, "startTime"), 0, kMost_ms);
    const long long end_ms = offset_ms + reader.integer(end, 0, kMost_ms);
    if (end_ms < begin_ms || end_ms > kMost_ms)
        reader.fail(end, TactText::tr("the times decrease or exceed the longest pattern"),
                    TactText::tr("a time that is not before the start"));
    const ordered_json& type = reader.member(feedback, "playbackType");
    for (const ordered_json& point : reader.array(reader.member(feedback, "pointList"), 0, 1000)) {
        const auto tactor =
            static_cast<std::size_t>(reader.integer(reader.member(point, "index"), 0, core::kTactors - 1));
        const double intensity = reader.number(reader.member(point, "intensity"), 0.0, 1.0);
        if (reader.error())
            return;
        tracks.add(tactor, stretch(reader, type, 1e-3 * static_cast<double>(begin_ms),
                                   1e-3 * static_cast<double>(end_ms), intensity));
    }
}

void readEffect(JsonReader& reader, const ordered_json& effect, Pattern& pattern, TrackBuilder& tracks) {
    const long long start_ms = reader.integer(reader.member(effect, "startTime"), 0, kMost_ms);
    if (const ordered_json* length = reader.find(effect, "offsetTime")) {
        const long long length_ms = reader.integer(*length, 0, kMost_ms - start_ms);
        pattern.duration_s = std::max(pattern.duration_s, 1e-3 * static_cast<double>(start_ms + length_ms));
    }
    const ordered_json& modes = reader.member(effect, "modes");
    const ordered_json* forearm = reader.find(modes, kLeft);
    if (forearm != nullptr)
        pattern.arm = Arm::left;
    if (forearm == nullptr)
        forearm = reader.find(modes, kRight);
    if (forearm == nullptr) {
        reader.fail(modes, TactText::tr("this effect is for other devices"), "ForearmL, ForearmR");
        return;
    }
    if (const ordered_json* mode = reader.find(*forearm, "mode")) {
        if (reader.text(*mode) != "DOT_MODE") {
            reader.fail(*mode, TactText::tr("a pattern cannot represent this"), "DOT_MODE");
            return;
        }
    }
    const ordered_json& dotMode = reader.member(*forearm, "dotMode");
    for (const ordered_json& feedback :
         reader.array(reader.member(dotMode, "feedback"), 0, Pattern::kMostBreakpoints)) {
        if (reader.error())
            return;
        readFeedback(reader, feedback, start_ms, tracks);
    }
}

} // namespace

core::Expected<std::string> patternToTact(const Pattern& pattern) {
    TELETA_TRY(const Tracks tracks, linearised(pattern));
    const long long duration_ms = std::llround(1000.0 * pattern.duration_s);
    const std::set<long long> times_ms = cuts(tracks, duration_ms);
    const CompiledPattern compiled(pattern);
    ordered_json feedback = ordered_json::array();
    for (auto begin = times_ms.begin(); begin != times_ms.end() && std::next(begin) != times_ms.end();
         ++begin) {
        const long long end_ms = *std::next(begin);
        ordered_json points = dots(compiled.evaluate(0.0005 * static_cast<double>(*begin + end_ms)));
        if (points.empty())
            continue;
        if (!feedback.empty() && feedback.back()["endTime"] == *begin &&
            feedback.back()["pointList"] == points) {
            feedback.back()["endTime"] = end_ms;
            continue;
        }
        feedback.push_back({{"startTime", *begin},
                            {"endTime", end_ms},
                            {"playbackType", "NONE"},
                            {"pointList", std::move(points)}});
    }
    const char* const side = pattern.arm == Arm::left ? kLeft : kRight;
    ordered_json forearm{{"mode", "DOT_MODE"},
                         {"dotMode", {{"dotConnected", false}, {"feedback", std::move(feedback)}}}};
    ordered_json effect{{"name", pattern.name},
                        {"startTime", 0},
                        {"offsetTime", duration_ms},
                        {"modes", {{side, std::move(forearm)}}}};
    ordered_json layout = ordered_json::array();
    for (std::size_t i = 0; i < core::kTactors; ++i)
        layout.push_back({{"index", i},
                          {"x", static_cast<double>(i) / (core::kTactors - 1)},
                          {"y", static_cast<double>(i % 2)}});
    ordered_json track{{"enable", true}, {"effects", ordered_json::array({std::move(effect)})}};
    const ordered_json root{
        {"project",
         {{"name", pattern.name},
          {"description", pattern.notes},
          {"mediaFileDuration", 1e-3 * static_cast<double>(duration_ms)},
          {"layout", {{"type", side}, {"name", side}, {"layouts", {{side, std::move(layout)}}}}},
          {"tracks", ordered_json::array({std::move(track)})}}},
        {"durationMillis", duration_ms},
        {"intervalMillis", kTactPiece_ms},
        {"size", kTactPiece_ms}};
    return core::jsonText(root);
}

core::Expected<Pattern> patternFromTact(std::string text, const std::string& file) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& project = reader.member(reader.root(), "project");
    Pattern pattern;
    TrackBuilder tracks;
    if (!reader.error()) {
        pattern.name = reader.text(project, "name", {});
        pattern.notes = reader.text(project, "description", {});
    }
    for (const ordered_json& track : reader.array(reader.member(project, "tracks"), 0, 1000)) {
        if (!reader.boolean(track, "enable", true))
            continue;
        for (const ordered_json& effect :
             reader.array(reader.member(track, "effects"), 0, Pattern::kMostObjects)) {
            if (!reader.error())
                readEffect(reader, effect, pattern, tracks);
        }
    }
    if (reader.error())
        return core::Unexpected(*reader.error());
    tracks.build(pattern);
    return pattern;
}

} // namespace teleta::pattern
