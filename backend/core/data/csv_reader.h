// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class QString;

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
    /// Opens the file and reads its header line.
    [[nodiscard]] static Expected<CsvReader> open(const std::string& path);

    [[nodiscard]] const std::vector<std::string>& header() const { return m_header; }
    [[nodiscard]] const std::string& path() const { return m_path; }

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

    /// Line of the row that was read last, from 1.
    [[nodiscard]] long long line() const { return m_line; }
    /// Line at which reading goes on, that of bytesRead().
    [[nodiscard]] long long nextLine() const { return m_nextLine; }
    /// Position behind the row that was read last.
    [[nodiscard]] std::uint64_t bytesRead() const { return m_bufferOffset + m_begin; }
    /// Size of the file; 0 when unknown (a pipe).
    [[nodiscard]] std::uint64_t bytesTotal() const { return m_size; }

    /// Goes to a row start that was reported by bytesRead() before; line is what nextLine() was then.
    /// Error: refused for a pipe.
    [[nodiscard]] Expected<void> seek(std::uint64_t byteOffset, long long line);

private:
    CsvReader() = default;
    [[nodiscard]] const char* row() const { return m_buffer.data() + m_rowBegin; }
    [[nodiscard]] const char* rowEnd() const { return row() + m_rowLength; }
    [[nodiscard]] Expected<void> openFile();
    [[nodiscard]] Expected<void> readHeader();
    [[nodiscard]] Expected<void> fill();
    [[nodiscard]] Expected<bool> readRow();
    [[nodiscard]] Expected<double> slowField(const char* begin, const char*& end, bool allowNonFinite) const;
    [[nodiscard]] SourcePlace placeOf(const char* position) const;
    [[nodiscard]] Unexpected systemError(ErrorKind kind, const QString& what, int code) const;
    [[nodiscard]] Unexpected tooLong(const char* position) const;
    [[nodiscard]] Unexpected tooShort(std::size_t values, const char* position) const;

    std::string m_path;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_file{nullptr, &std::fclose};
    bool m_seekable = false;
    std::uint64_t m_size = 0;

    std::vector<char> m_buffer;
    std::uint64_t m_bufferOffset = 0; ///< file position of m_buffer[0]
    std::size_t m_begin = 0;          ///< next byte to read in the buffer
    std::size_t m_end = 0;            ///< bytes in the buffer
    bool m_atEnd = false;

    std::size_t m_rowBegin = 0;
    std::size_t m_rowLength = 0;
    long long m_line = 0;
    long long m_nextLine = 1;
    std::vector<std::string> m_header;
    std::deque<std::string> m_quoted; ///< texts of the last row that were in quotes
};

} // namespace teleta::core
