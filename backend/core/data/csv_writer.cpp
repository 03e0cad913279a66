// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_writer.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

namespace teleta::core {

CsvWriter::CsvWriter(OutputFile output, std::span<const std::string_view> columns)
    : m_output(std::move(output))
    , m_columns(columns.size()) {
    for (const std::string_view column : columns)
        text(column);
    endRow();
}

Expected<CsvWriter> CsvWriter::create(const std::string& path, std::span<const std::string_view> columns) {
    TELETA_TRY(OutputFile output, OutputFile::create(path));
    return CsvWriter(std::move(output), columns);
}

Expected<CsvWriter> CsvWriter::create(const std::string& path, std::string_view header) {
    std::vector<std::string_view> columns;
    for (std::size_t begin = 0, end = 0; begin <= header.size(); begin = end + 1) {
        end = std::min(header.find(',', begin), header.size());
        columns.push_back(header.substr(begin, end - begin));
    }
    return create(path, columns);
}

void CsvWriter::text(std::string_view value) {
    if (value.find_first_of(",\"\r\n") == std::string_view::npos) {
        raw(value);
        return;
    }
    raw("\"");
    for (const char c : value) {
        if (c == '"')
            m_row += '"';
        m_row += c;
    }
    m_row += '"';
}

void CsvWriter::endRow() {
    assert(m_field == m_columns);
    m_row += '\n';
    m_output.write(m_row);
    m_row.clear();
    m_field = 0;
}

} // namespace teleta::core
