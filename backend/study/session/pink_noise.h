// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace teleta::study {

struct PinkNoiseSettings {
    std::size_t samples = std::size_t{1} << 20U; ///< of one period, even; 21.8 s at 48 kHz
    double rate_Hz = 48'000.0;
    double low_Hz = 20.0;      ///< nothing below
    double high_Hz = 20'000.0; ///< nothing above; at most half the rate
    double level_dBFS = -20.0; ///< root mean square; 0 is that of a square wave at full scale
    std::uint64_t seed = 1;
};

/// One period of pink noise, in -1 .. 1, that loops seamlessly: its Fourier series has the amplitudes
/// c/sqrt(f) and random phases, so that the power density falls by exactly 10 dB per decade between low_Hz
/// and high_Hz.
///   x_n = sum_k c/sqrt(k) cos(2 pi k n/N + phi_k),  c such that the root mean square is 10^(level/20)
/// The same settings give the same noise everywhere, except for rounding. Error: refused for settings out of
/// range, a band without any frequency, and a level that would clip. Thread: any (takes about 0.1 s).
[[nodiscard]] core::Expected<std::vector<float>> pinkNoise(const PinkNoiseSettings& settings = {});

/// Writes a 16-bit mono WAV. samples: in -1 .. 1, rate_Hz: a whole number. Error: refused for more than 4
/// GiB, ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeMonoWav(const std::vector<float>& samples, double rate_Hz,
                                                const std::string& path);

} // namespace teleta::study
