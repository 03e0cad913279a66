// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/protocol.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// What a column of a written file means.
struct CodebookEntry {
    /// Name of the file; "trials", "questionnaire" and "notes" stand for the tables of that kind in every
    /// export, "phenotype" for the first columns of BIDS' tables of questionnaires.
    std::string file;
    std::string column;
    std::string description;
    std::string unit;    ///< empty: none
    std::string levels;  ///< "word: meaning; word: meaning"; empty: no fixed words
    std::string missing; ///< what a missing value means; empty: there is always a value
};

/// Every column of every table that studies and their analyses write. The one table from which codebook.csv,
/// Psych-DS' variableMeasured, BIDS' sidecars and the handbook's page are made. Thread: any.
[[nodiscard]] const std::vector<CodebookEntry>& codebook();

/// The entries of a questionnaire: file is "phenotype", column the item or the score, with the
/// questionnaire's id in front of the description. Thread: any.
[[nodiscard]] std::vector<CodebookEntry> questionnaireEntries(const Questionnaire& questionnaire);

/// Null: there is none.
[[nodiscard]] const CodebookEntry* findEntry(std::string_view file, std::string_view column);

/// codebook(), and the questionnaires of a protocol; null: none.
[[nodiscard]] std::vector<CodebookEntry> codebookOf(const Protocol* protocol);

/// Entries as CSV: file,column,description,unit,levels,missing. Thread: any.
[[nodiscard]] std::string codebookText(const std::vector<CodebookEntry>& entries = codebook());

/// The codebook as the handbook's page, in Markdown. Thread: any.
[[nodiscard]] std::string codebookPage();

/// Description of columns for Psych-DS: a list of schema.org's PropertyValue. Columns without an entry have
/// their name alone.
[[nodiscard]] nlohmann::ordered_json psychDsVariables(std::string_view file,
                                                      std::span<const std::string_view> columns);

/// Description of columns for BIDS' sidecars: Description, Units, Levels.
[[nodiscard]] nlohmann::ordered_json bidsColumns(std::string_view file,
                                                 std::span<const std::string_view> columns);
/// One of them.
[[nodiscard]] nlohmann::ordered_json bidsColumn(const CodebookEntry& entry);

/// Parts of codebook(). Fields in the order of CodebookEntry.
struct CodebookRow {
    const char* column;
    const char* description;
    const char* unit = "";
    const char* levels = "";
    const char* missing = "";
};
struct CodebookFile {
    const char* file;
    std::span<const CodebookRow> rows;
};
[[nodiscard]] std::span<const CodebookFile> codebookOfExports();
[[nodiscard]] std::span<const CodebookFile> codebookOfResults();
[[nodiscard]] std::span<const CodebookFile> codebookOfMethods();

} // namespace teleta::study
