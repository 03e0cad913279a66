// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::study {

/// The R script that analyses a study again, from the exported trials or from confusion_long.csv, and writes
/// summary_r.csv and anova_r.csv; the resource :/studies/analysis.R. Error: notFound. Thread: any.
[[nodiscard]] core::Expected<std::string> analysisScript();

} // namespace teleta::study
