// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace teleta::study {

/// Answers at one time from burst to burst.
struct OnsetCount {
    double onset_s = 0.0;
    double trials = 0.0; ///< > 0
    double yes = 0.0;    ///< 0 .. trials
};

/// Why there is no best onset.
enum class OnsetDoubt {
    none,
    tooFewTimes, ///< fewer than three different ones
    noTop,       ///< the parabola opens upwards, or the answers do not determine one
    outside,     ///< its top lies outside the times that were shown
};

/// The time at which most answers were yes.
struct BestOnset {
    OnsetDoubt doubt = OnsetDoubt::none;
    double onset_s = 0.0; ///< 0 with a doubt
    double se_s = 0.0;    ///< standard error by the delta method
    double low_s = 0.0;   ///< 95 % interval: 1.959964 standard errors to either side
    double high_s = 0.0;
    double deviance = 0.0; ///< of the fit from the shares
};

/// Fits Phi^-1(share) = b0 + b1 x + b2 x^2 by maximum likelihood (iteratively reweighted least squares); the
/// top is at -b1 / (2 b2). Thread: any (pure). Source: McCullagh and Nelder 1989, ISBN 978-0-412-31760-6.
[[nodiscard]] BestOnset bestOnset(std::span<const OnsetCount> counts);

} // namespace teleta::study
