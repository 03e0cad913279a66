// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/threshold_results.h"

#include <string>

namespace teleta::study {

/// Writes thresholds.csv and levels.csv (what was fitted with what, so that analysis.R fits it again), and
/// sdt.csv where there is signal detection, into an existing folder. Without thresholds nothing is written.
/// Missing values are NA. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeThresholds(const ThresholdResults& thresholds,
                                                   const DetectionResults& detection,
                                                   const std::string& folder);

} // namespace teleta::study
