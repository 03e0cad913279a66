// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/analysis/trials/exclusion_results.h"

#include <QString>

#include <string>
#include <vector>

namespace teleta::study {

/// Writes exclusions.csv into a folder: a row per rule, and one per participant who lost something. Without
/// rules it has its header alone. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeExclusions(const std::vector<ExclusionLine>& lines,
                                                   const std::string& folder);

/// Part of a report: what the rules left out, and the main results with and without them. Empty without
/// rules. Thread: any.
[[nodiscard]] QString exclusionSection(const std::vector<TaskResults>& results,
                                       const ExclusionReport& exclusions);

} // namespace teleta::study
