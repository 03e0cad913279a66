// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/table_rows.h"

#include "app/python/base/array_output.h"

#include <utility>

namespace teleta::python {

TableRows::TableRows(std::span<const std::string_view> columns, std::string_view kinds) {
    for (std::size_t i = 0; i < columns.size(); ++i)
        m_columns.push_back({std::string(columns[i]), kinds.at(i), {}, {}, {}});
}

void TableRows::number(double value) {
    Column& column = next();
    if (column.kind == 's')
        column.texts.emplace_back("NA");
    else
        column.numbers.push_back(value);
}

void TableRows::number(const std::optional<double>& value) {
    number(orNaN(value));
}

void TableRows::integer(long long value) {
    next().integers.push_back(value);
}

void TableRows::text(std::string_view value) {
    next().texts.emplace_back(value);
}

py::dict TableRows::table() && {
    py::dict table;
    for (Column& column : m_columns)
        table[py::str(column.name)] = column.kind == 's'   ? textArray(column.texts)
                                      : column.kind == 'i' ? arrayOf(std::move(column.integers))
                                                           : arrayOf(std::move(column.numbers));
    return table;
}

py::array textArray(const std::vector<std::string>& texts) {
    py::list list;
    for (const std::string& text : texts)
        list.append(py::str(text));
    return py::module_::import("numpy").attr("array")(list, py::arg("dtype") = "str");
}

} // namespace teleta::python
