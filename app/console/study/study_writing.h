// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/exclusion_results.h"
#include "backend/study/model/task_supplement.h"
#include "backend/study/store/study_store.h"
#include "widgets/study/results/level_content.h"

#include <QString>

#include <memory>
#include <vector>

namespace teleta::console {

/// What the page shows of the results of a study.
struct StudyResults {
    std::vector<study::TaskResults> tasks;
    std::shared_ptr<const study::LevelResults> levels; ///< of tasks with levels
    std::vector<study::TaskSupplement> supplements;    ///< of the tasks, in their order
    study::ExclusionReport exclusions;
};

/// The current results of a study. Error: what the store reports. Thread: any; fits take several threads.
[[nodiscard]] core::Expected<StudyResults> resultsOf(const study::StoreLocation& location);

/// Writes the files of a study. format: psychds, bids, excel, or analysis for tables, figures and report.
/// Returns the folder of the files. Error: what the store reports, ioFailed. Thread: that of the store; for
/// psychds the one that also exports sessions, so that no file has two writers.
[[nodiscard]] core::Expected<QString> writeStudy(const study::StudyStore& store, const QString& format);
/// The same with its own connection. Thread: any.
[[nodiscard]] core::Expected<QString> writeStudy(const study::StoreLocation& location, const QString& format);

} // namespace teleta::console
