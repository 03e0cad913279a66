// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"
#include "backend/cost/cost_result.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::cost {

/// ladder,rung,parameter,error_mean,error_p95,error_max,error_unit,time_median_s,time_p99_s,samples,pareto
/// One row a rung; pareto: yes or no; NA: a refused time, an error that a rung does not have. time_p99_s is
/// over trials: of means where a trial puts many short calls together.
inline constexpr std::array<std::string_view, 11> kCostColumns{
    "ladder",     "rung",          "parameter",  "error_mean", "error_p95", "error_max",
    "error_unit", "time_median_s", "time_p99_s", "samples",    "pareto"};

/// Writes the rows, in order. writer: made with kCostColumns.
void writeCosts(std::span<const LadderCost> ladders, core::CsvWriter& writer);
/// The same into a file, which appears when it is complete. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeCostFile(std::span<const LadderCost> ladders,
                                                 const std::string& path);

/// Reads such a file; other columns may be there as well. Error: badInput with its place, ioFailed,
/// notFound.
[[nodiscard]] core::Expected<std::vector<LadderCost>> readCostFile(const std::string& path);

} // namespace teleta::cost
