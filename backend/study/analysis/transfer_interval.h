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
    miller,      ///< (R-1)(C-1) / (2 n ln 2) for R rows and C columns that occur
    occupied,    ///< (K-R-C+1) / (2 n ln 2) for K cells that occur: Miller and Madow
    jackknife,   ///< (n - 1) (mean of the transfers with one trial left out - measured)
    grassberger, ///< his estimate of the entropies, see transferBias()
};

/// What is taken off, in bit. Grassberger's estimate of n T' ln 2, over patterns i and answers j:
///   n ln n - sum_j n_j G(n_j) - sum_i (n_i ln n_i - sum_j n_ij G(n_ij))
///   G(n) = psi(n) + (-1)^n (psi((n+1)/2) - psi(n/2)) / 2
/// 0 without trials. Thread: any. Sources: Miller 1955, Note on the bias of information estimates; Panzeri
/// and Treves 1996, Network 7, 87 (cells that occur); Grassberger 2003, arXiv:physics/0307138.
[[nodiscard]] double transferBias(const ConfusionMatrix& matrix, TransferBias bias);

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
