// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/scene_summary.h"

#include "backend/core/data/json_document.h"
#include "backend/core/data/output_file.h"
#include "backend/core/quantile.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace teleta::scene_run {

using nlohmann::ordered_json;

namespace {

ordered_json toJson(const RunVerdict& verdict) {
    if (verdict.completed)
        return {{"result", "completed"}};
    ordered_json json{{"result", "not_completed"},
                      {"phase", servo::toString(verdict.phase)},
                      {"reason", servo::toString(verdict.reason)}};
    if (verdict.limit)
        json["limit"] = servo::toString(*verdict.limit);
    json["expected"] = verdict.expected;
    return json;
}

} // namespace

ordered_json SceneSummary::toJson() const {
    const auto times = [](const std::vector<EffectTime>& list) {
        ordered_json entries = ordered_json::array();
        for (const EffectTime& each : list)
            entries.push_back({{"name", each.name}, {"time_s", each.time_s}});
        return entries;
    };
    ordered_json document{
        {"scene", scene},   {"app_version", QCoreApplication::applicationVersion().toStdString()},
        {"seed", seed},     {"simulated_s", simulated_s},
        {"wall_s", wall_s}, {"effects", times(effects)}};
    if (!parts.empty())
        document["parts"] = times(parts);
    if (verdict)
        document["verdict"] = scene_run::toJson(*verdict);
    document["measures"] = measures;
    document["events"] = events;
    return document;
}

ordered_json jsonNumber(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json orNull(const std::optional<double>& value) {
    return value ? jsonNumber(*value) : ordered_json(nullptr);
}

double mean(const std::vector<double>& values) {
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double probability) {
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    return core::quantileOf(values, probability);
}

void reportContactErrors(const std::vector<double>& errors_m, ordered_json& measures) {
    measures["contact_error_mean_m"] = jsonNumber(mean(errors_m));
    measures["contact_error_p95_m"] = jsonNumber(quantile(errors_m, 0.95));
}

core::Expected<void> writeJson(const std::string& path, const ordered_json& document) {
    return core::writeFile(path, core::jsonText(document));
}

} // namespace teleta::scene_run
