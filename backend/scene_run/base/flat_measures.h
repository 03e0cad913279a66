// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene_run/base/scene_summary.h"

#include <string>
#include <utility>
#include <vector>

namespace teleta::scene_run {

/// The measures of a run, each with a name of its own: "phases.align", "contact_error_m[2]". In the order of
/// the summary; what could not be determined is not there.
struct FlatMeasures {
    std::vector<std::pair<std::string, double>> numbers; ///< true and false are 1 and 0
    std::vector<std::pair<std::string, std::string>> texts;
};

/// Thread: any (pure).
[[nodiscard]] FlatMeasures flatMeasures(const nlohmann::ordered_json& measures);

} // namespace teleta::scene_run
