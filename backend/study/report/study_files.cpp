// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_writer.h"
#include "backend/core/data/private_files.h"
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/study_rows.h"
#include "backend/study/report/comparison_files.h"
#include "backend/study/report/exports/codebook.h"
#include "backend/study/report/exports/study_export.h"

#include <array>
#include <string_view>

namespace teleta::study {

namespace {

using Results = std::vector<TaskResults>;

template <std::size_t Columns>
core::Expected<void> writeTable(const Results& results, const std::string& path,
                                const std::array<std::string_view, Columns>& columns,
                                void (*write)(const TaskResults&, core::CsvWriter&)) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, columns));
    for (const TaskResults& task : results)
        write(task, csv);
    return csv.finish();
}

} // namespace

core::Expected<void> writeResults(const Results& results, const std::string& folder) {
    const core::PrivateFiles forOwner;
    TELETA_CHECK(core::makeFolder(folder));
    TELETA_TRY(const std::string script, analysisScript());
    TELETA_CHECK(writeTable(results, folder + "/confusion_long.csv", kConfusionColumns,
                            writeConfusions<core::CsvWriter>));
    TELETA_CHECK(
        writeTable(results, folder + "/summary.csv", kSummaryColumns, writeSummary<core::CsvWriter>));
    TELETA_CHECK(writeTable(results, folder + "/group.csv", kGroupColumns, writeGroups<core::CsvWriter>));
    TELETA_CHECK(writeTable(results, folder + "/anova.csv", kAnovaColumns, writeAnova<core::CsvWriter>));
    TELETA_CHECK(core::writeFile(folder + "/codebook.csv", codebookText()));
    TELETA_CHECK(writeComparisons(results, folder));
    return core::writeFile(folder + "/analysis.R", script);
}

} // namespace teleta::study
