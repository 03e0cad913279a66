// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/protocol/trial.h"

#include <QString>

#include <optional>

namespace teleta::study {

/// Part of a report about the tasks with levels: thresholds of the participants and their groups with
/// figures, differences that are just noticed, steps of intensity, best times, d' and criterion. Empty
/// without them. Thread: any.
[[nodiscard]] QString thresholdSection(const ThresholdResults& thresholds, const DetectionResults& detection,
                                       std::optional<Mode> mode);

} // namespace teleta::study
