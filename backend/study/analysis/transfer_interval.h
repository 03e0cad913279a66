// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/information_transfer.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace teleta::study {

/// What is taken off the measured transfer, which is too high on average.
enum class TransferBias {
    none,
    miller,    ///< (R-1)(C-1) / (2 n ln 2), see InformationTransfer
    jackknife, ///< (n - 1) (mean of the transfers with one trial left out - measured)
};

/// Transfer with one trial left out, on average over all trials, and with it the jackknife's estimate
///   n T - (n - 1) mean T_-i = mean(d(n_ij) - d(n_i) - d(n_j)) + d(n),  d(x) = x log2 x - (x-1) log2(x-1)
/// by the second form, which loses no digits to many trials. Empty for fewer than two trials. Thread: any.
/// Source: Quenouille 1956, doi:10.1093/biomet/43.3-4.353.
[[nodiscard]] std::optional<double> jackknifeTransfer(const ConfusionMatrix& matrix);

/// Interval of the true transfer by the normal distribution, its standard error by the delta method:
///   T' +- z se,  se^2 = (sum n_ij/n log2^2(n_ij n / (n_i n_j)) - T^2) / n,  T' = T - bias
/// and not below 0. Trials count as independent. Empty without trials and for a confidence outside of 0 .. 1.
/// Thread: any. Source: Agresti, Categorical Data Analysis, section 3.1 (delta method).
[[nodiscard]] std::optional<Interval> asymptoticTransfer(const ConfusionMatrix& matrix, TransferBias bias,
                                                         double confidence = 0.95);

/// bootstrapTransfer() moved down by twice Miller's bias, once for the measured transfer and once for that
/// of the resamples, which are drawn from what was measured; not below 0. Empty as bootstrapTransfer.
[[nodiscard]] std::optional<Interval>
correctedBootstrapTransfer(std::span<const ConfusionMatrix> participants, std::size_t resamples,
                           std::uint64_t seed, double confidence = 0.95);

} // namespace teleta::study
