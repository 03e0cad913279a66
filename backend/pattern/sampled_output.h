// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/pattern.h"

#include <cstdint>
#include <functional>
#include <string>

namespace teleta::pattern {

inline constexpr double kLowestRate_Hz = 0.001;
inline constexpr double kHighestRate_Hz = 192'000.0;

/// Rate of the samples in CSV files that are converted, and in WAV files.
inline constexpr double kCsvRate_Hz = 200.0;
inline constexpr double kWavRate_Hz = 8000.0;

/// Samples k = 0, 1, ... at k / rate that lie in [0, duration).
[[nodiscard]] std::uint64_t samplesOf(double duration_s, double rate_Hz);

/// Hands all samples to a function, in their order, until it returns false.
void forEachSample(const Pattern& pattern, double rate_Hz,
                   const std::function<bool(double t_s, const core::Intensities&)>& visit);

/// CSV time_s,t1..t6.
[[nodiscard]] core::Expected<void> writeCsv(const Pattern& pattern, const std::string& path, double rate_Hz);

/// WAV with 6 channels of 16 bit (WAVE_FORMAT_EXTENSIBLE, no speakers assigned): the intensities, 1 is 32767.
/// rate_Hz: a whole number. Error: refused when the file would be longer than 4 GiB.
[[nodiscard]] core::Expected<void> writeWav(const Pattern& pattern, const std::string& path, double rate_Hz);

} // namespace teleta::pattern
