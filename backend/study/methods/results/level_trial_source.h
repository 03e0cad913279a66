// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/methods/results/level_trials.h"

#include <cstdint>
#include <functional>
#include <string>

namespace teleta::study {

/// Adds the completed test trials with a level of a trial CSV. Needed columns: participant_id, task,
/// condition, phase, level (NA: the row has none) and either stimulus and response or correct (0 or 1).
/// Optional: track (else "all"), design, level_unit, reference (0), procedure, n_alternatives, repetition,
/// mode, outcome, excluded (a value leaves the row out). isLeftOut: rows, from 0 below the header, that rules
/// leave out besides; empty: none. A file without the column `level` adds nothing. goOn
/// and memory: as tallyCsv(); each trial with a level is kept. Error: badInput with file, line and column,
/// notFound, ioFailed, cancelled; refused for mixed modes. Thread: any.
[[nodiscard]] core::Expected<void> addLevelTrials(const std::string& path, ModeFilter& modes,
                                                  LevelTrials& trials,
                                                  const std::function<bool(std::uint64_t bytes)>& goOn,
                                                  const std::function<bool(long long row)>& isLeftOut = {});

/// Whether a trial CSV has levels but no patterns, so that only addLevelTrials() can read it: `level` and
/// `correct` without `stimulus` or `response`. Error: as CsvReader::open(). Thread: any.
[[nodiscard]] core::Expected<bool> hasOnlyLevels(const std::string& path);

} // namespace teleta::study
