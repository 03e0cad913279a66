// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_reader.h"
#include "backend/core/error.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::cli {

/// Reads some columns of a CSV file, found by their names, with a progress bar.
class ColumnReader {
public:
    /// Failure: as core::CsvReader::open(), or a column is missing.
    [[nodiscard]] static core::Expected<ColumnReader> open(const std::string& path,
                                                           std::span<const std::string_view> names);

    /// Hands each row to take(), with the values in the order of the names, until the end of the file or
    /// until take() returns false. Failure: the file's, or interruption() after Ctrl-C. resultsOnTerminal: as
    /// ProgressBar.
    [[nodiscard]] core::Expected<void> forEachRow(bool resultsOnTerminal,
                                                  const std::function<bool(std::span<const double>)>& take);

private:
    ColumnReader(core::CsvReader reader, std::vector<std::size_t> columns);

    core::CsvReader m_reader;
    std::vector<std::size_t> m_columns;
};

} // namespace teleta::cli
