// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/column_reader.h"

#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"

#include <utility>

namespace teleta::cli {

ColumnReader::ColumnReader(core::CsvReader reader, std::vector<std::size_t> columns)
    : m_reader(std::move(reader))
    , m_columns(std::move(columns)) {
}

core::Expected<ColumnReader> ColumnReader::open(const std::string& path,
                                                std::span<const std::string_view> names) {
    TELETA_TRY(core::CsvReader reader, core::CsvReader::open(path));
    TELETA_TRY(std::vector<std::size_t> columns, reader.columns(names));
    return ColumnReader(std::move(reader), std::move(columns));
}

core::Expected<void> ColumnReader::forEachRow(bool resultsOnTerminal,
                                              const std::function<bool(std::span<const double>)>& take) {
    const auto total = static_cast<double>(m_reader.bytesTotal());
    ProgressBar progress(ProgressBar::Unit::bytes, resultsOnTerminal);
    std::vector<double> row;
    std::vector<double> values(m_columns.size());
    for (;;) {
        if (interrupted())
            return core::Unexpected(interruption());
        TELETA_TRY(const bool more, m_reader.next(row));
        if (!more)
            return {};
        for (std::size_t i = 0; i < m_columns.size(); ++i)
            values[i] = row[m_columns[i]];
        if (!take(values))
            return {};
        progress.update(static_cast<double>(m_reader.bytesRead()), total);
    }
}

} // namespace teleta::cli
