// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/automatic_threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace teleta::contact {

namespace {

constexpr std::size_t kHistogramBins = 256;
constexpr double kBackgroundSpread = 3.0;

} // namespace

std::optional<double> automaticThreshold(std::span<const float> loads) {
    if (loads.empty())
        return std::nullopt;
    const auto peak = static_cast<double>(*std::max_element(loads.begin(), loads.end()));
    if (!(peak > 0.0))
        return std::nullopt;

    const auto binOf = [peak](float load) {
        const double share = static_cast<double>(load) / peak;
        return std::min(static_cast<std::size_t>(share * kHistogramBins), kHistogramBins - 1);
    };
    std::array<std::int64_t, kHistogramBins> histogram{};
    std::int64_t total = 0;
    for (const float load : loads) {
        const std::size_t bin = binOf(load);
        ++histogram[bin];
        total += static_cast<std::int64_t>(bin);
    }

    const auto count = static_cast<std::int64_t>(loads.size());
    std::int64_t below = 0;
    std::int64_t sumBelow = 0;
    double best = 0.0;
    std::size_t split = 0;
    for (std::size_t bin = 0; bin + 1 < kHistogramBins; ++bin) {
        below += histogram[bin];
        sumBelow += histogram[bin] * static_cast<std::int64_t>(bin);
        if (below == 0 || below == count)
            continue;
        const double a = static_cast<double>(below);
        const double b = static_cast<double>(count - below);
        const double gap = static_cast<double>(sumBelow) / a - static_cast<double>(total - sumBelow) / b;
        const double between = a * b * gap * gap;
        if (between > best) {
            best = between;
            split = bin + 1;
        }
    }
    if (split == 0)
        return std::nullopt;

    double sum = 0.0;
    double n = 0.0;
    for (const float load : loads) {
        if (binOf(load) < split) {
            sum += static_cast<double>(load) / peak;
            n += 1.0;
        }
    }
    const double mean = sum / n;
    double squares = 0.0;
    for (const float load : loads) {
        if (binOf(load) < split) {
            const double deviation = static_cast<double>(load) / peak - mean;
            squares += deviation * deviation;
        }
    }
    const double level = mean + kBackgroundSpread * std::sqrt(squares / n);
    return peak * std::min(level, static_cast<double>(split) / kHistogramBins);
}

} // namespace teleta::contact
