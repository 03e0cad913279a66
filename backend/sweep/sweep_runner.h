// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/sweep/sweep_plan.h"
#include "backend/sweep/sweep_subject.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace teleta::sweep {

/// A cell of which more runs failed, or whose mean is worse, than that of the others.
struct WorstCell {
    std::uint64_t cell = 0;
    std::uint64_t runs = 0;
    std::uint64_t failed = 0;
    std::optional<double> mean; ///< of the measure
};

/// How far a sweep has come.
struct SweepProgress {
    std::uint64_t done = 0; ///< runs of this call, and those that had been done before it
    std::uint64_t all = 0;
    std::uint64_t failed = 0; ///< of this call
    double wall_s = 0.0;      ///< of this call
    double left_s = 0.0;      ///< at the pace of this call; NaN: not known yet
    std::string measure;      ///< the plan's first one, otherwise the first of a run
    /// Of this call, five at most: those with the largest share of failed runs, then those with the largest
    /// mean of the measure, or the smallest of "completed", "significant" and names that end in "_covered".
    std::vector<WorstCell> worst;
};

struct SweepOptions {
    std::string folder;      ///< of the sweep
    std::size_t workers = 0; ///< 0: as many as the machine has cores, but one for a ladder, which is timed
    /// This call's share of the runs: all whose number is in [first, end).
    std::uint64_t first = 0;
    std::uint64_t end = kMostRuns;
    bool frames = false; ///< tactile frames with their truth go to frames/NNNN.npz
    /// Called a few times a second on the calling thread; false lets the runs that are under way end, and
    /// then the sweep.
    std::function<bool(const SweepProgress& progress)> goOn;
};

struct SweepOutcome {
    std::uint64_t done = 0; ///< as in SweepProgress
    std::uint64_t all = 0;
    std::uint64_t failed = 0;
    bool interrupted = false;
};

/// Runs what has no row in the folder's parts yet, on threads of its own; a run that fails is a row with its
/// reason. Error: ioFailed where results cannot be written, badInput when the first run has none of a measure
/// that the plan names: nothing is lost in both cases. Thread: any.
[[nodiscard]] core::Expected<SweepOutcome> runSweep(const SweepPlan& plan, const SweepSubject& subject,
                                                    const SweepOptions& options);

} // namespace teleta::sweep
