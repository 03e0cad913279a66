// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::study {

enum class Phase { practice, test };

/// How a trial ended. correct, incorrect and timeout complete it; after the others it is shown again.
enum class Outcome { correct, incorrect, timeout, aborted, deviceError };

/// What a study is for; data of different modes are never merged by default.
enum class Mode { run, pilot, simulated };

/// The words of the columns phase, outcome and mode.
[[nodiscard]] const char* toString(Phase phase);
[[nodiscard]] const char* toString(Outcome outcome);
[[nodiscard]] const char* toString(Mode mode);

/// The inverse; empty for any other word.
[[nodiscard]] std::optional<Phase> phaseOf(std::string_view word);
[[nodiscard]] std::optional<Outcome> outcomeOf(std::string_view word);
[[nodiscard]] std::optional<Mode> modeOf(std::string_view word);

/// A trial to be shown.
struct PlannedTrial {
    Phase phase = Phase::practice;
    std::size_t trial = 1;      ///< number in its phase, from 1; stays the same when it is shown again
    std::size_t repetition = 1; ///< occurrence of its pattern in the plan, from 1
    std::size_t attempt = 1;    ///< from 1; more after device faults and interruptions
    std::size_t stimulus = 0;   ///< index of the pattern, or of the right answer
    // Of trials with a level.
    std::string track = {};                 ///< empty: none
    std::optional<double> level = {};       ///< in the unit of what the task varies
    std::optional<std::size_t> target = {}; ///< which intervals have the level, see trialPattern()
};

/// A trial that was shown, and its result.
struct TrialResult {
    PlannedTrial planned;
    std::size_t trialInBlock = 1; ///< number of trials shown in the phase so far, from 1
    std::optional<std::size_t> response;
    Outcome outcome = Outcome::timeout;
    std::optional<double> responseTime_s;       ///< from the onset of the stimulus; empty without an answer
    std::optional<double> responseTimeOffset_s; ///< from its end, below 0 when answered before
    std::string responseDevice;                 ///< mouse, touch, keyboard, keypad, simulated; empty: none
    std::string responseKey;                    ///< physical key or button; empty: none
    std::size_t replays = 0;
    std::size_t earlyPresses = 0;
    double onset_s = 0.0;                   ///< since the session began; of the last replay
    double duration_s = 0.0;                ///< of the stimulus
    std::optional<double> deviceLatency_ms; ///< from the request to the stimulus
    std::size_t deviceFaults = 0;
    std::optional<double> frameWrite_ms;     ///< longest write of a frame of the stimulus; empty: unknown
    std::optional<std::size_t> framesMissed; ///< deadlines without a frame, and frames that were lost
    std::optional<double> trigger_ms;        ///< from the onset to the marker that was written; empty: none
    std::string recording;                   ///< file of the recording that has the trial; empty: none
    std::optional<double> recording_s;       ///< its onset on the recording's clock
    std::optional<double> latencySpread_ms;  ///< of the bracelet's measured latency; empty: not measured

    [[nodiscard]] bool isComplete() const {
        return outcome != Outcome::aborted && outcome != Outcome::deviceError;
    }
};

} // namespace teleta::study
