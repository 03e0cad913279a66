// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/equilibration/load_calibration.h"

#include <string>
#include <vector>

namespace teleta::equilibration {

inline constexpr std::array<std::string_view, 8> kLoadCalibrationColumns{
    "load", "signal", "gain", "gain_se", "rest", "least", "greatest", "scatter"};

/// Reads presses: CSV with one or more of kLoadColumns, and the signals, a row a press; other columns are
/// ignored. Error: notFound, ioFailed, badInput with line and column: none of these loads, a signal is
/// missing or twice, a number is missing. Thread: any.
[[nodiscard]] core::Expected<KnownPresses> readKnownPresses(const std::string& path,
                                                            const std::vector<std::string>& channels);

/// Reads a calibration: CSV with the columns load,signal,gain,gain_se,rest,least,greatest,scatter, a
/// row for each load and signal. Error: notFound, ioFailed, badInput with line and column: an unknown load, a
/// pair that is missing or twice, rests or ranges of one signal, or scatters of one load, that differ, least
/// above greatest, an error or a scatter below 0. Thread: any.
/// known: signals that there are; another one is badInput. Empty: any.
[[nodiscard]] core::Expected<LoadCalibration> readLoadCalibration(const std::string& path,
                                                                  const std::vector<std::string>& known = {});

/// Writes one row for each load and signal. Rows: a type with the members of core::CsvWriter.
template <typename Rows>
void writeLoadCalibrationRows(const LoadCalibration& calibration, Rows& rows) {
    for (Eigen::Index l = 0; l < calibration.gain.rows(); ++l) {
        for (Eigen::Index s = 0; s < calibration.gain.cols(); ++s) {
            rows.text(calibration.loads[static_cast<std::size_t>(l)]);
            rows.text(calibration.channels[static_cast<std::size_t>(s)]);
            rows.number(calibration.gain(l, s));
            rows.number(calibration.error(l, s));
            rows.number(calibration.rest[s]);
            rows.number(calibration.least[s]);
            rows.number(calibration.greatest[s]);
            rows.number(calibration.scatter[l]);
            rows.endRow();
        }
    }
}

/// Writes the file atomically; creates its folder. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeLoadCalibration(const LoadCalibration& calibration,
                                                        const std::string& path);

} // namespace teleta::equilibration
