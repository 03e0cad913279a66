// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::scene_run {

/// A CSV file in the folder of a run. Without a folder nothing is written. Thread: one.
class RunCsv {
public:
    RunCsv() = default;
    /// header: the names of the columns with commas between them. Error: ioFailed.
    [[nodiscard]] static core::Expected<RunCsv> open(const std::string& outFolder, const std::string& file,
                                                     std::string_view header);
    /// frames.csv: time_s,t0,t1,..., the frames of a tactile array.
    [[nodiscard]] static core::Expected<RunCsv> openFrames(const std::string& outFolder, std::size_t taxels);

    /// As CsvWriter::row.
    template <typename... Values>
    void row(const Values&... values) {
        if (m_csv)
            m_csv->row(values...);
    }
    /// Rows are written; otherwise nobody needs them.
    [[nodiscard]] bool isOpen() const { return m_csv.has_value(); }
    [[nodiscard]] bool failed() const { return m_csv && m_csv->failed(); }
    [[nodiscard]] core::Expected<void> finish() { return m_csv ? m_csv->finish() : core::Expected<void>(); }

private:
    std::optional<core::CsvWriter> m_csv;
};

/// A value of a row, or NA when it is not known.
template <typename Value>
[[nodiscard]] std::optional<Value> valueIf(bool known, const Value& value) {
    return known ? std::optional<Value>(value) : std::nullopt;
}

} // namespace teleta::scene_run
