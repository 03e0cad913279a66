// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/pattern/motors/motor_model.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace teleta::pattern {

inline constexpr double kLowestRate_Hz = 0.001;
inline constexpr double kHighestRate_Hz = 192'000.0;

/// Default sample rates of CSV and WAV files.
inline constexpr double kCsvRate_Hz = 200.0;
inline constexpr double kWavRate_Hz = 8000.0;

/// Number of samples k = 0, 1, ... at k / rate in [0, duration).
[[nodiscard]] std::uint64_t samplesOf(double duration_s, double rate_Hz);

/// Calls a function with all samples in order until it returns false.
void forEachSample(const Pattern& pattern, double rate_Hz,
                   const std::function<bool(double t_s, const core::Intensities&)>& visit);

/// What is sampled in a CSV or WAV file, and how often.
struct SampleOptions {
    std::optional<double> rate_Hz;       ///< empty: kCsvRate_Hz, kWavRate_Hz
    std::optional<MotorProfiles> motors; ///< sample what these are predicted to do; empty: what is commanded
    std::optional<double> carrier_Hz =
        std::nullopt; ///< WAV: a sine of this frequency; empty: the intensities themselves
};

/// Frequency that voice coils are usually made for.
inline constexpr double kCarrier_Hz = 250.0;

/// Writes CSV with the columns time_s,t1..t6. Error: refused: a rate outside
/// [kLowestRate_Hz, kHighestRate_Hz], a profile that is not valid(); ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeCsv(const Pattern& pattern, const std::string& path,
                                            const SampleOptions& options = {});
/// Writes WAV with 6 channels of 16 bits (WAVE_FORMAT_EXTENSIBLE, no speakers assigned); 1 is 32767. Sample k
/// is the intensity a(k / rate), or with a carrier a(k / rate) sin(2 pi f k / rate). Error: as writeCsv();
/// refused: a rate that is not an integer, a carrier that is not between 0 and half the rate, a file of more
/// than 4 GiB.
[[nodiscard]] core::Expected<void> writeWav(const Pattern& pattern, const std::string& path,
                                            const SampleOptions& options = {});

} // namespace teleta::pattern
