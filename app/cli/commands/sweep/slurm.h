// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace teleta::cli {

/// An array of tasks of a sweep for Slurm.
struct SlurmJob {
    std::string program;   ///< path of teleta, the same on each node
    std::string sweepFile; ///< absolute
    std::string folder;    ///< absolute, shared by the nodes
    bool frames = false;
    double allowFailed = 0.0; ///< share of the runs that may fail before merging is an error
    std::uint64_t tasks = 1;
    std::vector<std::string> options; ///< of sbatch, "--partition=short"
};

/// The content of job.sh. Thread: any (pure).
[[nodiscard]] std::string slurmScript(const SlurmJob& job);

struct SubmittedJob {
    std::string array; ///< ids as Slurm has them
    std::string merge;
};

/// Writes job.sh into the folder, and submits it and the job that merges its results. Error: notFound without
/// Slurm, refused with Slurm's own words, ioFailed.
[[nodiscard]] core::Expected<SubmittedJob> submitToSlurm(const SlurmJob& job);

/// Tasks that Slurm still knows as waiting or running, of these jobs; 0 when it has forgotten them. Error: as
/// submitToSlurm().
[[nodiscard]] core::Expected<std::uint64_t> tasksInSlurm(const std::vector<std::string>& jobs);

} // namespace teleta::cli
