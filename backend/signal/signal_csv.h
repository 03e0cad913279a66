// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/signal/series.h"

#include <span>
#include <string>

namespace teleta::signal {

struct CsvSignal {
    std::string name; ///< of its column, with the unit
    Series series;
};

/// Writes the samples of signals between two times: time_s and a column for each, a row for each time that
/// any of them has. NA: no sample then, or a gap. Error: as core::CsvWriter. Thread: any.
[[nodiscard]] core::Expected<void> writeSignalCsv(const std::string& path, std::span<const CsvSignal> written,
                                                  double from_s, double to_s);

} // namespace teleta::signal
