// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/planning/power.h"

#include <string>

namespace teleta::study {

/// Writes plan.csv: test,participants,studies,significant,refused,power,se,lo,hi,target,seed, a row per
/// number of participants. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writePlan(const PowerPlan& plan, const PlanSettings& settings,
                                             const std::string& test, const std::string& path);

} // namespace teleta::study
