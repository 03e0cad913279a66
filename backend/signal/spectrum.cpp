// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/spectrum.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace teleta::signal {

namespace {

struct SpectrumText {
    Q_DECLARE_TR_FUNCTIONS(SpectrumText)
};

constexpr std::size_t kLongestSegment = 65536;

/// First and last (exclusive) sample of the longest stretch without NaN.
struct Stretch {
    std::size_t first = 0, last = 0;
    [[nodiscard]] std::size_t size() const { return last - first; }
};

Stretch longestStretch(const Series& series, std::size_t first, std::size_t last) {
    Stretch longest, now{first, first};
    for (std::size_t i = first; i < last; ++i) {
        if (std::isnan(series.value(i)))
            now = {i + 1, i + 1};
        else
            now.last = i + 1;
        if (now.size() > longest.size())
            longest = now;
    }
    return longest;
}

std::vector<double> onEvenGrid(const Series& series, const Stretch& stretch) {
    std::vector<double> values(stretch.size());
    const double begin_s = series.time_s(stretch.first);
    const double step_s =
        (series.time_s(stretch.last - 1) - begin_s) / static_cast<double>(stretch.size() - 1);
    std::size_t after = stretch.first + 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double time_s = begin_s + step_s * static_cast<double>(i);
        while (after + 1 < stretch.last && series.time_s(after) < time_s)
            ++after;
        const double from_s = series.time_s(after - 1), to_s = series.time_s(after);
        const double share = to_s > from_s ? std::clamp((time_s - from_s) / (to_s - from_s), 0.0, 1.0) : 1.0;
        values[i] = std::lerp(series.value(after - 1), series.value(after), share);
    }
    return values;
}

} // namespace

Spectrum welch(std::span<const double> values, double rate_Hz, std::size_t segment) {
    Spectrum spectrum;
    spectrum.rate_Hz = rate_Hz;
    spectrum.segment = segment;
    std::vector<double> window(segment);
    for (std::size_t i = 0; i < segment; ++i)
        window[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) /
                                         static_cast<double>(segment));
    const double sum = std::accumulate(window.begin(), window.end(), 0.0);
    const double squares = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    const std::size_t bins = segment / 2 + 1;
    std::vector<double> power(bins);
    std::vector<double> part(segment);
    std::vector<std::complex<double>> transformed;
    Eigen::FFT<double> fft;
    for (std::size_t first = 0; first + segment <= values.size(); first += segment / 2) {
        const std::span<const double> now = values.subspan(first, segment);
        const double mean = std::accumulate(now.begin(), now.end(), 0.0) / static_cast<double>(segment);
        std::ranges::transform(now, window, part.begin(),
                               [mean](double value, double weight) { return weight * (value - mean); });
        fft.fwd(transformed, part);
        for (std::size_t bin = 0; bin < bins; ++bin)
            power[bin] += std::norm(transformed[bin]);
        ++spectrum.segments;
    }
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const double mean = power[bin] / static_cast<double>(std::max<std::size_t>(1, spectrum.segments));
        // Each frequency between the ends stands for its negative one too.
        const double sides = bin == 0 || bin == segment / 2 ? 1.0 : 2.0;
        spectrum.frequency_Hz.push_back(rate_Hz * static_cast<double>(bin) / static_cast<double>(segment));
        spectrum.amplitude.push_back(sides * std::sqrt(mean) / sum);
        spectrum.density.push_back(sides * mean / (rate_Hz * squares));
    }
    return spectrum;
}

core::Expected<Spectrum> spectrumOf(const Series& series, double from_s, double to_s, double nominalRate_Hz) {
    if (!(nominalRate_Hz > 0.0))
        return core::refused(SpectrumText::tr("The signal has no rate: its samples come when they please."));
    const Stretch stretch =
        longestStretch(series, series.firstAt(from_s), std::min(series.size(), series.firstAt(to_s)));
    const bool lasts = stretch.size() > 1 && series.time_s(stretch.last - 1) > series.time_s(stretch.first);
    if (stretch.size() < kFewestForSpectrum || !lasts)
        return core::refused(
            SpectrumText::tr("There are only %1 samples in a row in view; a spectrum needs %2.")
                .arg(stretch.size())
                .arg(kFewestForSpectrum));
    const std::vector<double> values = onEvenGrid(series, stretch);
    const double rate_Hz = static_cast<double>(stretch.size() - 1) /
                           (series.time_s(stretch.last - 1) - series.time_s(stretch.first));
    const std::size_t segment =
        std::clamp(std::bit_floor(values.size() / 4), kFewestForSpectrum, kLongestSegment);
    return welch(values, rate_Hz, segment);
}

} // namespace teleta::signal
