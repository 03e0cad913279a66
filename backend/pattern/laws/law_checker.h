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
    burstTooShort,  ///< shorter than the rise time of the motor; value, limit: s
    ringTooFast,    ///< a turn takes less than kShortestTurn_s; value, limit: s
    onsetOffLaw,    ///< differs by more than kOnsetTolerance from apparentMotionOnset_s(); value, limit: s
    sharedPhantoms, ///< two phantoms or strokes on one motor at the same time; value: index of the other
                    ///< object
    beating,        ///< two motors with almost equal speeds beat; value: difference, limit: band, Hz
    cutOff,         ///< continues beyond the end of the pattern; value: end, limit: duration, s
};

/// Stable name for files and programs: "burst-too-short", ...
[[nodiscard]] const char* toString(Law law);

/// Relative deviation from the law of apparent motion that is still accepted.
inline constexpr double kOnsetTolerance = 0.1;
/// Speeds closer together than this beat; a finding needs a whole period of the beat.
inline constexpr double kBeatBand_Hz = 10.0;
inline constexpr std::size_t kMostFindings = 1000;

/// One place where a pattern breaks a law.
struct Finding {
    Law law = Law::burstTooShort;
    std::optional<std::size_t> object; ///< index of the object; empty: the tracks
    std::vector<int> tactors;
    Span span;
    double value = 0.0;
    double limit = 0.0;
    /// The value that fixed() sets: a length, turns, a start, a duration, or for a beat the factor by which
    /// the intensity of one motor is multiplied.
    std::optional<double> suggestion;
    bool suggestsTurns = false; ///< for a ring: the suggestion is a number of turns
    int weaker = -1;            ///< for a beat: the motor whose intensity is reduced
};

/// Finds where a pattern breaks the laws: first the objects in their order, then the tracks, then pairs of
/// motors; at most kMostFindings. motors: valid(). cancelled: when it becomes true, the result is incomplete.
/// Thread: any (pure).
[[nodiscard]] std::vector<Finding> checkLaws(const Pattern& pattern, const MotorProfiles& motors,
                                             const std::atomic<bool>* cancelled = nullptr);

/// Applies the suggestion of a finding; empty when it has none.
[[nodiscard]] std::optional<Pattern> fixed(const Pattern& pattern, const Finding& finding);

/// A translated sentence that says what is wrong.
[[nodiscard]] std::string describe(const Finding& finding);
/// A translated sentence that says what to do about it.
[[nodiscard]] std::string describeFix(const Finding& finding);

} // namespace teleta::pattern
