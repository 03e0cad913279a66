// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::core {

/// Reads a CSV file of numbers row by row with constant memory (files of many GB are fine): RFC 4180 quoting,
/// LF or CRLF, optional UTF-8 BOM, comma only, numbers in the C locale. Lines that are empty are skipped.
/// Errors carry file, line, column (of the field, in characters from 1) and what was expected: missing
/// columns, a row too short or too long, text instead of a number, an empty file, a line over 16 MiB.
/// "nan", "inf" and "NA" are values (NaN, infinity, NaN) only in columns read with allowNonFinite.
/// A signal whose handler was installed without SA_RESTART ends a read that waits for a pipe:
/// ErrorKind::cancelled, and next() may be called again.
/// Thread: one.
class CsvReader {
public:
    ~CsvReader();
    CsvReader(CsvReader&&) noexcept;
    CsvReader& operator=(CsvReader&&) noexcept;

    /// Opens the file and reads its header line.
    [[nodiscard]] static Expected<CsvReader> open(const std::string& path);

    [[nodiscard]] const std::vector<std::string>& header() const;
    [[nodiscard]] const std::string& path() const;

    /// Index of a named column; an Error that lists the columns that are there when it is missing or there
    /// twice.
    [[nodiscard]] Expected<std::size_t> column(std::string_view name) const;

    /// Indices of several named columns; an Error that lists all that are missing and those that are there.
    [[nodiscard]] Expected<std::vector<std::size_t>> columns(std::span<const std::string_view> names) const;

    /// Reads the next row into values, one entry a header column. False at the end of the file.
    /// allowNonFinite: NaN and infinities are values; otherwise an error.
    [[nodiscard]] Expected<bool> next(std::vector<double>& values, bool allowNonFinite = false);

    /// Reads the next row as text: fields without their quotes and outer blanks, one a header column. Views
    /// are valid until the next read. False at the end of the file.
    [[nodiscard]] Expected<bool> nextText(std::vector<std::string_view>& fields);

    /// Place of a field of the row that was read last (of the header before the first row), for errors about
    /// values.
    [[nodiscard]] SourcePlace place(std::size_t column) const;

    [[nodiscard]] long long line() const;           ///< line of the row that was read last, from 1
    [[nodiscard]] long long nextLine() const;       ///< line at which reading goes on: that of bytesRead()
    [[nodiscard]] std::uint64_t bytesRead() const;  ///< position behind the row that was read last
    [[nodiscard]] std::uint64_t bytesTotal() const; ///< file size; 0 when unknown (a pipe)

    /// Goes to a row start that was reported by bytesRead() before; line is what nextLine() was then.
    /// Error: refused for a pipe.
    [[nodiscard]] Expected<void> seek(std::uint64_t byteOffset, long long line);

private:
    class Private;
    explicit CsvReader(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace teleta::core
