// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/methods/results/level_trials.h"
#include "backend/study/store/study_store.h"

#include <vector>

namespace teleta::study {

/// What a protocol says of a task with levels. Thread: any (pure).
[[nodiscard]] LevelTaskFacts levelTaskFacts(const Protocol& protocol, const StudyTask& task);

/// Adds the completed test trials with a level of a store, with what its protocol says of their tasks. Those
/// that the rules of the protocol, or rules made after the data, leave out are marked. Error: what the store
/// reports; refused for mixed modes. Thread: that of the store.
[[nodiscard]] core::Expected<void> addLevelTrials(const StudyStore& store, ModeFilter& modes,
                                                  LevelTrials& trials,
                                                  const std::vector<ExclusionRule>& after = {});

} // namespace teleta::study
