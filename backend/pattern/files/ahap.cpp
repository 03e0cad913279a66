// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

using nlohmann::ordered_json;

constexpr double kSharpness = 0.5; ///< the motors have no control of their own for it

ordered_json parameter(const char* id, double value) {
    return {{"ParameterID", id}, {"ParameterValue", value}};
}

ordered_json event(double begin_s, double end_s) {
    ordered_json event{{"Time", begin_s},
                       {"EventType", "HapticContinuous"},
                       {"EventDuration", end_s - begin_s},
                       {"EventParameters", ordered_json::array({parameter("HapticIntensity", 1.0),
                                                                parameter("HapticSharpness", kSharpness)})}};
    return {{"Event", std::move(event)}};
}

/// Uses points [first, last].
ordered_json curve(const Track& points, std::size_t first, std::size_t last) {
    ordered_json control = ordered_json::array();
    for (std::size_t k = first; k <= last; ++k)
        control.push_back(
            {{"Time", points[k].time_s - points[first].time_s}, {"ParameterValue", points[k].intensity}});
    ordered_json curve{{"ParameterID", "HapticIntensityControl"},
                       {"Time", points[first].time_s},
                       {"ParameterCurveControlPoints", std::move(control)}};
    return {{"ParameterCurve", std::move(curve)}};
}

} // namespace

core::Expected<std::string> tactorToAhap(const Pattern& pattern, std::size_t tactor) {
    TELETA_TRY(const Track lines,
               linearised(pattern, tactor, [](double amplitude) { return std::sqrt(amplitude); }));
    ordered_json parts = ordered_json::array();
    for (const Track& stretch : stretches(lines)) {
        const double begin_s = stretch.front().time_s;
        const double end_s = stretch.back().time_s;
        for (double from_s = begin_s; from_s < end_s; from_s += kLongestEvent_s)
            parts.push_back(event(from_s, std::min(from_s + kLongestEvent_s, end_s)));
        // A curve begins where the previous one ends.
        for (std::size_t first = 0; first + 1 < stretch.size(); first += kMostCurvePoints - 1)
            parts.push_back(
                curve(stretch, first, std::min(first + kMostCurvePoints - 1, stretch.size() - 1)));
    }
    const ordered_json root{{"Version", 1.0},
                            {"Metadata",
                             {{"Project", pattern.name},
                              {"Created", kEditorName},
                              {"Description", std::string(kSourceTactor) + std::to_string(tactor + 1)}}},
                            {"Pattern", std::move(parts)}};
    return core::jsonText(root);
}

core::Expected<std::vector<ZipEntry>> patternToAhaps(const Pattern& pattern) {
    return tactorFiles(pattern, ".ahap", tactorToAhap);
}

} // namespace teleta::pattern
