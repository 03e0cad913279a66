// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/adaptive/procedure_settings.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// What a trial asks.
enum class Design {
    identification, ///< which of several patterns was it?
    yesNo,          ///< was it there?
    interval,       ///< in which of two to four intervals was it?
    sameDifferent,  ///< were the two intervals the same?
    compare,        ///< which of two intervals had more?
};

/// What a level sets.
enum class Vary {
    intensity, ///< factor of all intensities, 0..1
    onset,     ///< onset_s of the only sweep
    burst,     ///< burst_s of the only sweep or ring, or the width of the only pulse train
    duration,  ///< duration_s of the only ring, phantom, ramp or pulse train
    balance,   ///< of the only phantom, 0..1
};

/// Words of the files: identification, yes_no, interval, same_different, compare.
[[nodiscard]] const char* toString(Design design);
/// intensity, onset_s, burst_s, duration_s, balance.
[[nodiscard]] const char* toString(Vary vary);
/// Unit of a level in tables: drive, s, balance.
[[nodiscard]] const char* unitOf(Vary vary);

/// One of several series of trials that are interleaved, each with levels of its own.
struct LevelTrack {
    std::string id;
    std::vector<std::size_t> tactors = {};   ///< 0..5; empty: those of the stimulus
    std::vector<std::size_t> reference = {}; ///< where the reference is felt; empty: the same
};

/// The most tracks of a task.
inline constexpr std::size_t kMostTracks = 12;
/// The most intervals of Design::interval: each is answered by one digit.
inline constexpr std::size_t kMostIntervals = 4;

/// What a task of any design but identification asks about: one stimulus at many levels. Levels are in the
/// unit of what varies.
struct LevelTask {
    std::string question;      ///< what the participant reads; empty: the usual one of the design
    std::size_t intervals = 2; ///< of Design::interval
    double gap_s = 0.5;        ///< between two intervals
    double catchShare = 0.0;   ///< of Design::yesNo: share of the trials that have the reference
    std::vector<LevelTrack> tracks;
    std::string file; ///< of the stimulus
    Vary vary = Vary::intensity;
    LevelRange range = {LevelScale::linear, 0.0, 1.0};
    double reference = 0.0;              ///< to compare with; 0: nothing, or a time or balance of 0
    std::vector<double> values;          ///< of constant stimuli, rising
    std::optional<double> practiceLevel; ///< empty: the highest
    /// The constant procedure has its levels in `values` and its repetitions in the protocol, and the guess
    /// rates of the Bayesian one follow from the design, see procedureOf().
    Procedure procedure = ConstantSettings();
};

/// The answers of a design, as rows have them: yes, no; 1 .. 4; same, different; 1, 2. Empty for
/// identification. intervals: of Design::interval.
[[nodiscard]] std::vector<std::string> answersOf(Design design, std::size_t intervals);

/// Intervals of a trial: one after the other, with gaps.
[[nodiscard]] std::size_t intervalsOf(Design design, const LevelTask& task);

/// The settings with which a track's levels are chosen: the task's, completed by what the design and the
/// protocol say. repetitions, blocked: of constant stimuli. Thread: any (pure).
[[nodiscard]] Procedure procedureOf(Design design, const LevelTask& task, std::size_t repetitions,
                                    bool blocked);

} // namespace teleta::study
