// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/study_results.h"
#include "backend/study/store/study_store.h"

#include <QString>

#include <vector>

namespace teleta::console {

/// The results of what a study has now. Error: what the store reports. Thread: any.
[[nodiscard]] core::Expected<std::vector<study::TaskResults>> resultsOf(const study::StoreLocation& location);

/// Writes a study into its folder. format: psychds, bids, excel, or analysis for tables, figures and report.
/// Returns the folder that was written. Error: what the store reports, ioFailed. Thread: that of the store;
/// for psychds the one that also writes what a session leaves, so that no file is written by two.
[[nodiscard]] core::Expected<QString> writeStudy(const study::StudyStore& store, const QString& format);
/// The same with a connection of its own. Thread: any.
[[nodiscard]] core::Expected<QString> writeStudy(const study::StoreLocation& location, const QString& format);

} // namespace teleta::console
