// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/laws.h"

#include "backend/core/bracelet/tactors.h"

#include <algorithm>
#include <cmath>

namespace teleta::pattern {

std::optional<double> ringBurst_s(int turns, double duration_s) {
    if (turns < 1 || !std::isfinite(duration_s))
        return std::nullopt;
    const double onset_s = duration_s / (static_cast<double>(core::kTactors) * turns);
    const double burst_s = (onset_s - kOnsetOffset_s) / kOnsetPerBurst;
    return burst_s > 0.0 ? std::optional(burst_s) : std::nullopt;
}

std::pair<double, double> phantomIntensities(double balance, double intensity) {
    if (std::isnan(balance))
        return {0.0, 0.0};
    const double b = std::clamp(balance, 0.0, 1.0);
    return {std::sqrt(1.0 - b) * intensity, std::sqrt(b) * intensity};
}

} // namespace teleta::pattern
