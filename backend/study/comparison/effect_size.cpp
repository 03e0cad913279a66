// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/comparison/effect_size.h"

#include <algorithm>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <exception>

namespace teleta::study {

namespace {

/// Of a noncentrality, relative: far below what a table shows.
constexpr int kBits = 40;
constexpr std::uintmax_t kMostRootSteps = 200;

/// Where a falling function of the noncentrality passes the probability, between two ends that enclose it.
template <typename Cdf>
double noncentrality(const Cdf& cdf, double probability, double low, double high) {
    std::uintmax_t steps = kMostRootSteps;
    const auto [from, to] =
        boost::math::tools::toms748_solve([&](double value) { return cdf(value) - probability; }, low, high,
                                          boost::math::tools::eps_tolerance<double>(kBits), steps);
    return (from + to) / 2.0;
}

} // namespace

std::optional<Interval> standardizedDifferenceInterval(double t, std::size_t n, double confidence) {
    if (n < 2 || !std::isfinite(t) || !(confidence > 0.0 && confidence < 1.0))
        return std::nullopt;
    const double tail = (1.0 - confidence) / 2.0;
    const auto participants = static_cast<double>(n);
    // By symmetry only t >= 0 has to be solved.
    const double size = std::abs(t);
    const auto cdf = [&](double delta) {
        return boost::math::cdf(boost::math::non_central_t(participants - 1.0, delta), size);
    };
    try {
        // The distribution of T is wider than normal, by the spread of the estimated standard deviation.
        double reach = 5.0 + size;
        while (cdf(size - reach) < 1.0 - tail || cdf(size + reach) > tail)
            reach *= 2.0;
        const double low = noncentrality(cdf, 1.0 - tail, size - reach, size + reach);
        const double high = noncentrality(cdf, tail, size - reach, size + reach);
        const double root = std::sqrt(participants);
        return t < 0.0 ? Interval{-high / root, -low / root} : Interval{low / root, high / root};
    } catch (const std::exception&) {
        return std::nullopt; // the series of the distribution did not converge
    }
}

std::optional<double> hedgesFactor(double freedom) {
    if (!(freedom > 1.0) || !std::isfinite(freedom))
        return std::nullopt;
    return std::exp(std::lgamma(freedom / 2.0) - std::lgamma((freedom - 1.0) / 2.0)) /
           std::sqrt(freedom / 2.0);
}

std::optional<Interval> partialEta2Interval(double f, double df1, double df2, double confidence) {
    if (!(f >= 0.0 && df1 > 0.0 && df2 > 0.0) || !std::isfinite(f + df1 + df2) ||
        !(confidence > 0.0 && confidence < 1.0))
        return std::nullopt;
    const double tail = (1.0 - confidence) / 2.0;
    const auto cdf = [&](double lambda) {
        return boost::math::cdf(boost::math::non_central_f(df1, df2, lambda), f);
    };
    const auto end = [&](double probability) {
        if (cdf(0.0) <= probability)
            return 0.0;
        double reach = 10.0 + 2.0 * df1 * f;
        while (cdf(reach) > probability)
            reach *= 2.0;
        const double lambda = noncentrality(cdf, probability, 0.0, reach);
        return lambda / (lambda + df1 + df2 + 1.0);
    };
    try {
        return Interval{end(1.0 - tail), end(tail)};
    } catch (const std::exception&) {
        return std::nullopt; // the series of the distribution did not converge
    }
}

} // namespace teleta::study
