// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/signal/series.h"

#include <cstddef>
#include <span>
#include <vector>

namespace teleta::signal {

/// What a signal holds at frequencies from 0 to half its rate.
struct Spectrum {
    std::vector<double> frequency_Hz;
    std::vector<double> amplitude; ///< of a sine, in the unit of the signal
    std::vector<double> density;   ///< of power, one-sided, in the unit squared per Hz
    double rate_Hz = 0.0;          ///< of the even grid
    std::size_t segment = 0;       ///< samples of a segment
    std::size_t segments = 0;      ///< over which the power is averaged
};

/// By Welch's method: segments that overlap by half, each without its mean and under a Hann window, their
/// power averaged (P. D. Welch, IEEE Trans. Audio Electroacoust. 15(2), 1967). segment: even, at most
/// values.size(). Thread: any (pure).
[[nodiscard]] Spectrum welch(std::span<const double> values, double rate_Hz, std::size_t segment);

/// Fewest samples of an uninterrupted stretch that make a spectrum.
inline constexpr std::size_t kFewestForSpectrum = 64;

/// Of the longest uninterrupted stretch between two times, at its mean rate: interpolated linearly onto an
/// even grid, in segments of a quarter of it, 64 to 65536 samples.
///   nominalRate_Hz: of the stream; 0: unknown.
/// Error: refused, when the rate is not known, or with fewer than kFewestForSpectrum samples.
/// Thread: any (pure).
[[nodiscard]] core::Expected<Spectrum> spectrumOf(const Series& series, double from_s, double to_s,
                                                  double nominalRate_Hz);

} // namespace teleta::signal
