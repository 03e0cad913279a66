// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/sweep/sweep_plan.h"
#include "backend/sweep/sweep_results.h"

#include <string>

namespace teleta::sweep {

/// What a folder holds besides its results: sweep.json with the texts of the sweep and of what it runs,
/// version and machine, and how to repeat it.
struct SweepFolder {
    std::string folder;
    std::string source;  ///< texts of what it runs
    std::string version; ///< of the program
    bool frames = false;

    /// Makes the folder for a plan, or checks that it is one of this plan. restart: throws away what is
    /// there, if it is a sweep's. Error: refused with the first line that differs, or for another version, or
    /// when the folder holds something else; ioFailed.
    [[nodiscard]] core::Expected<void> open(const SweepPlan& plan, bool restart) const;

    /// Merges what there is: runs.csv, cells.csv, with frames frames.csv, figures/ and sweep.json. Error: as
    /// mergeParts().
    [[nodiscard]] core::Expected<SweepResults> merge(const SweepPlan& plan) const;

    /// A folder as its sweep.json describes it. Error: notFound without one, badInput, ioFailed.
    [[nodiscard]] static core::Expected<SweepFolder> read(const std::string& folder, SweepPlan& plan);
};

} // namespace teleta::sweep
