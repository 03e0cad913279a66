// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/store/study_store.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// The columns of a trial table in every export.
inline constexpr std::array<std::string_view, 48> kTrialColumns{
    // The session.
    "schema", "participant_id", "session_id", "mode", "task", "condition", "condition_position",
    "sequence_row",
    // The trial.
    "phase", "block", "trial", "trial_in_block", "repetition", "attempt", "stimulus", "response", "outcome",
    "correct", "response_time_s", "response_time_offset_s", "response_limit_s", "n_alternatives",
    "response_device", "response_key", "n_replays", "early_presses", "onset_s", "duration_s",
    "device_latency_ms", "device_faults",
    // How it was made.
    "feedback", "masking_noise", "time_utc", "seed", "order_method", "stimulus_set_sha256", "app_version",
    // Since schema 2: levels, exclusions, markers and recordings.
    "design", "track", "level", "level_unit", "reference", "procedure", "excluded", "trigger_ms", "recording",
    "recording_s",
    // Since schema 3.
    "device_latency_spread_ms"};

/// A value of a trial table.
struct TrialCell {
    enum class Kind { missing, number, text };
    Kind kind = Kind::missing;
    std::string text; ///< numbers in the C locale with the fewest digits that read back as the same
};

using TrialRow = std::vector<TrialCell>; ///< one a column

/// The rows of a session, including aborted trials and faults, in the order of storing. Times in s, positions
/// and rows from 1, `correct` 1 or 0 and missing for uncompleted trials, the seed as text. Thread: any.
[[nodiscard]] std::vector<TrialRow> trialRows(const StudyHead& head, const Participant& participant,
                                              const SessionRecord& session, const PlannedSession& plan,
                                              const std::vector<StoredTrial>& trials);

/// How a table is written.
struct TableFormat {
    char separator = ',';
    std::string missing = "NA";
    char decimal = '.';
    bool byteOrderMark = false;
    bool quotes = true; ///< as in RFC 4180; otherwise line ends and separators in a text become blanks
    /// For spreadsheets: texts that look like formulas, and numbers with more digits than a spreadsheet
    /// keeps, are prefixed with '.
    bool guarded = false;
};

/// The table as a text in UTF-8 with LF. Thread: any.
[[nodiscard]] std::string tableText(const std::vector<TrialRow>& rows, const TableFormat& format,
                                    std::span<const std::string_view> columns = kTrialColumns);

/// Columns of a table of answers to questionnaires.
inline constexpr std::array<std::string_view, 15> kAnswerColumns{
    "schema", "participant_id", "session_id", "mode",   "task",        "condition", "questionnaire", "when",
    "item",   "kind",           "question",   "answer", "answer_text", "time_utc",  "app_version"};

/// The answers of a participant in the order of storing; session, task and condition are missing for those of
/// the participant as a whole, answer and answer_text for items that were left out. answer_text is the text
/// of a choice. Thread: any.
[[nodiscard]] std::vector<TrialRow> answerRows(const StudyHead& head, const Participant& participant,
                                               const std::vector<SessionRecord>& sessions,
                                               const std::vector<StoredAnswer>& answers);

/// Columns of a table of the experimenter's notes.
inline constexpr std::array<std::string_view, 9> kNoteColumns{
    "schema", "participant_id", "session_id", "mode", "task", "condition", "note", "time_utc", "app_version"};

/// The notes of a session in the order of writing. Thread: any.
[[nodiscard]] std::vector<TrialRow> noteRows(const StudyHead& head, const Participant& participant,
                                             const SessionRecord& session, const PlannedSession& plan,
                                             const std::vector<StoredNote>& notes);

} // namespace teleta::study
