// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/figure/svg_canvas.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/protocol/trial.h"

#include <QString>

#include <optional>

namespace teleta::study {

/// Part of a report about one task: pairs with effect sizes, ranks, the binomial model. Empty without
/// anything to compare. Thread: any.
[[nodiscard]] QString comparisonSection(const TaskResults& task);

/// Part of a report about one task: conditions compared by their response times, and the cumulative curves.
/// Empty without times. Thread: any.
[[nodiscard]] QString timeSection(const TaskResults& task, std::optional<Mode> mode);

/// Shares of the right answers that were given within a time, one curve per condition, over all participants.
/// Thread: any.
[[nodiscard]] figure::SvgCanvas cumulativeTimeFigure(const TaskResults& task, std::optional<Mode> mode);

} // namespace teleta::study
