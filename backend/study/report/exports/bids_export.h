// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"

#include <cstddef>

namespace teleta::study {

/// Writes a study as a BIDS dataset, always the whole of it, into DIR/bids:
///     dataset_description.json, README, participants.tsv and .json
///     sub-P07/sub-P07_sessions.tsv                        begin of each session
///     sub-P07/ses-shapestatic/beh/sub-P07_ses-shapestatic_task-shape_beh.tsv and .json, with the notes
///     phenotype/effort_shapestatic.tsv and .json          a questionnaire at one place of the plan
///     phenotype/person.tsv and .json                      one of the study as a whole
/// Each phenotype file has one row for every participant with a session. Files are replaced as a whole, read
/// back and compared. Returns the number of sessions. Error: ioFailed. Thread: that of the store.
/// Source: Brain Imaging Data Structure 1.8.0.
[[nodiscard]] core::Expected<std::size_t> exportBids(const StudyStore& store);

} // namespace teleta::study
