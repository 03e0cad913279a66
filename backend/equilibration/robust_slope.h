// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace teleta::equilibration {

struct Slope {
    double slope = 0.0;
    double error = 0.0; ///< standard error for noise that is independent between values
    double noise =
        0.0; ///< standard deviation of y about the line; 0 when more than half of the points lie on it
};

/// Slope b of y = b x through the origin: least squares with Huber's weights (c = 1.345) and the median
/// absolute deviation as scale, started from the median of y / x. The standard error is that of an M
/// estimate,
///   sqrt(sum psi^2 / (n - 1) / sum x^2) / mean(psi'),  psi: the residual, at most c scales.
/// x, y: same size, at least one entry, finite; x not 0. buffer: working memory, is overwritten. Source: P.
/// J. Huber, Robust Statistics, section 7.8. Thread: any (pure).
[[nodiscard]] Slope robustSlope(std::span<const double> x, std::span<const double> y,
                                std::vector<double>& buffer);

} // namespace teleta::equilibration
