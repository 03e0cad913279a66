// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace teleta::study {

/// An interval, ends included.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};

/// Wilson's score interval of a proportion. With z the normal quantile it has the roots of
///   (1 + z^2/n) p^2 - (2 x/n + z^2/n) p + (x/n)^2 = 0.
/// successes: 0 .. trials; confidence: 0 .. 1, ends excluded. Empty without trials and out of these ranges.
/// Thread: any. Source: Wilson 1927, doi:10.1080/01621459.1927.10502953.
[[nodiscard]] std::optional<Interval> wilsonInterval(std::int64_t successes, std::int64_t trials,
                                                     double confidence = 0.95);

/// The same of a mean of shares, 0 .. 1, each of one of so many runs. A share of several trials varies no
/// more between runs than one trial does, so the interval is rather too wide than too narrow. Empty out of
/// the range.
[[nodiscard]] std::optional<Interval> wilsonShareInterval(double meanShare, std::int64_t runs,
                                                          double confidence = 0.95);

/// Clopper's and Pearson's interval of a proportion: the quantiles a/2 of Beta(x, n-x+1) and 1-a/2 of
/// Beta(x+1, n-x), a = 1 - confidence; 0 and 1 where x is 0 or n. Ranges and refusals as wilsonInterval.
/// Thread: any. Source: Clopper and Pearson 1934, doi:10.1093/biomet/26.4.404.
[[nodiscard]] std::optional<Interval> clopperPearsonInterval(std::int64_t successes, std::int64_t trials,
                                                             double confidence = 0.95);

/// Probability of at least this many successes by chance: P(X >= x), X ~ Bin(n, chance) (exact one-sided
/// test). chance: 0 .. 1. Empty without trials and out of the ranges. Thread: any.
[[nodiscard]] std::optional<double> chanceProbability(std::int64_t successes, std::int64_t trials,
                                                      double chance);

/// Mean over participants and its interval from Student's t with n-1 degrees of freedom.
struct GroupMean {
    double mean = 0.0;
    std::optional<double> standardDeviation; ///< with n-1; empty for one participant
    std::optional<Interval> interval;        ///< empty for one participant; of zero width when all agree
    bool isCut = false;                      ///< groupShare() has cut the interval off at 0 or 1

    /// All participants have the same value, so that the interval says nothing of the spread among others.
    [[nodiscard]] bool allAgree() const { return standardDeviation && *standardDeviation == 0.0; }
};

/// values: one per participant. Empty without values or if one is not finite. Thread: any.
[[nodiscard]] std::optional<GroupMean> groupMean(std::span<const double> values, double confidence = 0.95);

/// The same of shares, which are 0 .. 1: the interval is cut off there. It holds the true mean as often as
/// the whole one, since the mean is a share too. values: each 0 .. 1, else empty. Thread: any.
[[nodiscard]] std::optional<GroupMean> groupShare(std::span<const double> values, double confidence = 0.95);

/// Median; the mean of the middle two for an even number. Empty without values or if one is not finite.
/// Thread: any.
[[nodiscard]] std::optional<double> median(std::span<const double> values);

} // namespace teleta::study
