// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/robust_slope.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace teleta::equilibration {

namespace {

constexpr double kHuber = 1.345;
constexpr double kNormalMad = 1.482602218505602; // 1 / the upper quartile of the normal distribution
constexpr int kMostSteps = 50;

} // namespace

Slope robustSlope(std::span<const double> x, std::span<const double> y, std::vector<double>& buffer) {
    const std::size_t n = x.size();
    buffer.resize(n);
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        buffer[i] = y[i] / x[i];
        largest = std::max(largest, std::abs(y[i]));
    }
    Slope result{.slope = core::medianOf(buffer)};
    // Residuals within the rounding error count as zero.
    const double exact = 4.0 * std::numeric_limits<double>::epsilon() * largest;
    double influence = 0.0; // sum of squares of the bounded residuals
    double within = 0.0;    // how many residuals are not bounded
    double xx = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
        for (std::size_t i = 0; i < n; ++i)
            buffer[i] = std::abs(y[i] - result.slope * x[i]);
        result.noise = kNormalMad * core::medianOf(buffer);
        if (result.noise <= exact)
            result.noise = 0.0;
        const double bound = std::max(kHuber * result.noise, exact);
        double xy = 0.0;
        double weighted = 0.0;
        influence = within = xx = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double residual = std::abs(y[i] - result.slope * x[i]);
            const double weight = residual <= bound ? 1.0 : bound / residual;
            weighted += weight * x[i] * x[i];
            xy += weight * x[i] * y[i];
            influence += weight * weight * residual * residual;
            within += residual <= bound ? 1.0 : 0.0;
            xx += x[i] * x[i];
        }
        const double before = result.slope;
        result.slope = xy / weighted;
        if (std::abs(result.slope - before) <= 1e-12 * std::abs(before))
            break;
    }
    // At least half of the residuals are unbounded: the scale comes from their median.
    const auto count = static_cast<double>(n);
    if (n > 1)
        result.error = std::sqrt(influence / (count - 1.0) / xx) * count / within;
    return result;
}

} // namespace teleta::equilibration
