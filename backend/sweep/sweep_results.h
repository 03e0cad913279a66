// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/sweep/sweep_plan.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::sweep {

/// A measure over the runs of a cell that have it.
struct CellMeasure {
    std::uint64_t n = 0;
    std::optional<double> mean, sd, median, p05, p95;
    /// 95 % interval of the mean: Wilson's for a share, otherwise Student's t.
    std::optional<double> low95, high95;
};

struct CellResult {
    std::uint64_t cell = 0;
    std::uint64_t runs = 0; ///< that have a row
    std::uint64_t failed = 0;
    double processor_s = 0.0;
    std::vector<CellMeasure> measures; ///< as SweepResults::measures
};

/// What a sweep has shown so far.
struct SweepResults {
    std::vector<std::string>
        measures;                  ///< in the order of the runs' first appearance, or as the plan names them
    std::vector<bool> shares;      ///< measures that are shares: see isShare()
    std::vector<CellResult> cells; ///< all of the plan
    std::uint64_t done = 0;
    std::uint64_t failed = 0;
    std::uint64_t all = 0;
};

/// A measure that is a share by its name, and whose values are none but from 0 to 1: "completed",
/// "significant", "refused", "stopped_without_bump", and names that end in "_covered" or "_share". A number
/// that merely is 0 or 1 in all runs, such as a time without contact, is none. Thread: any (pure).
[[nodiscard]] bool isShare(const std::string& measure, const std::vector<double>& values);

/// Statistics of values; quantiles of type 7 (Hyndman and Fan). Thread: any (pure).
[[nodiscard]] CellMeasure cellMeasure(const std::vector<double>& values, bool share);

/// Reads the parts of a folder. A run that is there twice counts once, as in the part of the lower number.
/// Error: ioFailed, badInput. Thread: any.
[[nodiscard]] core::Expected<SweepResults> readResults(const SweepPlan& plan, const std::string& folder);

/// Merges the parts of a folder into
///   runs.csv    run,cell,seed,KEYS,status,reason,MEASURES,wall_s,processor_s
///   cells.csv   cell,KEYS,measure,runs,failed,n,mean,sd,median,p05,p95,interval,low95,high95
/// sorted; but for the two times, the bytes do not depend on how the runs came into parts. A measure that no
/// run could determine has a column without values. Two that merge at once do no harm. frames: also
///   frames.csv  run,file
/// with the file that has the frames of each run. A writer that was ended between frames and rows leaves a
/// file of frames that is of no run, and two that did the same run two of them: these are not named, and once
/// every run is there, files that are not named are removed. Error: ioFailed, badInput. Thread: any.
[[nodiscard]] core::Expected<SweepResults> mergeParts(const SweepPlan& plan, const std::string& folder,
                                                      bool frames = false);

} // namespace teleta::sweep
