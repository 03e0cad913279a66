// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/planning/plan_file.h"

#include "backend/core/data/csv_writer.h"

#include <string_view>

namespace teleta::study {

namespace {

constexpr std::string_view kPlanColumns =
    "test,participants,studies,significant,refused,power,se,lo,hi,target,seed";

} // namespace

core::Expected<void> writePlan(const PowerPlan& plan, const PlanSettings& settings, const std::string& test,
                               const std::string& path) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kPlanColumns));
    for (const PowerPoint& point : plan.points) {
        const Interval ends = point.interval();
        csv.row(test, point.participants, point.studies, point.significant, point.refused, point.power(),
                point.standardError(), ends.low, ends.high, settings.target, std::to_string(settings.seed));
    }
    return csv.finish();
}

} // namespace teleta::study
