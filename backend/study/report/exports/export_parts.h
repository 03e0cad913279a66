// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/number_text.h"
#include "backend/study/store/study_store.h"
#include "backend/study/store/trial_table.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace teleta::study {

/// Cells of a table; an empty text is missing.
[[nodiscard]] inline TrialCell wordCell(const std::string& text) {
    return text.empty() ? TrialCell{} : TrialCell{TrialCell::Kind::text, text};
}
template <typename Number>
[[nodiscard]] TrialCell numberCell(Number value) {
    return {TrialCell::Kind::number, std::string(core::NumberText(value).view())};
}

/// Writes a file with its folders, by atomic replacement, reads it back and compares. Error: ioFailed.
/// Thread: any.
[[nodiscard]] core::Expected<void> writeChecked(const std::string& path, const std::string& content);

/// The letters A-Z, a-z and digits of a text: Psych-DS and BIDS reserve - and _.
[[nodiscard]] std::string alphanumeric(const std::string& text);

/// Alphanumeric names of texts for files, one each: where a text has other characters, or one before has the
/// name, x and its number are appended: of numbers, one per text, or else its place from 1. Later texts do
/// not change the names of earlier ones, and no two differ by case alone.
[[nodiscard]] std::vector<std::string> alphanumericLabels(const std::vector<std::string>& texts,
                                                          const std::vector<std::size_t>& numbers = {});

/// What both formats say about a session: task, condition, stimuli, times, seed.
[[nodiscard]] nlohmann::ordered_json sessionSidecar(const StudyHead& head, const PlannedSession& plan);

/// What both formats say about the published questionnaires of a study: words, language, source; an object
/// by id.
[[nodiscard]] nlohmann::ordered_json questionnaireSources(const Protocol& protocol);

/// The answers to a questionnaire, of a session or, with null, of the participant as a whole; none: it was
/// not filled in.
[[nodiscard]] std::vector<ItemAnswer> answersTo(const Questionnaire& questionnaire,
                                                const SessionRecord* session,
                                                const std::vector<StoredAnswer>& answers);

/// The scores of all published questionnaires of a study, from the stored answers:
/// participant_id,session_id,task,condition,questionnaire,score,value,n_missing. Empty: the study has no such
/// questionnaire. Error: what the store reports. Thread: that of the store.
[[nodiscard]] core::Expected<std::string> scoreText(const StudyStore& store);

} // namespace teleta::study
