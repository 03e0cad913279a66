// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/detection/signal_detection.h"
#include "backend/study/methods/results/level_trials.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// Sensitivity of one participant in a condition and track, over all its levels.
struct DetectionLine {
    std::string participant;
    std::string task;
    std::string condition;
    std::string track;
    std::int64_t hits = 0; ///< of intervals without a bias: right answers
    std::int64_t signalTrials = 0;
    std::optional<std::int64_t> falseAlarms; ///< empty: the method has none
    std::optional<std::int64_t> noiseTrials;
    std::optional<Detection> detection; ///< empty: no trials of one kind
    std::string method; ///< "yes/no", "2 intervals", "3 intervals", "differencing", "independent"
};

/// Mean of the participants' d' with its t interval.
struct DetectionGroup {
    std::string task;
    std::string condition;
    std::string track;
    std::size_t participants = 0; ///< with a d'
    std::optional<double> sensitivity;
    std::optional<Interval> interval;
};

struct DetectionResults {
    std::vector<DetectionLine> lines;
    std::vector<DetectionGroup> groups;

    [[nodiscard]] bool empty() const { return lines.empty(); }
};

/// Signal detection of yes_no, interval and same_different; comparisons and tables without a design have
/// none. Two intervals: H and F are the shares of "1" when it was 1 and when it was 2; where only right and
/// wrong is known, as of more intervals. same_different: independent judgements where the track has one
/// level, else differencing. Thread: any (pure).
[[nodiscard]] DetectionResults detectionResults(const LevelTrials& trials);

} // namespace teleta::study
