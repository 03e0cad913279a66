// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/tact_layout.h"
#include "backend/pattern/model/bake.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace teleta::pattern {

namespace {

using nlohmann::ordered_json;

constexpr double kIntensityStep = 1e-4;

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

/// What one arm plays, with the keys that other programs expect.
ordered_json device(ordered_json feedback) {
    ordered_json path{{"movingPattern", "CONST_SPEED"},
                      {"playbackType", "NONE"},
                      {"visible", true},
                      {"pointList", ordered_json::array()}};
    return {{"mode", "DOT_MODE"},
            {"dotMode", {{"dotConnected", false}, {"feedback", std::move(feedback)}}},
            {"pathMode", {{"feedback", ordered_json::array({std::move(path)})}}}};
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
    const char* const side = pattern.arm == Arm::left ? kTactLeft : kTactRight;
    const char* const other = pattern.arm == Arm::left ? kTactRight : kTactLeft;
    ordered_json effect{
        {"name", pattern.name},
        {"startTime", 0},
        {"offsetTime", duration_ms},
        {"modes", {{side, device(std::move(feedback))}, {other, device(ordered_json::array())}}}};
    ordered_json layout = ordered_json::array();
    for (std::size_t i = 0; i < core::kTactors; ++i)
        layout.push_back({{"index", i}, {"x", tactPlace(i).x}, {"y", tactPlace(i).y}});
    ordered_json track{{"enable", true}, {"effects", ordered_json::array({std::move(effect)})}};
    const ordered_json root{{"project",
                             {{"name", pattern.name},
                              {"description", pattern.notes},
                              {"mediaFileDuration", 1e-3 * static_cast<double>(duration_ms)},
                              {"layout",
                               {{"type", kTactLayout},
                                {"name", kTactLayout},
                                {"layouts", {{kTactLeft, layout}, {kTactRight, layout}}}}},
                              {"tracks", ordered_json::array({std::move(track)})}}},
                            {"durationMillis", duration_ms},
                            {"intervalMillis", kTactPiece_ms},
                            {"size", kTactPiece_ms}};
    return core::jsonText(root);
}

} // namespace teleta::pattern
