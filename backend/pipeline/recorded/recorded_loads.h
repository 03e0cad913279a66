// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/json_document.h"
#include "backend/core/data/taxel_layout.h"
#include "backend/equilibration/load_calibration.h"
#include "backend/pipeline/touch/frame_loads.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace teleta::pipeline {

// How the calibration that gives the loads of an array, or of a flat gel, is recorded: in the details of its
// stream, as
//   "loads": {"names": [..], "signals": [..], "gain": [[a row a load]], "gain_se": [[..]],
//             "rest": [..], "least": [..], "greatest": [..], "scatter": [..]}
// so that whoever has the frames has their loads as well, with a tare of their own. Thread: any (pure).

[[nodiscard]] nlohmann::ordered_json loadsJson(const equilibration::LoadCalibration& calibration);

/// A calibration in these details, of these known signals; nothing: as readLoads().
[[nodiscard]] std::optional<equilibration::LoadCalibration>
readCalibration(core::JsonReader& reader, const nlohmann::ordered_json& details,
                const std::vector<std::string>& known);

/// The calibration of these details, for the array that they describe; nothing: they have none, or the reader
/// has an error: a member is missing or has another type; a load is not of equilibration::kLoadColumns, or a
/// signal not of the array; one of either is listed twice; a list is not one number a load or a signal; a
/// number is beyond 1e12 in magnitude, or a gain_se or scatter below 0; least is above greatest.
[[nodiscard]] std::optional<FrameLoads> readLoads(core::JsonReader& reader,
                                                  const nlohmann::ordered_json& details,
                                                  const core::TaxelLayout& layout,
                                                  const std::string& loadUnit);

} // namespace teleta::pipeline
