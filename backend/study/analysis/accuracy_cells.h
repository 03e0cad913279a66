// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/repeated_anova.h"
#include "backend/study/analysis/study_results.h"

#include <cstddef>
#include <string>
#include <vector>

namespace teleta::study {

/// Shares of right answers in the cells of a task's ANOVA, test phase.
struct AccuracyCells {
    std::vector<std::string> people;     ///< rows, sorted
    std::vector<std::string> conditions; ///< with test trials, in the order of the groups
    std::vector<std::size_t> patterns;   ///< those presented, as indices in TaskResults::patterns
    /// Row per participant; condition i, pattern j in column i * patterns.size() + j. NaN: not presented.
    ParticipantCells cells;

    /// The columns of one pattern, one per condition. pattern: index in `patterns`.
    [[nodiscard]] ParticipantCells ofPattern(std::size_t pattern) const;
};

/// The cells of a task; needs its participants and groups alone. Thread: any.
[[nodiscard]] AccuracyCells accuracyCells(const TaskResults& task);

} // namespace teleta::study
