// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/trial_tally.h"
#include "backend/study/analysis/trials/exclusion_book.h"
#include "backend/study/store/study_store.h"

#include <functional>
#include <optional>
#include <string>

namespace teleta::study {

/// Which mode is counted. Modes are never mixed: the first trial decides unless the user does.
struct ModeFilter {
    std::optional<Mode> wanted; ///< the others are left out
    std::optional<Mode> seen;   ///< of the trials so far; unless `wanted` is set, another one is an error
};

/// Counts the completed trials of a trial CSV. Needed columns: participant_id, task, condition, phase,
/// stimulus, response. Optional columns: mode, outcome (aborted and device_error are left out; otherwise a
/// response NA, NONE or nothing is a timeout), response_time_s (NA: unknown), n_alternatives (how many
/// patterns the task has, whether they occur or not; NA: unknown), session_id, trial and attempt together,
/// and, for the rules of exclusions, device_faults, design, and excluded (the rule that left the row out; NA:
/// none). exclusions: takes the trials to which rules apply, see ExclusionBook. Memory: constant, except for
/// tally and exclusions. goOn: called regularly with the bytes read; false stops.
/// Error: badInput with file, line and column, notFound, ioFailed, cancelled; refused for mixed modes, for a
/// trial that was already counted, and for a participant whose data are also in a store. The tally is invalid
/// then. Thread: any.
[[nodiscard]] core::Expected<void> tallyCsv(const std::string& path, ModeFilter& modes, TrialTally& tally,
                                            ExclusionBook& exclusions,
                                            const std::function<bool(std::uint64_t bytes)>& goOn);
/// The same with the marks of the file alone: rows with a value in `excluded` are left out.
[[nodiscard]] core::Expected<void> tallyCsv(const std::string& path, ModeFilter& modes, TrialTally& tally,
                                            const std::function<bool(std::uint64_t bytes)>& goOn);

/// Counts the completed trials of a store; its protocol gives the patterns of the tasks and the
/// rules of exclusions. Error: what the
/// store reports; refused for mixed modes, and for a participant with trials elsewhere: another study may
/// have another person of that name. Thread: that of the store.
[[nodiscard]] core::Expected<void> tallyStore(const StudyStore& store, ModeFilter& modes, TrialTally& tally,
                                              ExclusionBook& exclusions);
/// The same with the rules of the protocol alone.
[[nodiscard]] core::Expected<void> tallyStore(const StudyStore& store, ModeFilter& modes, TrialTally& tally);

/// Calls exclusions.finish(). source: named in the error. Error: badInput, too many different patterns.
[[nodiscard]] core::Expected<void> settle(ExclusionBook& exclusions, TrialTally& tally,
                                          const std::string& source);

} // namespace teleta::study
