// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/servo/task_verdict.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::scene_run {

/// Whether a run did its task.
struct RunVerdict : servo::TaskVerdict {
    bool expected = false; ///< the scene says that it is not completed
};

/// What a simulated scene has shown: the content of summary.json.
struct SceneSummary {
    struct EffectTime {
        std::string name;
        double time_s = 0.0; ///< computing time that the effect took
    };

    std::string scene;
    std::uint64_t seed = 1;
    double simulated_s = 0.0;
    double wall_s = 0.0;
    std::vector<EffectTime> effects; ///< those that were built
    /// Computing time of the parts of the loop, for a scene that times them; estimated from a sample of its
    /// cycles.
    std::vector<EffectTime> parts;
    /// Name -> number, text or list. What a scene has nothing to say about is missing; what it could not
    /// determine is null.
    nlohmann::ordered_json measures = nlohmann::ordered_json::object();
    nlohmann::ordered_json events = nlohmann::ordered_json::array();
    std::optional<RunVerdict> verdict; ///< of a scene with a task
    bool interrupted = false;          ///< it was ended before its time; not in the file

    /// Takes the simulated time and the times of the effects from a simulated world at the end of its run.
    template <typename World>
    void takeTimes(const World& world) {
        simulated_s = world.time_s();
        for (const auto& effect : world.effectTimes())
            effects.push_back({std::string(effect.name), effect.time_s});
    }

    /// {"scene","seed","simulated_s","wall_s","effects":[{"name","time_s"}],"measures":{...},"events":[...]},
    /// after "effects" with parts: "parts":[{"name","time_s"}], and before "measures" with a verdict:
    /// "verdict":{"result":"completed"} or {"result":"not_completed","phase","reason"[,"limit"],"expected"}
    [[nodiscard]] nlohmann::ordered_json toJson() const;
};

/// A number for a JSON document; what is not finite becomes null.
[[nodiscard]] nlohmann::ordered_json jsonNumber(double value);
/// The same for a number that may not be known: null.
[[nodiscard]] nlohmann::ordered_json orNull(const std::optional<double>& value);

/// Mean of values; NaN without any.
[[nodiscard]] double mean(const std::vector<double>& values);
/// Their quantile of that probability, 0 .. 1: linear between order statistics (type 7 of Hyndman and Fan);
/// NaN without any.
[[nodiscard]] double quantile(std::vector<double> values, double probability);
/// The measures contact_error_mean_m and contact_error_p95_m, the 95 % quantile; null without errors.
void reportContactErrors(const std::vector<double>& errors_m, nlohmann::ordered_json& measures);

/// Writes a JSON document as a file that appears when it is complete.
[[nodiscard]] core::Expected<void> writeJson(const std::string& path, const nlohmann::ordered_json& document);

} // namespace teleta::scene_run
