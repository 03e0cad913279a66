// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/protocol/trial.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// What a report says about its data.
struct ReportHeading {
    std::string title;
    std::optional<Mode> mode;         ///< empty: unknown; others than run are said loudly
    std::vector<std::string> sources; ///< studies and files, as they were named
    std::string appVersion;
    TrialTally::Frames frames = {}; ///< how the stimuli were played; of no trials: nothing is said
};

/// The results as one page of HTML 5 that needs nothing else: figures as SVG within, each with its table,
/// readable on light and dark screens and on paper. Names of participants, tasks and patterns may have any
/// characters. The page is well-formed XML too. Thread: any.
[[nodiscard]] std::string reportHtml(const std::vector<TaskResults>& results, const ReportHeading& heading);

/// Writes FOLDER/report.html. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeReport(const std::vector<TaskResults>& results,
                                               const ReportHeading& heading, const std::string& folder);

} // namespace teleta::study
