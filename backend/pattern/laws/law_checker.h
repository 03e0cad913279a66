// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teleta::pattern {

enum class Law {
    burstTooShort,  ///< shorter than the motor needs to rise; value, limit: s
    ringTooFast,    ///< a turn under kShortestTurn_s; value, limit: s
    onsetOffLaw,    ///< more than kOnsetTolerance from apparentMotionOnset_s; value, limit: s
    sharedPhantoms, ///< two phantoms or strokes on one motor at one time; value: number of the other object
    beating,        ///< two motors so near in speed that they beat; value: difference, limit: band, Hz
    cutOff,         ///< goes on behind the end of the pattern; value: end, limit: duration, s
};

/// "burst-too-short" ...: stable, for files and programs.
[[nodiscard]] const char* toString(Law law);

/// Onsets this share off the law of apparent motion still count as lawful.
inline constexpr double kOnsetTolerance = 0.1;
/// Speeds nearer than this beat; a finding needs a whole period of the beat.
inline constexpr double kBeatBand_Hz = 10.0;
inline constexpr std::size_t kMostFindings = 1000;

/// One place where a pattern breaks a law.
struct Finding {
    Law law = Law::burstTooShort;
    std::optional<std::size_t> object; ///< number of the object; empty: the tracks
    std::vector<int> tactors;
    Span span;
    double value = 0.0;
    double limit = 0.0;
    /// What fixed() sets: a length, turns, a start, a duration, or of a beat the factor by which the
    /// intensity of one motor is to fall.
    std::optional<double> suggestion;
    bool suggestsTurns = false; ///< of a ring
    int weaker = -1;            ///< of a beat: the motor whose intensity is to fall
};

/// Looks where a pattern breaks the laws, objects in their order, then tracks, then pairs of motors; at most
/// kMostFindings. motors: valid(). cancelled: when it becomes true the answer is cut short.
/// Thread: any (pure).
[[nodiscard]] std::vector<Finding> checkLaws(const Pattern& pattern, const MotorProfiles& motors,
                                             const std::atomic<bool>* cancelled = nullptr);

/// The pattern with the suggestion of one finding carried out; empty when there is none to carry out.
[[nodiscard]] std::optional<Pattern> fixed(const Pattern& pattern, const Finding& finding);

/// What is wrong, a sentence; translated.
[[nodiscard]] std::string describe(const Finding& finding);
/// What to do about it, a sentence; translated.
[[nodiscard]] std::string describeFix(const Finding& finding);

} // namespace teleta::pattern
