// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::python {

namespace py = pybind11;

/// Collects rows as core::CsvWriter takes them, and makes a table of them: a dict of columns. Only table()
/// needs the interpreter's lock.
class TableRows {
public:
    /// kinds: one character a column: i whole numbers (int64), f numbers (float64, NaN where there is none),
    /// s text, NA where a missing number stands.
    TableRows(std::span<const std::string_view> columns, std::string_view kinds);

    void number(double value);
    void number(const std::optional<double>& value);
    void integer(long long value);
    void text(std::string_view value);
    void endRow() { m_next = 0; }

    [[nodiscard]] py::dict table() &&;

private:
    struct Column {
        std::string name;
        char kind = 'f';
        std::vector<double> numbers;
        std::vector<std::int64_t> integers;
        std::vector<std::string> texts;
    };
    [[nodiscard]] Column& next() { return m_columns[m_next++]; }

    std::vector<Column> m_columns;
    std::size_t m_next = 0;
};

/// A numpy array of str. Needs the interpreter's lock.
[[nodiscard]] py::array textArray(const std::vector<std::string>& texts);

} // namespace teleta::python
