// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/store/study_store.h"

#include <QString>

#include <vector>

namespace teleta::console {

/// The current results of a study. Error: what the store reports. Thread: any.
[[nodiscard]] core::Expected<std::vector<study::TaskResults>> resultsOf(const study::StoreLocation& location);

/// Writes the files of a study. format: psychds, bids, excel, or analysis for tables, figures and report.
/// Returns the folder of the files. Error: what the store reports, ioFailed. Thread: that of the store; for
/// psychds the one that also exports sessions, so that no file has two writers.
[[nodiscard]] core::Expected<QString> writeStudy(const study::StudyStore& store, const QString& format);
/// The same with its own connection. Thread: any.
[[nodiscard]] core::Expected<QString> writeStudy(const study::StoreLocation& location, const QString& format);

} // namespace teleta::console
