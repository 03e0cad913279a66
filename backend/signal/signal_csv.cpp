// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/signal_csv.h"

#include "backend/core/data/csv_writer.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace teleta::signal {

core::Expected<void> writeSignalCsv(const std::string& path, std::span<const CsvSignal> written,
                                    double from_s, double to_s, std::string_view timeName) {
    std::vector<std::string_view> columns{timeName};
    std::vector<std::size_t> next;
    for (const CsvSignal& signal : written) {
        columns.push_back(signal.name);
        next.push_back(signal.series.firstAt(from_s - signal.shift_s));
    }
    TELETA_TRY(auto csv, core::CsvWriter::create(path, columns));
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto timeOf = [&](std::size_t i) {
        const CsvSignal& signal = written[i];
        return next[i] < signal.series.size() ? signal.shift_s + signal.series.time_s(next[i]) : kNone;
    };
    while (!csv.failed()) {
        double time_s = kNone;
        for (std::size_t i = 0; i < written.size(); ++i)
            time_s = std::min(time_s, timeOf(i));
        if (time_s > to_s || time_s == kNone)
            break;
        csv.number(time_s);
        for (std::size_t i = 0; i < written.size(); ++i) {
            const bool has = timeOf(i) == time_s;
            csv.number(has ? written[i].series.value(next[i]) : std::numeric_limits<double>::quiet_NaN());
            next[i] += has ? 1 : 0;
        }
        csv.endRow();
    }
    return csv.finish();
}

} // namespace teleta::signal
