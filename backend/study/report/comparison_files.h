// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/study_results.h"

#include <string>
#include <vector>

namespace teleta::study {

/// Writes comparisons.csv, ranks.csv, binomial_model.csv and response_times.csv into a folder, which exists.
/// Missing values are NA; the column note says why. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeComparisons(const std::vector<TaskResults>& results,
                                                    const std::string& folder);

} // namespace teleta::study
