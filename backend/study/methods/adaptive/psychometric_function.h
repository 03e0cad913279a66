// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace teleta::study {

/// How the share of correct (or "yes") answers rises from the guess rate to one less the lapse rate.
enum class RiseShape {
    gauss,    ///< F = Phi((x - t) / s)
    logistic, ///< F = 1 / (1 + exp(-(x - t) / s))
    weibull,  ///< F = 1 - 2^(-(x / t)^b), 0 for x <= 0
};

/// "gauss", "logistic", "weibull", as in files. Thread: any.
[[nodiscard]] const char* toString(RiseShape shape);
/// The inverse; empty for any other word. Thread: any.
[[nodiscard]] std::optional<RiseShape> riseShapeOf(std::string_view word);

/// F of the shape, 0 .. 1, at a level; one half at the threshold. threshold: for weibull > 0; spread: s, or
/// the slope b of weibull, > 0. Levels, threshold and s have the same unit. Thread: any. Source: Wichmann and
/// Hill 2001, doi:10.3758/BF03194544; Weibull's usual a is t / (ln 2)^(1/b).
[[nodiscard]] double riseOf(RiseShape shape, double level, double threshold, double spread);

/// Psi(x) = g + (1 - g - l) F(x). The threshold is where F is one half, whatever g and l are.
struct PsychometricFunction {
    RiseShape shape = RiseShape::weibull;
    double threshold = 1.0;
    double spread = 1.0; ///< s, or the slope b of weibull
    double guess = 0.0;  ///< g: share without any stimulus, 0 .. 1
    double lapse = 0.0;  ///< l: share of mistakes however strong the stimulus is, 0 .. 1

    /// Psi, 0 .. 1. Thread: any.
    [[nodiscard]] double shareAt(double level) const {
        return guess + (1.0 - guess - lapse) * riseOf(shape, level, threshold, spread);
    }
    /// The level where Psi has this value; empty unless g < share < 1 - l. Thread: any.
    [[nodiscard]] std::optional<double> levelOf(double share) const;
};

} // namespace teleta::study
