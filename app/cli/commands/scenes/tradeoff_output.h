// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/cost/ladder.h"
#include "backend/cost/measurer.h"

#include <span>
#include <string>

namespace teleta::cli {

/// Makes the folder for writeTradeoff(). Error: ioFailed.
[[nodiscard]] core::Expected<void> makeTradeoffFolder(const std::string& folder);

/// tradeoff.csv (cost_file.h), and LADDER.svg of each ladder (cost_figure.h). Error: ioFailed.
[[nodiscard]] core::Expected<void> writeTradeoff(const cost::Measurement& measured,
                                                 std::span<const cost::Ladder> ladders,
                                                 const std::string& folder);

/// On standard output: one JSON document, {"wall_s","interrupted","ladders":[{"ladder","name","error_unit",
/// "rungs":[{"rung","parameter","error_mean",..,"spread","pareto"}]}]}; or a table a ladder, for a terminal
/// and when the CSV is in a file; or the CSV.
[[nodiscard]] core::Expected<void> printTradeoff(const cost::Measurement& measured,
                                                 std::span<const cost::Ladder> ladders, bool json,
                                                 bool inFile);

} // namespace teleta::cli
