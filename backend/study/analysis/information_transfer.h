// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/analysis/proportion.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace teleta::study {

/// Information that the answers of one matrix carry about the patterns, in bit.
struct InformationTransfer {
    double measured_bit = 0.0;  ///< as counted; too high on average
    double corrected_bit = 0.0; ///< without bias; can be below 0
    double bias_bit = 0.0;      ///< measured - corrected
    bool fewTrials = false;     ///< n < 5 k^2 for k patterns: even the corrected value is rough
};

/// Maximum-likelihood estimate
///   T = sum n_ij/n log2(n_ij n / (n_i n_j))
/// NONE is an answer like any other. Absolute error < 1e-14 bit. Empty without trials. Thread: any. Source:
/// Miller and Nicely 1955, doi:10.1121/1.1907526.
[[nodiscard]] std::optional<double> measuredTransfer(const ConfusionMatrix& matrix);

/// Transfer with one trial left out, on average over all trials, and with it the jackknife's estimate
///   n T - (n - 1) mean T_-i = mean(d(n_ij) - d(n_i) - d(n_j)) + d(n),  d(x) = x log2 x - (x-1) log2(x-1)
/// by the second form, which loses no digits to many trials. Empty for fewer than two trials. Thread: any.
/// Source: Quenouille 1956, doi:10.1093/biomet/43.3-4.353.
[[nodiscard]] std::optional<double> jackknifeTransfer(const ConfusionMatrix& matrix);

/// measuredTransfer(), and without its bias by the smaller of it and jackknifeTransfer(): the mean of the
/// measured transfer is never below the true one, since the transfer is convex in the shares of the answers.
/// For several participants see studyTransfer(). alternatives: number of patterns, if the matrix has fewer.
/// Empty without trials. Thread: any.
[[nodiscard]] std::optional<InformationTransfer> informationTransfer(const ConfusionMatrix& matrix,
                                                                     std::size_t alternatives = 0);

/// Expected measuredTransfer() if all answers were guesses, equally likely among k patterns
/// (those of the matrix, or the alternatives if these are more), with the row totals of this matrix. With
/// g(m) = E[X log2 X], X ~ Bin(m, 1/k):
///   (sum_i (k g(n_i) - n_i log2 n_i) - k g(n) + n log2 n) / n
/// Exact except for rounding. Empty without trials. Thread: any.
[[nodiscard]] std::optional<double> guesserTransfer(const ConfusionMatrix& matrix,
                                                    std::size_t alternatives = 0);

/// Percentile bootstrap of the measured transfer of the pooled matrix: participants are drawn with
/// replacement. One matrix per participant, all of the same size. resamples: at least 1. The same seed gives
/// the same interval everywhere. Empty for fewer than two participants or without trials. Thread: any.
/// Source: Efron 1979, doi:10.1214/aos/1176344552.
[[nodiscard]] std::optional<Interval> bootstrapTransfer(std::span<const ConfusionMatrix> participants,
                                                        std::size_t resamples, std::uint64_t seed,
                                                        double confidence = 0.95);

} // namespace teleta::study
