// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/transfer_interval.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

namespace teleta::study {

namespace {

/// Variance of the logarithms whose weighted mean is the transfer.
double varianceOfLogs(const ConfusionMatrix& matrix, double transfer_bit) {
    const auto n = static_cast<double>(matrix.total());
    double sum = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j) {
            const auto count = static_cast<double>(matrix.count(i, j));
            if (count <= 0.0)
                continue;
            const double off_bit = std::log2(count * n / static_cast<double>(matrix.rowTotal(i)) /
                                             static_cast<double>(matrix.columnTotal(j))) -
                                   transfer_bit;
            sum += count / n * off_bit * off_bit;
        }
    return sum;
}

/// x log2 x - (x - 1) log2(x - 1): what the last of x trials adds to n T.
double lastTrial_bit(std::int64_t trials) {
    if (trials < 2)
        return 0.0;
    const auto x = static_cast<double>(trials);
    return std::log2(x) - (x - 1.0) * std::log1p(-1.0 / x) / std::numbers::ln2;
}

} // namespace

std::optional<double> jackknifeTransfer(const ConfusionMatrix& matrix) {
    const std::int64_t trials = matrix.total();
    if (trials < 2)
        return std::nullopt;
    double sum_bit = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            if (const std::int64_t count = matrix.count(i, j); count > 0)
                sum_bit +=
                    static_cast<double>(count) * (lastTrial_bit(count) - lastTrial_bit(matrix.rowTotal(i)) -
                                                  lastTrial_bit(matrix.columnTotal(j)));
    return sum_bit / static_cast<double>(trials) + lastTrial_bit(trials);
}

std::optional<Interval> asymptoticTransfer(const ConfusionMatrix& matrix, TransferBias bias,
                                           double confidence) {
    const std::optional<InformationTransfer> transfer = informationTransfer(matrix);
    if (!transfer || !(confidence > 0.0 && confidence < 1.0))
        return std::nullopt;
    const auto n = static_cast<double>(matrix.total());
    const double measured_bit = transfer->measured_bit;
    const double variance = varianceOfLogs(matrix, measured_bit) / n;
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
