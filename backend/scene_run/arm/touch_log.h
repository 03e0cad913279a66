// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"
#include "backend/pipeline/touch/touch_record.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace teleta::scene_run {

/// One touch as it was estimated, and what the world knows of it.
struct ComparedTouch {
    pipeline::TouchRecord record;
    std::string object; ///< its name in the scene; empty: no object was touched
    double trueStiffness_NPerM = 0.0;
    Eigen::Vector3d p_Base_Truth_m = Eigen::Vector3d::Zero();
};

/// The columns of touches.csv.
[[nodiscard]] const std::vector<std::string>& touchColumns();

/// The touches as CSV; NA where nothing is known or observed.
[[nodiscard]] core::Expected<void> writeTouches(const std::string& path,
                                                const std::vector<ComparedTouch>& touches);

/// One touch as an event of the summary.
[[nodiscard]] nlohmann::ordered_json touchEvent(const ComparedTouch& touch);

} // namespace teleta::scene_run
