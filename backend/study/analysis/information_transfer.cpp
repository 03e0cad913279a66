// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/information_transfer.h"

#include "backend/core/quantile.h"
#include "backend/core/random_stream.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace teleta::study {

namespace {

double timesLog2(double x) {
    return x > 0.0 ? x * std::log2(x) : 0.0;
}

/// E[X log2 X] of X ~ Bin(trials, share), 0 < share < 1.
double expectedTimesLog2(std::int64_t trials, double share) {
    const auto n = static_cast<double>(trials);
    // Terms farther from the mean do not affect a double (Bernstein's inequality).
    const double reach = 9.0 * std::sqrt(n * share) + 30.0;
    const double last = std::min(n, std::floor(n * share + reach));
    double sum = 0.0;
    for (double x = std::max(1.0, std::ceil(n * share - reach)); x <= last; x += 1.0) {
        const double logProbability = std::lgamma(n + 1.0) - std::lgamma(x + 1.0) - std::lgamma(n - x + 1.0) +
                                      x * std::log(share) + (n - x) * std::log1p(-share);
        sum += std::exp(logProbability) * timesLog2(x);
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

std::optional<double> guesserTransfer(const ConfusionMatrix& matrix, std::size_t alternatives) {
    const auto n = static_cast<double>(matrix.total());
    if (!(n > 0.0))
        return std::nullopt;
    const std::size_t patterns = std::max(matrix.patterns(), alternatives);
    const auto k = static_cast<double>(patterns);
    if (patterns == 1)
        return 0.0;
    double sum_bit = timesLog2(n) - k * expectedTimesLog2(matrix.total(), 1.0 / k);
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        const std::int64_t row = matrix.rowTotal(i);
        sum_bit += k * expectedTimesLog2(row, 1.0 / k) - timesLog2(static_cast<double>(row));
    }
    return std::max(0.0, sum_bit / n);
}

std::optional<double> measuredTransfer(const ConfusionMatrix& matrix) {
    const std::int64_t trials = matrix.total();
    if (trials == 0)
        return std::nullopt;
    const auto n = static_cast<double>(trials);
    std::vector<double> columnShares(matrix.columns());
    for (std::size_t j = 0; j < matrix.columns(); ++j)
        columnShares[j] = static_cast<double>(matrix.columnTotal(j)) / n;
    double sum_bit = 0.0;
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        const double rowShare = static_cast<double>(matrix.rowTotal(i)) / n;
        for (std::size_t j = 0; j < matrix.columns(); ++j) {
            const double share = static_cast<double>(matrix.count(i, j)) / n;
            if (share > 0.0)
                sum_bit += share * std::log2(share / rowShare / columnShares[j]);
        }
    }
    return std::max(0.0, sum_bit);
}

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

std::optional<InformationTransfer> informationTransfer(const ConfusionMatrix& matrix,
                                                       std::size_t alternatives) {
    const std::optional<double> measured_bit = measuredTransfer(matrix);
    if (!measured_bit)
        return std::nullopt;
    const auto n = static_cast<double>(matrix.total());
    InformationTransfer transfer;
    transfer.measured_bit = *measured_bit;
    transfer.corrected_bit = std::min(*measured_bit, jackknifeTransfer(matrix).value_or(*measured_bit));
    transfer.bias_bit = transfer.measured_bit - transfer.corrected_bit;
    const auto k = static_cast<double>(std::max(matrix.patterns(), alternatives));
    transfer.fewTrials = n < 5.0 * k * k;
    return transfer;
}

std::optional<Interval> bootstrapTransfer(std::span<const ConfusionMatrix> participants,
                                          std::size_t resamples, std::uint64_t seed, double confidence) {
    if (participants.size() < 2 || resamples == 0 || !(confidence > 0.0 && confidence < 1.0))
        return std::nullopt;
    core::RandomStream random(seed);
    std::vector<double> values_bit;
    values_bit.reserve(resamples);
    for (std::size_t i = 0; i < resamples; ++i) {
        ConfusionMatrix pooled(participants.front().patterns());
        for (std::size_t j = 0; j < participants.size(); ++j)
            pooled.add(participants[static_cast<std::size_t>(random.below(participants.size()))]);
        if (const std::optional<double> transfer_bit = measuredTransfer(pooled))
            values_bit.push_back(*transfer_bit);
    }
    if (values_bit.empty())
        return std::nullopt;
    std::ranges::sort(values_bit);
    const double tail = (1.0 - confidence) / 2.0;
    return Interval{core::quantileOf(values_bit, tail), core::quantileOf(values_bit, 1.0 - tail)};
}

} // namespace teleta::study
