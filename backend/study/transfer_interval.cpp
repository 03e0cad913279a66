// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/transfer_interval.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace teleta::study {

namespace {

/// Sum of the squares of the logarithms, weighted as the transfer is.
double meanSquaredLog(const ConfusionMatrix& matrix) {
    const auto n = static_cast<double>(matrix.total());
    double sum = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j) {
            const auto count = static_cast<double>(matrix.count(i, j));
            if (count <= 0.0)
                continue;
            const double bit = std::log2(count * n / static_cast<double>(matrix.rowTotal(i)) /
                                         static_cast<double>(matrix.columnTotal(j)));
            sum += count / n * bit * bit;
        }
    return sum;
}

} // namespace

std::optional<double> jackknifeTransfer(const ConfusionMatrix& matrix) {
    const std::int64_t trials = matrix.total();
    if (trials < 2)
        return std::nullopt;
    const auto n = static_cast<double>(trials);
    double mean_bit = 0.0;
    ConfusionMatrix others = matrix;
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j) {
            const std::int64_t count = matrix.count(i, j);
            if (count == 0)
                continue;
            others.add(i, j, -1);
            mean_bit += static_cast<double>(count) / n * informationTransfer(others)->measured_bit;
            others.add(i, j, 1);
        }
    return n * informationTransfer(matrix)->measured_bit - (n - 1.0) * mean_bit;
}

std::optional<Interval> asymptoticTransfer(const ConfusionMatrix& matrix, TransferBias bias,
                                           double confidence) {
    const std::optional<InformationTransfer> transfer = informationTransfer(matrix);
    if (!transfer || !(confidence > 0.0 && confidence < 1.0))
        return std::nullopt;
    const auto n = static_cast<double>(matrix.total());
    const double measured_bit = transfer->measured_bit;
    const double variance = std::max(0.0, meanSquaredLog(matrix) - measured_bit * measured_bit) / n;
    const double z = -boost::math::quantile(boost::math::normal(), (1.0 - confidence) / 2.0);
    const double middle_bit = bias == TransferBias::none ? measured_bit
                              : bias == TransferBias::miller
                                  ? transfer->corrected_bit
                                  : jackknifeTransfer(matrix).value_or(measured_bit);
    const double half_bit = z * std::sqrt(variance);
    return Interval{std::max(0.0, middle_bit - half_bit), std::max(0.0, middle_bit + half_bit)};
}

std::optional<Interval> correctedBootstrapTransfer(std::span<const ConfusionMatrix> participants,
                                                   std::size_t resamples, std::uint64_t seed,
                                                   double confidence) {
    const std::optional<Interval> measured = bootstrapTransfer(participants, resamples, seed, confidence);
    if (!measured)
        return std::nullopt;
    ConfusionMatrix pooled(participants.front().patterns());
    for (const ConfusionMatrix& participant : participants)
        pooled.add(participant);
    const double shift_bit = 2.0 * informationTransfer(pooled)->bias_bit;
    return Interval{std::max(0.0, measured->low - shift_bit), std::max(0.0, measured->high - shift_bit)};
}

} // namespace teleta::study
