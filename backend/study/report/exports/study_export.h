// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::study {

/// psychds  DIR/data/subject-P07/subject-P07_session-20261103T142233_task-shape_data.csv, a .json beside
///          each, DIR/dataset_description.json, DIR/codebook.csv and DIR/analysis.R; comma, NA.
/// bids     DIR/bids, a whole dataset, see exportBids(); tab, n/a.
/// excel    DIR/excel/P07_20261103T142233_shape.csv; semicolon, decimal sign of the locale, byte order mark;
///          texts like formulas and numbers of more than 15 digits have ' before them.
/// Answers to questionnaires, one file per participant with answers:
///          DIR/data/subject-P07/subject-P07_description-questionnaire_data.csv with its .json,
///          DIR/excel/P07_questionnaire.csv; scores of published ones in DIR/questionnaire_scores.csv.
/// The experimenter's notes likewise, with "notes" in place of "questionnaire".
enum class ExportFormat { psychds, bids, excel };

/// Participants in file names: the letters A-Z, a-z and digits of the id; if the id has other characters, or
/// an earlier participant has that name, x and the number of enrolment are appended. So nobody's files are
/// renamed when more people enrol. One per participant, in order of enrolment. Thread: any.
[[nodiscard]] std::vector<std::string> fileLabels(const std::vector<Participant>& participants);

/// Exports all sessions of a study into its folder. Files are replaced as a whole, read back and compared.
/// Returns the number of sessions. Error: ioFailed, also when the comparison fails. Thread: that of the
/// store.
[[nodiscard]] core::Expected<std::size_t> exportStudy(const StudyStore& store, ExportFormat format);
/// Exports one session as Psych-DS, with the answers and notes of its participant. Errors as above.
[[nodiscard]] core::Expected<void> exportSession(const StudyStore& store, const Participant& participant,
                                                 const SessionRecord& session);
/// The answers, or notes, of a participant alone.
[[nodiscard]] core::Expected<void> exportAnswers(const StudyStore& store, const Participant& participant);
[[nodiscard]] core::Expected<void> exportNotes(const StudyStore& store, const Participant& participant);

/// The R script that analyses a study again, from the exported trials or from confusion_long.csv, and writes
/// summary_r.csv and anova_r.csv; the resource :/studies/analysis.R. Error: notFound. Thread: any.
[[nodiscard]] core::Expected<std::string> analysisScript();

} // namespace teleta::study
