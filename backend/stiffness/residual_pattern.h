// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace teleta::stiffness {

/// By how much the variance of a fitted line grows because the residuals depend on each other: samples over
/// independent samples, >= 1. The larger of
///   (1 + r) / (1 - r)          r the correlation of neighbours, without its bias of -(1 + 4 r) / n
///   variance of block means    over that of independent samples, with 8, 16 and 32 blocks
/// each only where it is significant (99.99 %). residuals: in order of time, about a fit with so many
/// parameters. 1 for fewer than 16 or for residuals of zero. Thread: any (pure). Source: Bartlett 1946;
/// Conway, Some Tactical Problems in Digital Simulation, 1963 (batch means).
[[nodiscard]] double varianceInflation(std::span<const double> residuals, int parameters);

/// How a curve y(x) bends.
struct Bend {
    double change = 0.0; ///< slope at the last x minus that at the first, over the mean slope
    double se = 0.0;     ///< standard error of change, for independent residuals
    double firstSlope = 0.0;
    double lastSlope = 0.0;
    double residualSd = 0.0;
};

/// Fits y = a + b x + c x^2 by least squares. Empty for fewer than 8 points, or when x does not spread or b
/// is zero. residuals: so many as points, written when not empty. Thread: any (pure).
[[nodiscard]] std::optional<Bend> fitBend(std::span<const double> x, std::span<const double> y,
                                          std::span<double> residuals = {});

/// Distance between the values that a reading can take; empty when it has no steps that the values show.
/// values: finite, in any order. Thread: any (pure).
[[nodiscard]] std::optional<double> readingStep(std::span<const double> values);

} // namespace teleta::stiffness
