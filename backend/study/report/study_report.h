// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/threshold_results.h"
#include "backend/study/protocol/trial.h"
#include "backend/study/report/exclusion_report.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// What a report states about its data.
struct ReportHeading {
    std::string title;
    std::optional<Mode> mode;         ///< empty: unknown; others than run are said loudly
    std::vector<std::string> sources; ///< studies and files, as they were named
    std::string appVersion;
    TrialTally::Frames frames = {}; ///< how the stimuli were played; of no trials: nothing is said
    ExclusionReport exclusions = {};
    ThresholdResults thresholds = {}; ///< of tasks with levels; empty: no section about them
    DetectionResults detection = {};
};

/// The results as one self-contained HTML 5 page: embedded SVG figures, each with its table, for light and
/// dark screens and for paper. Names of participants, tasks and patterns may contain any characters. The page
/// is also well-formed XML. Thread: any.
[[nodiscard]] std::string reportHtml(const std::vector<TaskResults>& results, const ReportHeading& heading);

/// Writes FOLDER/report.html. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeReport(const std::vector<TaskResults>& results,
                                               const ReportHeading& heading, const std::string& folder);

} // namespace teleta::study
