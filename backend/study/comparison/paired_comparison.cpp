// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/comparison/paired_comparison.h"

#include "backend/study/comparison/effect_size.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace teleta::study {

namespace {

constexpr double kPairConfidence = 0.95;

double varianceOf(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0.0;
    for (const double v : values)
        squares += (v - mean) * (v - mean);
    return squares / (n - 1.0);
}

} // namespace

PairedComparison comparePaired(std::span<const double> first, std::span<const double> second) {
    PairedComparison comparison{0, {}, tl::unexpected(Refusal::oneParticipant)};
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        if (std::isinf(first[i]) || std::isinf(second[i])) {
            comparison.test = tl::unexpected(Refusal::notFinite);
            return comparison;
        }
        if (!std::isnan(first[i]) && !std::isnan(second[i]))
            largest = std::max({largest, std::abs(first[i]), std::abs(second[i])});
    }
    // Scaled, so that neither differences nor squares overflow or underflow.
    const double scale = largest > 0.0 ? largest : 1.0;
    std::vector<double> a;
    std::vector<double> b;
    std::vector<double> differences;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        if (std::isnan(first[i]) || std::isnan(second[i]))
            continue;
        a.push_back(first[i] / scale);
        b.push_back(second[i] / scale);
        differences.push_back(a.back() - b.back());
    }
    const auto n = static_cast<double>(differences.size());
    comparison.participants = differences.size();
    if (differences.empty())
        return comparison;
    const double mean = std::accumulate(differences.begin(), differences.end(), 0.0) / n;
    comparison.difference = mean * scale;
    if (differences.size() < 2)
        return comparison;
    const double deviation = std::sqrt(varianceOf(differences));
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    if (deviation <= kRounding) {
        const bool isZero = std::abs(mean) <= kRounding;
        if (isZero)
            comparison.difference = 0.0;
        comparison.test = tl::unexpected(isZero ? Refusal::noVariance : Refusal::noErrorVariance);
        return comparison;
    }
    PairedTest test;
    test.df = n - 1.0;
    const double error = deviation / std::sqrt(n);
    test.t = mean / error;
    const boost::math::students_t student(test.df);
    test.p = std::min(1.0, 2.0 * boost::math::cdf(boost::math::complement(student, std::abs(test.t))));
    const double half = boost::math::quantile(student, (1.0 + kPairConfidence) / 2.0) * error;
    test.interval = {(mean - half) * scale, (mean + half) * scale};
    test.dz = test.t / std::sqrt(n);
    test.dzInterval = standardizedDifferenceInterval(test.t, differences.size(), kPairConfidence);
    const double spread = std::sqrt((varianceOf(a) + varianceOf(b)) / 2.0);
    if (spread > kRounding)
        test.dav = mean / spread;
    test.hedges = hedgesFactor(test.df);
    comparison.test = test;
    return comparison;
}

std::vector<std::optional<double>> holm(std::span<const std::optional<double>> p) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i])
            order.push_back(i);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return *p[i]; });
    std::vector<std::optional<double>> adjusted(p.size());
    double highest = 0.0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const auto remaining = static_cast<double>(order.size() - rank);
        highest = std::max(highest, std::min(1.0, remaining * *p[order[rank]]));
        adjusted[order[rank]] = highest;
    }
    return adjusted;
}

} // namespace teleta::study
