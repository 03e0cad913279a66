// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/proportion.h"

#include <cstdint>
#include <optional>
#include <span>

namespace teleta::study {

/// The 2 x 2 table of answers: "yes" with a signal and without; of two intervals "1" when it was 1 and when
/// it was 2; "different" when different and when the same.
struct DetectionCounts {
    std::int64_t hits = 0;
    std::int64_t signalTrials = 0; ///< trials with a signal
    std::int64_t falseAlarms = 0;
    std::int64_t noiseTrials = 0; ///< trials without
};

/// Sensitivity and criterion. Rates are log-linear, always: (count + 1/2) / (trials + 1).
struct Detection {
    double sensitivity = 0.0;         ///< d'
    std::optional<double> criterion;  ///< c; of two intervals the bias for "1"; empty where it has no meaning
    std::optional<Interval> interval; ///< of d', 95 %; empty where the method has none
    bool worseThanNothing = false;    ///< same-different with H <= F: d' is 0
};

/// Yes and no: d' = z(H) - z(F), c = -(z(H) + z(F)) / 2, d' +- 1.96 sd with
///   var = H (1-H) / (n phi(z(H))^2) + F (1-F) / (m phi(z(F))^2),  n and m trials as counted.
/// Empty without trials of one kind and for counts out of range. Thread: any. Sources: Hautus 1995,
/// doi:10.3758/BF03203619; Gourevitch and Galanter 1967, doi:10.1007/BF02289401; Macmillan and Creelman 2005,
/// Detection Theory, equations 1.5 and 2.1.
[[nodiscard]] std::optional<Detection> yesNoDetection(const DetectionCounts& counts);

/// Two intervals: d' and its interval are those of yesNoDetection() over sqrt 2. Otherwise the same.
[[nodiscard]] std::optional<Detection> twoIntervalDetection(const DetectionCounts& counts);

/// The d' of an observer without bias who is right with this share in m intervals:
///   share = integral phi(u - d') Phi(u)^(m-1) du.  Below 1/m it is negative.
/// Empty unless 0 < share < 1 and 2 <= intervals <= 100. Thread: any. Source: Green and Swets 1966, Signal
/// Detection Theory and Psychophysics.
[[nodiscard]] std::optional<double> intervalSensitivity(double share, int intervals);

/// The same of counts: share = (k + 1/m) / (n + 1); interval: Wilson's of the share, as d'. Empty without
/// trials and for counts out of range.
[[nodiscard]] std::optional<Detection> intervalDetection(std::int64_t correct, std::int64_t trials,
                                                         int intervals);

/// What a participant compares in a same-different trial.
enum class SameDifferentRule {
    differencing, ///< their difference with a limit: levels that roam from trial to trial
    independent,  ///< each with the criterion of a fixed pair
};

/// Same and different: of the rates H ("different" when different) and F ("different" when the same)
///   differencing: F = 2 Phi(-k / sqrt 2),  H = Phi((d'-k) / sqrt 2) + Phi((-d'-k) / sqrt 2)
///   independent:  d' = 2 z((1 + sqrt(2 Phi((z(H) - z(F)) / 2) - 1)) / 2)
/// 0 for H <= F. Empty unless both are within 0 .. 1, ends excluded. Thread: any. Source: Macmillan and
/// Creelman 2005, Detection Theory, chapter 9.
[[nodiscard]] std::optional<double> sameDifferentSensitivity(double hitRate, double falseAlarmRate,
                                                             SameDifferentRule rule);

/// The same of counts, with log-linear rates; no criterion, no interval.
[[nodiscard]] std::optional<Detection> sameDifferentDetection(const DetectionCounts& counts,
                                                              SameDifferentRule rule);

} // namespace teleta::study
