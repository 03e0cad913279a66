// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/signal/series.h"

#include <span>
#include <string>
#include <string_view>

namespace teleta::signal {

struct CsvSignal {
    std::string name; ///< of its column, with the unit
    Series series;
    double shift_s = 0.0; ///< from the times of the series to those that are written
};

/// Writes the samples of signals between two times: a column of times and one for each, a row for each time
/// that any of them has. NA: no sample then, or a gap. Error: as core::CsvWriter. Thread: any.
[[nodiscard]] core::Expected<void> writeSignalCsv(const std::string& path, std::span<const CsvSignal> written,
                                                  double from_s, double to_s,
                                                  std::string_view timeName = "time_s");

} // namespace teleta::signal
