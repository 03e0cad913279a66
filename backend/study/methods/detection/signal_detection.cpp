// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/detection/signal_detection.h"

#include "backend/core/quantile.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace teleta::study {

namespace {

/// No log-linear rate of fewer than 10^12 trials needs a larger one.
constexpr double kMostSensitivity = 20.0;

double phi(double z) {
    return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

double normalPlace(double share) {
    return boost::math::quantile(boost::math::normal(), share);
}

bool areCounts(const DetectionCounts& counts) {
    return counts.signalTrials > 0 && counts.noiseTrials > 0 && counts.hits >= 0 &&
           counts.hits <= counts.signalTrials && counts.falseAlarms >= 0 &&
           counts.falseAlarms <= counts.noiseTrials;
}

double loglinear(std::int64_t count, std::int64_t trials) {
    return (static_cast<double>(count) + 0.5) / (static_cast<double>(trials) + 1.0);
}

double rateVariance(double rate, std::int64_t trials) {
    const double density = phi(normalPlace(rate));
    return rate * (1.0 - rate) / (static_cast<double>(trials) * density * density);
}

/// Where a rising function of d' has this value.
template <typename Function>
double solve(const Function& function, double value, double low, double high) {
    const auto excess = [&](double d) { return function(d) - value; };
    const double atLow = excess(low);
    const double atHigh = excess(high);
    if (atLow >= 0.0)
        return low;
    if (atHigh <= 0.0)
        return high;
    std::uintmax_t most = 200;
    const auto [a, b] = boost::math::tools::toms748_solve(
        excess, low, high, atLow, atHigh, boost::math::tools::eps_tolerance<double>(46), most);
    return 0.5 * (a + b);
}

/// The integral by the trapezoidal rule, which converges faster than any power of the step here.
double shareOfIntervals(double sensitivity, int intervals) {
    constexpr double kStep = 0.05;
    constexpr int kSteps = 180; // 9 sd to either side
    double sum = 0.0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        const double u = sensitivity + i * kStep;
        sum += phi(i * kStep) * std::pow(core::normalShare(u), intervals - 1);
    }
    return sum * kStep;
}

} // namespace

std::optional<Detection> yesNoDetection(const DetectionCounts& counts) {
    if (!areCounts(counts))
        return std::nullopt;
    const double hit = loglinear(counts.hits, counts.signalTrials);
    const double falseAlarm = loglinear(counts.falseAlarms, counts.noiseTrials);
    Detection result;
    result.sensitivity = normalPlace(hit) - normalPlace(falseAlarm);
    result.criterion = -0.5 * (normalPlace(hit) + normalPlace(falseAlarm));
    const double sd =
        std::sqrt(rateVariance(hit, counts.signalTrials) + rateVariance(falseAlarm, counts.noiseTrials));
    result.interval = Interval{result.sensitivity - core::kNormalQuantile95 * sd,
                               result.sensitivity + core::kNormalQuantile95 * sd};
    return result;
}

std::optional<Detection> twoIntervalDetection(const DetectionCounts& counts) {
    std::optional<Detection> result = yesNoDetection(counts);
    if (result) {
        result->sensitivity /= std::numbers::sqrt2;
        result->interval->low /= std::numbers::sqrt2;
        result->interval->high /= std::numbers::sqrt2;
    }
    return result;
}

std::optional<double> intervalSensitivity(double share, int intervals) {
    if (!(share > 0.0 && share < 1.0) || intervals < 2 || intervals > 100)
        return std::nullopt;
    return solve([&](double d) { return shareOfIntervals(d, intervals); }, share, -kMostSensitivity,
                 kMostSensitivity);
}

std::optional<Detection> intervalDetection(std::int64_t correct, std::int64_t trials, int intervals) {
    const std::optional<Interval> shares = wilsonInterval(correct, trials);
    if (!shares || intervals < 2 || intervals > 100)
        return std::nullopt;
    const auto n = static_cast<double>(trials);
    Detection result;
    result.sensitivity =
        *intervalSensitivity((static_cast<double>(correct) + 1.0 / intervals) / (n + 1.0), intervals);
    const std::optional<double> low = intervalSensitivity(shares->low, intervals);
    const std::optional<double> high = intervalSensitivity(shares->high, intervals);
    if (low && high)
        result.interval = Interval{*low, *high};
    return result;
}

std::optional<double> sameDifferentSensitivity(double hitRate, double falseAlarmRate,
                                               SameDifferentRule rule) {
    const auto isRate = [](double rate) { return rate > 0.0 && rate < 1.0; };
    if (!isRate(hitRate) || !isRate(falseAlarmRate))
        return std::nullopt;
    if (hitRate <= falseAlarmRate)
        return 0.0;
    if (rule == SameDifferentRule::independent) {
        const double right = core::normalShare(0.5 * (normalPlace(hitRate) - normalPlace(falseAlarmRate)));
        return 2.0 * normalPlace(0.5 * (1.0 + std::sqrt(2.0 * right - 1.0)));
    }
    const double limit = -std::numbers::sqrt2 * normalPlace(0.5 * falseAlarmRate);
    const auto share = [&](double d) {
        return core::normalShare((d - limit) / std::numbers::sqrt2) +
               core::normalShare((-d - limit) / std::numbers::sqrt2);
    };
    return solve(share, hitRate, 0.0, 2.0 * kMostSensitivity);
}

std::optional<Detection> sameDifferentDetection(const DetectionCounts& counts, SameDifferentRule rule) {
    if (!areCounts(counts))
        return std::nullopt;
    const double hit = loglinear(counts.hits, counts.signalTrials);
    const double falseAlarm = loglinear(counts.falseAlarms, counts.noiseTrials);
    Detection result;
    result.sensitivity = sameDifferentSensitivity(hit, falseAlarm, rule).value_or(0.0);
    result.worseThanNothing = hit <= falseAlarm;
    return result;
}

} // namespace teleta::study
