// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/transfer_interval.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/digamma.hpp>
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

/// n G(n) of Grassberger's estimate.
double timesG(std::int64_t count) {
    if (count == 0)
        return 0.0;
    const auto n = static_cast<double>(count);
    const double half = 0.5 * (boost::math::digamma(0.5 * (n + 1.0)) - boost::math::digamma(0.5 * n));
    return n * (boost::math::digamma(n) + (count % 2 == 0 ? half : -half));
}

double grassbergerTransfer_bit(const ConfusionMatrix& matrix) {
    const auto n = static_cast<double>(matrix.total());
    double nats = n * std::log(n);
    for (std::size_t j = 0; j < matrix.columns(); ++j)
        nats -= timesG(matrix.columnTotal(j));
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        const auto row = static_cast<double>(matrix.rowTotal(i));
        nats -= row > 0.0 ? row * std::log(row) : 0.0;
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            nats += timesG(matrix.count(i, j));
    }
    return nats / n / std::numbers::ln2;
}

} // namespace

double transferBias(const ConfusionMatrix& matrix, TransferBias bias) {
    const std::optional<double> measured_bit = measuredTransfer(matrix);
    if (!measured_bit || bias == TransferBias::none)
        return 0.0;
    if (bias == TransferBias::jackknife)
        return *measured_bit - jackknifeTransfer(matrix).value_or(*measured_bit);
    if (bias == TransferBias::grassberger)
        return *measured_bit - grassbergerTransfer_bit(matrix);
    double rows = 0.0;
    double columns = 0.0;
    double cells = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        rows += matrix.rowTotal(i) > 0 ? 1.0 : 0.0;
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            cells += matrix.count(i, j) > 0 ? 1.0 : 0.0;
    }
    for (std::size_t j = 0; j < matrix.columns(); ++j)
        columns += matrix.columnTotal(j) > 0 ? 1.0 : 0.0;
    const double freedom =
        bias == TransferBias::miller ? (rows - 1.0) * (columns - 1.0) : cells - rows - columns + 1.0;
    return freedom / (2.0 * static_cast<double>(matrix.total()) * std::numbers::ln2);
}

std::optional<Interval> asymptoticTransfer(const ConfusionMatrix& matrix, TransferBias bias,
                                           double confidence) {
    const std::optional<double> measured_bit = measuredTransfer(matrix);
    if (!measured_bit || !(confidence > 0.0 && confidence < 1.0))
        return std::nullopt;
    const auto n = static_cast<double>(matrix.total());
    const double variance = varianceOfLogs(matrix, *measured_bit) / n;
    const double z = -boost::math::quantile(boost::math::normal(), (1.0 - confidence) / 2.0);
    const double middle_bit = *measured_bit - transferBias(matrix, bias);
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
    const double shift_bit = 2.0 * transferBias(pooled, TransferBias::miller);
    return Interval{std::max(0.0, measured->low - shift_bit), std::max(0.0, measured->high - shift_bit)};
}

} // namespace teleta::study
