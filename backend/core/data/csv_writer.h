// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/output_file.h"
#include "backend/core/error.h"
#include "backend/core/number_text.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace teleta::core {

/// Writes a CSV file as CsvReader reads it: comma, LF, numbers in the C locale with the fewest digits that
/// read back as the same double, NA for what is not defined (empty or NaN), quotes where RFC 4180 needs them.
/// The file appears under its name with finish(), see OutputFile.
/// Thread: one; constant memory.
class CsvWriter {
public:
    /// Writes the header line. columns: at least one.
    CsvWriter(OutputFile output, std::span<const std::string_view> columns);

    /// Creates the file and writes its header line.
    [[nodiscard]] static Expected<CsvWriter> create(const std::string& path,
                                                    std::span<const std::string_view> columns);
    /// header: the names of the columns with commas between them.
    [[nodiscard]] static Expected<CsvWriter> create(const std::string& path, std::string_view header);

    void number(double value) {
        if (std::isnan(value))
            raw("NA");
        else
            raw(NumberText(value).view());
    }
    /// With the digits of a float, which are fewer than those of the same value as a double.
    void number(float value) {
        if (std::isnan(value))
            raw("NA");
        else
            raw(NumberText(value).view());
    }
    void number(const std::optional<double>& value) {
        if (value)
            number(*value);
        else
            raw("NA");
    }
    void integer(long long value) { raw(NumberText(value).view()); }
    void text(std::string_view value);

    /// Ends the row, which must have one value a column.
    void endRow();

    /// Writes a whole row: texts, whole numbers, numbers as above, ranges of these, optionals of these (NA
    /// when empty).
    template <typename... Values>
    void row(const Values&... values) {
        (put(values), ...);
        endRow();
    }

    void flush() { m_output.flush(); }
    [[nodiscard]] bool failed() const { return m_output.failed(); }
    [[nodiscard]] Expected<void> finish() { return m_output.finish(); }

private:
    template <typename Value>
    void put(const Value& value) {
        if constexpr (std::is_convertible_v<const Value&, std::string_view>) {
            text(value);
        } else if constexpr (std::is_integral_v<Value>) {
            integer(static_cast<long long>(value));
        } else if constexpr (requires { value.has_value(); }) {
            if (value)
                put(*value);
            else
                raw("NA");
        } else if constexpr (requires { value.begin(); }) {
            for (const auto& each : value)
                put(each);
        } else {
            number(value);
        }
    }
    void raw(std::string_view value) {
        if (m_field++ > 0)
            m_row += ',';
        m_row += value;
    }

    OutputFile m_output;
    std::string m_row;
    std::size_t m_columns;
    std::size_t m_field = 0;
};

} // namespace teleta::core
