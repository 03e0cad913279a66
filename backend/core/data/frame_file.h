// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/array_layout.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/error.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::core {

/// Reads recorded tactile frames: CSV with columns time_s,t0,t1,...,t(N-1), row-major, one row a frame; of
/// frames of vectors time_s,t0_x,t0_y,t0_z,t1_x,... Time must not decrease. Taxel values may be nan, inf or
/// NA (a dead taxel); time may not. Thread: one.
class FrameFile {
public:
    /// Opens the file; layout.taxels() must be the number of taxel columns, else an error that says both
    /// numbers. components: 1, or 3 where three columns are a taxel.
    [[nodiscard]] static Expected<FrameFile> open(const std::string& path, const ArrayLayout& layout,
                                                  int components = 1);

    /// Number of taxel columns of a file, to guess a layout before it is opened.
    [[nodiscard]] static Expected<std::size_t> countTaxels(const std::string& path);

    /// Reads the next frame into values (layout.taxels() entries). False at the end of the file; a file
    /// without any frame is an error.
    [[nodiscard]] Expected<bool> next(double& time_s, std::span<float> values);

    /// Byte offset and line at which the next frame starts; give them to seek() to come back.
    [[nodiscard]] std::uint64_t offset() const { return m_csv.bytesRead(); }
    [[nodiscard]] long long line() const { return m_csv.nextLine(); }
    [[nodiscard]] Expected<void> seek(std::uint64_t offset, long long line);

    [[nodiscard]] std::uint64_t bytesTotal() const { return m_csv.bytesTotal(); }
    [[nodiscard]] const ArrayLayout& layout() const { return m_layout; }
    [[nodiscard]] const std::string& path() const { return m_csv.path(); }

private:
    FrameFile(CsvReader csv, const ArrayLayout& layout);

    CsvReader m_csv;
    ArrayLayout m_layout;
    std::vector<double> m_row;
    std::optional<double> m_lastTime_s;
    bool m_anyFrame = false; ///< also true after seek(): an offset was known, so there was a frame
};

/// All frames of a recording one after another, layout.taxels() values each. goOn is asked now and then; once
/// it returns false, reading fails with ErrorKind::cancelled and no text.
[[nodiscard]] Expected<std::vector<float>> readFrames(const std::string& path, const ArrayLayout& layout,
                                                      const std::function<bool()>& goOn = {});

/// The tare to subtract: mean over an unloaded recording of each taxel's finite values.
/// A taxel that is never finite gets NaN and is dead from then on.
[[nodiscard]] Expected<std::vector<float>> readTare(const std::string& path, const ArrayLayout& layout);

} // namespace teleta::core
