// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/comparison/rank_test.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <vector>

namespace teleta::study {

namespace {

/// Twice the mean ranks, so that they are whole. Values closer than `tie` to the one before share a rank.
std::vector<long long> doubledRanks(const std::vector<double>& values, double tie) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<long long> ranks(values.size());
    for (std::size_t from = 0; from < order.size();) {
        std::size_t to = from + 1;
        while (to < order.size() && values[order[to]] - values[order[to - 1]] <= tie)
            ++to;
        // Ranks from+1 .. to have the mean (from + 1 + to) / 2.
        for (std::size_t i = from; i < to; ++i)
            ranks[order[i]] = static_cast<long long>(from + 1 + to);
        from = to;
    }
    return ranks;
}

/// P(W <= bound) where each doubled rank is added or not with probability 1/2.
double shareUpTo(const std::vector<long long>& ranks, long long bound) {
    std::vector<double> share{1.0};
    share.resize(static_cast<std::size_t>(bound) + 1, 0.0);
    for (const long long rank : ranks) {
        for (long long sum = bound; sum >= 0; --sum) {
            const auto at = static_cast<std::size_t>(sum);
            share[at] = 0.5 * (share[at] + (sum >= rank ? share[static_cast<std::size_t>(sum - rank)] : 0.0));
        }
    }
    return std::accumulate(share.begin(), share.end(), 0.0);
}

} // namespace

tl::expected<SignedRankTest, Refusal> signedRankTest(std::span<const double> first,
                                                     std::span<const double> second) {
    std::vector<double> differences;
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        if (std::isnan(first[i]) || std::isnan(second[i]))
            continue;
        if (std::isinf(first[i]) || std::isinf(second[i]))
            return tl::unexpected(Refusal::notFinite);
        largest = std::max({largest, std::abs(first[i]), std::abs(second[i])});
        differences.push_back(first[i] - second[i]);
    }
    if (differences.empty())
        return tl::unexpected(Refusal::noData);
    const double tie = kTieTolerance * largest;
    std::vector<double> sizes;
    for (const double d : differences)
        sizes.push_back(std::abs(d) <= tie ? 0.0 : std::abs(d));
    const std::vector<long long> all = doubledRanks(sizes, tie);
    SignedRankTest test;
    test.participants = differences.size();
    std::vector<long long> ranks;
    long long positive = 0;
    long long negative = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        if (sizes[i] == 0.0) {
            ++test.zeros;
            continue;
        }
        ranks.push_back(all[i]);
        (differences[i] > 0.0 ? positive : negative) += all[i];
    }
    if (ranks.empty())
        return tl::unexpected(Refusal::noVariance);
    test.positive = 0.5 * static_cast<double>(positive);
    test.negative = 0.5 * static_cast<double>(negative);
    test.rankBiserial = (test.positive - test.negative) / (test.positive + test.negative);
    test.isExact = ranks.size() <= kMostExactRanks;
    if (test.isExact) {
        test.p = std::min(1.0, 2.0 * shareUpTo(ranks, std::min(positive, negative)));
    } else {
        double squares = 0.0;
        for (const long long rank : ranks)
            squares += 0.25 * static_cast<double>(rank) * static_cast<double>(rank);
        const double z = std::abs(test.positive - test.negative) / 2.0 / std::sqrt(squares / 4.0);
        test.p = std::min(1.0, 2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), z)));
    }
    return test;
}

tl::expected<FriedmanTest, Refusal> friedmanTest(const ParticipantCells& cells) {
    if (cells.empty())
        return tl::unexpected(Refusal::noData);
    const std::size_t levels = cells.front().size();
    if (levels < 2)
        return tl::unexpected(Refusal::tooFewLevels);
    double largest = 0.0;
    for (const std::vector<double>& row : cells) {
        if (row.size() != levels)
            return tl::unexpected(Refusal::badShape);
        for (const double v : row) {
            if (std::isinf(v))
                return tl::unexpected(Refusal::notFinite);
            if (!std::isnan(v))
                largest = std::max(largest, std::abs(v));
        }
    }
    FriedmanTest test;
    std::vector<long long> sums(levels, 0);
    double squares = 0.0;
    for (const std::vector<double>& row : cells) {
        if (std::ranges::any_of(row, [](double v) { return std::isnan(v); }))
            continue;
        ++test.participants;
        const std::vector<long long> ranks = doubledRanks(row, kTieTolerance * largest);
        for (std::size_t j = 0; j < levels; ++j) {
            sums[j] += ranks[j];
            squares += 0.25 * static_cast<double>(ranks[j]) * static_cast<double>(ranks[j]);
        }
    }
    if (test.participants < 2)
        return tl::unexpected(Refusal::oneParticipant);
    const auto n = static_cast<double>(test.participants);
    const auto k = static_cast<double>(levels);
    const double spread = squares - n * k * (k + 1.0) * (k + 1.0) / 4.0;
    if (spread <= 0.0)
        return tl::unexpected(Refusal::noVariance);
    double between = 0.0;
    for (const long long sum : sums) {
        const double away = 0.5 * static_cast<double>(sum) - n * (k + 1.0) / 2.0;
        between += away * away;
    }
    test.chi2 = (k - 1.0) * between / spread;
    test.df = k - 1.0;
    test.p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(test.df), test.chi2));
    test.w = test.chi2 / (n * (k - 1.0));
    return test;
}

} // namespace teleta::study
