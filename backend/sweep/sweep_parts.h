// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/sweep/run_row.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace teleta::sweep {

/// The most rows of a part.
inline constexpr std::size_t kRowsOfPart = 1000;

/// Writes rows into parts/NNNN.csv of a folder: run,status,reason,wall_s,processor_s,MEASURES. A part has a
/// number that no other has, so that several writers, also on several machines, share the folder. It is
/// written whole or not at all, and lasts through a power cut. Thread: one.
class PartWriter {
public:
    /// folder: of the sweep, with its folder parts.
    explicit PartWriter(std::string folder)
        : m_folder(std::move(folder)) {}

    void add(RunRow row) { m_rows.push_back(std::move(row)); }
    /// Rows that are not in the file yet.
    [[nodiscard]] std::size_t unwritten() const { return m_rows.size() - m_written; }
    [[nodiscard]] std::size_t rows() const { return m_rows.size(); }
    /// Takes a number if it has none. Error: ioFailed.
    [[nodiscard]] core::Expected<std::string> number();
    /// Writes all rows; a full part is closed, and the next row begins another. Error: ioFailed.
    [[nodiscard]] core::Expected<void> flush();
    /// The same, and the part is closed.
    [[nodiscard]] core::Expected<void> close();

private:
    std::string m_folder;
    std::string m_number;
    std::vector<RunRow> m_rows;
    std::size_t m_written = 0;
};

/// "0012", as files of a part are named.
[[nodiscard]] std::string partName(std::uint64_t number);

/// Calls take with every row of the parts of a folder, in the order of their numbers; measures in the order
/// of the part's columns, those that could not be determined left out. Rows may come twice. A number that is
/// taken but not yet written has none. columns: gets the measures of all parts, also those that no run has.
/// Error: ioFailed, badInput for a part that is none. Thread: any.
[[nodiscard]] core::Expected<void> readParts(const std::string& folder,
                                             const std::function<void(RunRow&&)>& take,
                                             std::set<std::string>* columns = nullptr);

/// Which runs have a row, of so many. Error: as readParts(), and badInput for a run that the sweep does not
/// have.
[[nodiscard]] core::Expected<std::vector<bool>> finishedRuns(const std::string& folder, std::uint64_t runs);

} // namespace teleta::sweep
