// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/comparison/paired_comparison.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::study {

/// Response times of one participant under one condition: right answers, test phase.
struct ParticipantTimes {
    std::string participant;
    std::string condition;
    std::size_t n = 0;
    std::optional<double> geometricMean_s; ///< empty without times and where one is not above 0
    std::optional<double> median_s;
};

/// Two conditions, compared by the participants' mean logarithms.
struct TimePair {
    std::string first;
    std::string second;
    PairedComparison logs;       ///< of the mean natural logarithms
    std::optional<double> pHolm; ///< over all pairs of conditions of the task

    /// How many times as long the first takes: exp of the mean difference.
    [[nodiscard]] std::optional<double> ratio() const;
    [[nodiscard]] std::optional<Interval> ratioInterval() const;
};

struct TimeComparisons {
    std::vector<ParticipantTimes> participants;
    std::vector<TimePair> pairs;
};

/// exp of the mean logarithm. Empty without values and where one is not above 0. Thread: any.
[[nodiscard]] std::optional<double> geometricMean(std::span<const double> values);

/// Response times of a task. Trials without an answer have no time. Thread: any.
[[nodiscard]] TimeComparisons timeComparisons(const TaskResults& task);

} // namespace teleta::study
