// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/exclusion_book.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// What rules have left out, and the results that there would be without them.
struct ExclusionReport {
    std::vector<ExclusionLine> lines;      ///< empty: no rules
    std::vector<TaskResults> withoutRules; ///< of all trials
};

/// From a finished book. Thread: any.
[[nodiscard]] ExclusionReport exclusionReport(const ExclusionBook& book);

/// One result with the rules, and the same without them.
struct ComparedResult {
    std::string task;
    std::string name;               ///< a condition, or an effect
    std::optional<double> accuracy; ///< of conditions: the group's mean share
    std::optional<double> accuracyWithout;
    std::optional<double> p; ///< of effects, corrected by Greenhouse and Geisser
    std::optional<double> pWithout;
};

/// Conditions and effects of all tasks that there are without the rules. Thread: any.
[[nodiscard]] std::vector<ComparedResult> comparedResults(const std::vector<TaskResults>& results,
                                                          const std::vector<TaskResults>& withoutRules);

} // namespace teleta::study
