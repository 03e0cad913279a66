// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/unevenness.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace teleta::equilibration {

namespace {

std::optional<double> relativeDeviation(const std::vector<double>& values) {
    if (values.size() < 2)
        return std::nullopt;
    const auto count = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values)
        mean += value / count;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    if (!(mean > 0.0))
        return std::nullopt;
    return std::sqrt(squares / (count - 1.0)) / mean;
}

} // namespace

std::optional<Unevenness> unevenness(std::span<const float> loads, std::span<const float> gains,
                                     double threshold) {
    if (!gains.empty() && gains.size() != loads.size())
        return std::nullopt;
    std::vector<double> with;
    std::vector<double> without;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const double gain = gains.empty() ? 1.0 : static_cast<double>(gains[i]);
        const double load = static_cast<double>(loads[i]);
        if (!(std::isfinite(gain) && gain > 0.0 && std::isfinite(load) && load >= threshold))
            continue;
        with.push_back(load);
        without.push_back(load / gain);
    }
    const auto after = relativeDeviation(with);
    const auto before = relativeDeviation(without);
    if (!after || !before)
        return std::nullopt;
    return Unevenness{.withGains = *after, .without = *before};
}

} // namespace teleta::equilibration
