// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::study {

/// A stimulus at a level: what the level sets is set, and the pattern is felt on these tactors. Where the
/// pattern uses as many tactors as are named, its first becomes the first and so on, in the order in which it
/// names them; a pattern of one tactor is felt on all of them; of a pattern of more tactors only those named
/// are left. tactors: from 0; empty: as in the pattern. Error: refused when the pattern has not exactly one
/// object that has what varies, or objects that cannot be moved to these tactors. Thread: any (pure).
[[nodiscard]] core::Expected<pattern::Pattern> stimulusAt(const pattern::Pattern& stimulus, Vary vary,
                                                          double level,
                                                          const std::vector<std::size_t>& tactors);

/// What one interval of a trial has.
struct TrialInterval {
    double level = 0.0;
    std::vector<std::size_t> tactors; ///< from 0; empty: those of the stimulus
};

/// The intervals of a trial, in their order. trial: with track, level and target. Thread: any (pure).
[[nodiscard]] std::vector<TrialInterval> intervalsOf(const StudyTask& task, const std::string& condition,
                                                     const PlannedTrial& trial);

/// A trial as one pattern: its intervals one after the other, each interval_s long, with the task's gap
/// between them. Silent where a level is nothing. Error: as stimulusAt(), or refused when the stimulus is
/// longer than an interval. Thread: any (pure).
[[nodiscard]] core::Expected<pattern::Pattern> trialPattern(const StudyTask& task,
                                                            const std::string& condition,
                                                            const pattern::Pattern& stimulus,
                                                            double interval_s, const PlannedTrial& trial);

/// Length of the pattern of a trial.
[[nodiscard]] double trialLength_s(const StudyTask& task, double interval_s);

/// Whether every trial of the task can be made of this stimulus. Error: as trialPattern(), naming the file.
/// Thread: any (pure).
[[nodiscard]] core::Expected<void> checkStimulus(const Protocol& protocol, const StudyTask& task,
                                                 const pattern::Pattern& stimulus);

} // namespace teleta::study
