// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"

#include <QString>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace teleta::cli {

/// Exit codes of the program: 0 done, 1 the work failed, 2 wrong usage, 3 bad input file.
enum ExitCode { kDone = 0, kWorkFailed = 1, kWrongUsage = 2, kBadInput = 3 };

/// badInput and notFound are the input's fault (3), all others the work's (1).
[[nodiscard]] ExitCode exitCode(const core::Error& error);

/// Prints "teleta: file:line:column: message (expected ...)" on standard error.
void printError(const core::Error& error);

/// Prints "teleta: text" on standard error, for what does not end the work.
void warn(const QString& text);

/// Adds the flag --json.
void declareJson(CLI::App& app, bool& json);

/// Adds --out FILE for the CSV output.
void declareOut(CLI::App& app, std::string& outPath);

/// A number in the C locale with so many significant digits, for people.
[[nodiscard]] QString forPeople(double value, int digits = 4);

/// A number for a JSON document; null without one.
[[nodiscard]] nlohmann::ordered_json orNull(const std::optional<double>& value);

/// A text for a JSON document; null for an empty one.
[[nodiscard]] nlohmann::ordered_json textOrNull(const std::string& text);

/// Prints a text on standard output.
[[nodiscard]] core::Expected<void> printText(std::string_view text);

/// Prints one JSON document on standard output; NaN and infinities become null.
[[nodiscard]] core::Expected<void> printDocument(const nlohmann::ordered_json& document);

/// Labels and values.
using Fields = std::vector<std::pair<QString, QString>>;
/// Prints them as a table of two columns on standard output; on standard error when a file goes there.
[[nodiscard]] core::Expected<void> printFields(const Fields& fields);

/// Where the rows of a command go.
struct RowOptions {
    bool json = false;   ///< one JSON array of objects on standard output
    std::string outPath; ///< CSV file; empty: none
};

/// Streams the rows of a result with constant memory:
///   outPath     CSV into the file, which appears when it is complete;
///   json        a JSON array of objects with the columns as keys on standard output;
///   neither     CSV on standard output, or a table with aligned columns when that is a terminal.
/// CSV and JSON have numbers with the fewest digits that read back as the same double; what is not defined is
/// NA, in JSON null. The table has four significant digits.
/// Call number, integer or text once for each column, in order, then endRow.
class RowOutput {
public:
    [[nodiscard]] static core::Expected<RowOutput> open(std::span<const std::string_view> columns,
                                                        const RowOptions& options);

    void number(double value);
    void number(const std::optional<double>& value);
    void integer(long long value);
    void text(std::string_view value);
    void endRow();

    /// Writing failed or the reader went away: there is no use in going on; finish() says why.
    [[nodiscard]] bool failed() const;

    /// Hands the rows so far to who reads them.
    void flush();

    /// The same, a few times a second at most: in the loop of a source that may be slow, it lets the rows of
    /// a slow one appear when they are computed and those of a fast one in large pieces.
    void flushIfDue();

    /// Completes the output. Without it an --out file does not appear.
    [[nodiscard]] core::Expected<void> finish();

    /// The results are read by a person on this terminal.
    [[nodiscard]] bool onTerminal() const { return m_table; }

private:
    explicit RowOutput(std::span<const std::string_view> columns);
    void jsonValue(std::string_view value);
    void cell(std::string_view value);

    std::vector<std::string> m_columns;
    std::size_t m_field = 0;
    std::optional<core::CsvWriter> m_csv;
    std::optional<core::OutputFile> m_text; ///< JSON or table
    bool m_json = false;
    bool m_table = false;
    bool m_firstRow = true;
    std::int64_t m_nextFlush_ns = 0;
};

} // namespace teleta::cli
