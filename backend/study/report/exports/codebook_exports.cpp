// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/codebook.h"

#include <array>

namespace teleta::study {

namespace {

constexpr char kModes[] = "run: people; pilot: a trial of the study; simulated: a rehearsal";
constexpr char kSchema[] = "Version of the columns";
constexpr char kVersion[] = "Version of the program";
constexpr char kYesNo[] = "1: yes; 0: no";
constexpr char kOfWhole[] = "of the participant as a whole";

constexpr std::array kTrials{
    CodebookRow{"schema", kSchema},
    CodebookRow{"participant_id", "Participant"},
    CodebookRow{"session_id", "Session: UTC of its begin"},
    CodebookRow{"mode", "What the data are", "", kModes},
    CodebookRow{"task", "Task"},
    CodebookRow{"condition", "Condition of the session"},
    CodebookRow{"condition_position",
                "Place of the condition in the participant's order of this task, from 1"},
    CodebookRow{"sequence_row", "Row of the Williams square that gave that order, from 1"},
    CodebookRow{"phase", "Part of the session", "", "practice: before the test; test: counts"},
    CodebookRow{"block", "Number of the part", "", "1: practice; 2: test"},
    CodebookRow{"trial", "Number of the trial in its phase, from 1; the same when it is shown again"},
    CodebookRow{"trial_in_block", "Number of trials shown in the phase so far, from 1"},
    CodebookRow{"repetition", "How often this stimulus was planned so far, from 1"},
    CodebookRow{"attempt", "From 1; more after device faults and interruptions"},
    CodebookRow{"stimulus", "What was presented: the right answer"},
    CodebookRow{"response", "What was answered", "", "", "no answer in time, or the trial was not completed"},
    CodebookRow{
        "outcome", "How the trial ended", "",
        "correct: right in time; incorrect: wrong in time; timeout: no answer in time; aborted: ended by "
        "the experimenter; device_error: the stimulus was not presented as it should"},
    CodebookRow{"correct", "Whether the answer was right; a timeout counts as wrong", "", kYesNo,
                "the trial was not completed"},
    CodebookRow{"response_time_s", "From the onset of the stimulus to the answer", "s", "", "no answer"},
    CodebookRow{"response_time_offset_s",
                "From the end of the stimulus to the answer; below 0 when answered before", "s", "",
                "no answer"},
    CodebookRow{"response_limit_s", "Time to answer", "s"},
    CodebookRow{"n_alternatives", "Number of possible answers"},
    CodebookRow{"response_device", "With what the answer was given", "",
                "mouse; touch; keyboard; keypad; simulated", "no answer"},
    CodebookRow{"response_key", "Physical key or button", "", "", "no answer"},
    CodebookRow{"n_replays", "How often the stimulus was felt again"},
    CodebookRow{"early_presses", "Presses before answers were accepted"},
    CodebookRow{"onset_s", "Onset of the stimulus since the session began; of the last replay", "s"},
    CodebookRow{"duration_s", "Length of the stimulus", "s"},
    CodebookRow{"device_latency_ms",
                "From the request to the onset: the confirmed write, plus the latency_ms in the file of a "
                "sound bracelet",
                "ms", "", "not known"},
    CodebookRow{"device_faults", "Faults of the bracelet during the trial"},
    CodebookRow{"feedback", "Whether the right answer was shown after the trial", "", kYesNo},
    CodebookRow{"masking_noise", "Noise in the headphones, with its level as set by the experimenter"},
    CodebookRow{"time_utc", "End of the trial, UTC"},
    CodebookRow{"seed", "Seed of the session"},
    CodebookRow{"order_method", "How the order of the trials was drawn", "",
                "full_random: all together; blocked_random: each repetition by itself"},
    CodebookRow{"stimulus_set_sha256", "SHA-256 of all stimuli", "", "", "an early version of the program"},
    CodebookRow{"app_version", kVersion},
    CodebookRow{
        "design", "What participants do", "",
        "identification: name the pattern; yes_no; interval: say in which interval it was; same_different; "
        "compare: say in which interval there was more"},
    CodebookRow{"track", "Track of trials to which this one belongs", "", "", "the design has none"},
    CodebookRow{"level", "Level that was presented, in level_unit", "", "", "the design has none"},
    CodebookRow{"level_unit", "What the level sets", "", "", "the design has none"},
    CodebookRow{"reference", "Level of the other intervals; 0: nothing", "", "", "the design has none"},
    CodebookRow{"procedure", "How levels are chosen", "", "constant; staircase; bayes",
                "the design has none"},
    CodebookRow{"excluded", "Id of the rule that excluded the trial", "", "", "not excluded"},
    CodebookRow{"trigger_ms", "From the confirmed onset until the trigger was written", "ms", "",
                "no trigger was written"},
    CodebookRow{"recording", "File with the recorded streams of the session", "", "", "not recorded"},
    CodebookRow{"recording_s", "Onset of the stimulus on the recording's clock", "s", "", "not recorded"},
    CodebookRow{
        "device_latency_spread_ms",
        "How much the measured latency_ms of a sound bracelet varies, from the shortest to the longest", "ms",
        "", "not measured"},
};

constexpr std::array kQuestionnaire{
    CodebookRow{"schema", kSchema},
    CodebookRow{"participant_id", "Participant"},
    CodebookRow{"session_id", "Session: UTC of its begin", "", "", kOfWhole},
    CodebookRow{"mode", "What the data are", "", kModes},
    CodebookRow{"task", "Task of the session", "", "", kOfWhole},
    CodebookRow{"condition", "Condition of the session", "", "", kOfWhole},
    CodebookRow{"questionnaire", "Questionnaire"},
    CodebookRow{"when", "When it was filled in", "",
                "before_study; before_session; after_session; after_study"},
    CodebookRow{"item", "Item of the questionnaire"},
    CodebookRow{"kind", "How the item is answered", "",
                "text: own words; likert: a point of a scale; choice: one of several; scale: 0 to 100 in "
                "steps of 5; pair: one of two"},
    CodebookRow{"question", "Text of the item, as it was shown"},
    CodebookRow{"answer", "The text, the point, or the id of the choice", "", "", "left out"},
    CodebookRow{"answer_text", "The answer as it was shown", "", "", "left out"},
    CodebookRow{"time_utc", "When the questionnaire was handed in, UTC"},
    CodebookRow{"app_version", kVersion},
};

constexpr std::array kScores{
    CodebookRow{"participant_id", "Participant"},
    CodebookRow{"session_id", "Session: UTC of its begin", "", "", kOfWhole},
    CodebookRow{"task", "Task of the session", "", "", kOfWhole},
    CodebookRow{"condition", "Condition of the session", "", "", kOfWhole},
    CodebookRow{"questionnaire", "Questionnaire"},
    CodebookRow{"score", "Which score", "",
                "tlx_raw: mean of six ratings; tlx_weighted: mean weighted by 15 comparisons; sus: System "
                "Usability Scale"},
    CodebookRow{"value", "The score, 0 to 100", "", "", "an item that it needs was left out"},
    CodebookRow{"n_missing", "Items of the score that were left out"},
};

constexpr std::array kNotes{
    CodebookRow{"schema", kSchema},
    CodebookRow{"participant_id", "Participant"},
    CodebookRow{"session_id", "Session: UTC of its begin"},
    CodebookRow{"mode", "What the data are", "", kModes},
    CodebookRow{"task", "Task of the session"},
    CodebookRow{"condition", "Condition of the session"},
    CodebookRow{"note", "What the experimenter wrote down"},
    CodebookRow{"time_utc", "When it was written, UTC"},
    CodebookRow{"app_version", kVersion},
};

constexpr std::array kCodebook{
    CodebookRow{"file", "File, or kind of table: trials, questionnaire, notes, phenotype"},
    CodebookRow{"column", "Column of that file"},
    CodebookRow{"description", "What the column holds"},
    CodebookRow{"unit", "Unit of its numbers", "", "", "none"},
    CodebookRow{"levels", "The words that it may hold, and what they mean", "", "", "no fixed words"},
    CodebookRow{"missing", "What a missing value means", "", "", "there is always a value"},
};

constexpr std::array kParticipants{
    CodebookRow{"participant_id", "Participant: sub- and a label for file names"},
    CodebookRow{"study_id", "Id of the participant in the study"},
    CodebookRow{"enrolment", "Number in the order of enrolment, from 1"},
    CodebookRow{"mode", "What the data are", "", kModes},
};

constexpr std::array kSessions{
    CodebookRow{"session_id", "Session: ses- and a label of its task and condition"},
    CodebookRow{"acq_time", "Begin of the session, UTC"},
};

constexpr std::array kPhenotype{
    CodebookRow{"participant_id", "Participant, as in participants.tsv"},
    CodebookRow{"session_id", "Session, as in the names of files", "", "", kOfWhole},
};

constexpr std::array kExportTables{
    CodebookFile{"trials", kTrials},
    CodebookFile{"questionnaire", kQuestionnaire},
    CodebookFile{"questionnaire_scores.csv", kScores},
    CodebookFile{"notes", kNotes},
    CodebookFile{"codebook.csv", kCodebook},
    CodebookFile{"participants.tsv", kParticipants},
    CodebookFile{"sessions.tsv", kSessions},
    CodebookFile{"phenotype", kPhenotype},
};

} // namespace

std::span<const CodebookFile> codebookOfExports() {
    return kExportTables;
}

} // namespace teleta::study
