// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/proportion.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <vector>

namespace teleta::study {

namespace {

bool isCount(std::int64_t successes, std::int64_t trials) {
    return trials > 0 && successes >= 0 && successes <= trials;
}

bool isConfidence(double confidence) {
    return confidence > 0.0 && confidence < 1.0;
}

/// The smaller root, from the larger one and their product: exact 0 without successes, no cancellation.
double wilsonLow(double successes, double trials, double z) {
    const double share = successes / trials;
    const double z2 = z * z / trials;
    const double a = 1.0 + z2;
    const double b = 2.0 * share + z2;
    const double largerRoot = (b + std::sqrt(z2 * (z2 + 4.0 * share * (1.0 - share)))) / (2.0 * a);
    return share * share / (a * largerRoot);
}

Interval wilsonOf(double successes, double failures, double confidence) {
    const double z = -boost::math::quantile(boost::math::normal(), (1.0 - confidence) / 2.0);
    const double trials = successes + failures;
    return {wilsonLow(successes, trials, z), 1.0 - wilsonLow(failures, trials, z)};
}

bool allFinite(std::span<const double> values) {
    return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

} // namespace

std::optional<Interval> wilsonInterval(std::int64_t successes, std::int64_t trials, double confidence) {
    if (!isCount(successes, trials) || !isConfidence(confidence))
        return std::nullopt;
    return wilsonOf(static_cast<double>(successes), static_cast<double>(trials - successes), confidence);
}

std::optional<Interval> wilsonShareInterval(double meanShare, std::int64_t runs, double confidence) {
    if (!(meanShare >= 0.0 && meanShare <= 1.0) || runs < 1 || !isConfidence(confidence))
        return std::nullopt;
    const auto n = static_cast<double>(runs);
    return wilsonOf(meanShare * n, (1.0 - meanShare) * n, confidence);
}

std::optional<Interval> clopperPearsonInterval(std::int64_t successes, std::int64_t trials,
                                               double confidence) {
    if (!isCount(successes, trials) || !isConfidence(confidence))
        return std::nullopt;
    const double tail = (1.0 - confidence) / 2.0;
    const auto x = static_cast<double>(successes);
    const auto failures = static_cast<double>(trials - successes);
    return Interval{successes == 0 ? 0.0 : boost::math::ibeta_inv(x, failures + 1.0, tail),
                    successes == trials ? 1.0 : boost::math::ibetac_inv(x + 1.0, failures, tail)};
}

std::optional<double> chanceProbability(std::int64_t successes, std::int64_t trials, double chance) {
    if (!isCount(successes, trials) || !(chance >= 0.0 && chance <= 1.0))
        return std::nullopt;
    if (successes == 0)
        return 1.0;
    const boost::math::binomial guesses(static_cast<double>(trials), chance);
    return boost::math::cdf(boost::math::complement(guesses, static_cast<double>(successes - 1)));
}

std::optional<GroupMean> groupMean(std::span<const double> values, double confidence) {
    if (values.empty() || !allFinite(values) || !isConfidence(confidence))
        return std::nullopt;
    // Scaled by the largest value, so that neither the sum nor the squares overflow or underflow.
    double scale = 0.0;
    for (const double v : values)
        scale = std::max(scale, std::abs(v));
    if (scale == 0.0)
        scale = 1.0;
    const auto n = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double v : values)
        mean += v / scale / n;
    double correction = 0.0;
    for (const double v : values)
        correction += (v / scale - mean) / n;
    mean += correction;
    const auto [least, most] = std::ranges::minmax_element(values);
    const bool allAgree = *least == *most;
    GroupMean group{allAgree ? *least : mean * scale, std::nullopt, std::nullopt};
    if (values.size() < 2)
        return group;
    double squares = 0.0;
    for (const double v : values)
        squares += (v / scale - mean) * (v / scale - mean);
    const double deviation = allAgree ? 0.0 : std::sqrt(squares / (n - 1.0)) * scale;
    const double t = -boost::math::quantile(boost::math::students_t(n - 1.0), (1.0 - confidence) / 2.0);
    const double half = t * deviation / std::sqrt(n);
    group.standardDeviation = deviation;
    group.interval = Interval{group.mean - half, group.mean + half};
    return group;
}

std::optional<GroupMean> groupShare(std::span<const double> values, double confidence) {
    if (std::ranges::any_of(values, [](double v) { return !(v >= 0.0 && v <= 1.0); }))
        return std::nullopt;
    std::optional<GroupMean> group = groupMean(values, confidence);
    if (group && group->interval) {
        Interval& ends = *group->interval;
        group->isCut = ends.low < 0.0 || ends.high > 1.0;
        ends = {std::max(0.0, ends.low), std::min(1.0, ends.high)};
    }
    return group;
}

std::optional<double> median(std::span<const double> values) {
    if (values.empty() || !allFinite(values))
        return std::nullopt;
    return core::medianOf(std::vector(values.begin(), values.end()));
}

} // namespace teleta::study
