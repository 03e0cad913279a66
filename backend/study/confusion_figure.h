// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/study_results.h"

#include <string>
#include <vector>

namespace teleta::study {

/// A confusion matrix as an SVG picture in the layout of the paper's Tables 4-7: rows presented, columns
/// answered, each cell the share of its row in percent with one digit ("0" and "NA" without), the darker the
/// larger. The column NONE is there when it is needed. title: shown above. Thread: any.
[[nodiscard]] std::string confusionSvg(const ConfusionMatrix& matrix,
                                       const std::vector<std::string>& patterns, const std::string& title);

/// Writes the matrix of all participants of each task and condition, test phase, as
/// FOLDER/figures/confusion_TASK_CONDITION.svg; other characters than letters, digits, - and _ become _.
/// Error: ioFailed; refused when two would have the same name. Thread: any.
[[nodiscard]] core::Expected<void> writeFigures(const std::vector<TaskResults>& results,
                                                const std::string& folder);

} // namespace teleta::study
