// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"
#include "backend/study/analysis/proportion.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace teleta::study {

/// Information that the answers carry about the patterns, in bit.
struct InformationTransfer {
    double measured_bit = 0.0;  ///< as counted; too high by the bias on average
    double bias_bit = 0.0;      ///< (R-1)(C-1) / (2 n ln 2)
    double corrected_bit = 0.0; ///< measured - bias; below 0 where there is less than chance shows
    bool fewTrials = false;     ///< n < 5 k^2 for k patterns: even the corrected value is rough
};

/// Maximum-likelihood estimate and its first-order bias:
///   T = sum n_ij/n log2(n_ij n / (n_i n_j)),  bias = (R-1)(C-1) / (2 n ln 2)
/// with R and C the rows and columns that occur; NONE is an answer like any other. Absolute error < 1e-14
/// bit. alternatives: number of patterns, if the matrix has fewer. Empty without trials. Thread: any. Source:
/// Miller and Nicely 1955, doi:10.1121/1.1907526; bias: Miller 1955.
[[nodiscard]] std::optional<InformationTransfer> informationTransfer(const ConfusionMatrix& matrix,
                                                                     std::size_t alternatives = 0);

/// Expected informationTransfer().measured_bit if all answers were guesses, equally likely among k patterns
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
