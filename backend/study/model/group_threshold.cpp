// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/model/group_threshold.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace teleta::study {

namespace {

/// The quantile 0.95 of chi-squared with one degree of freedom.
constexpr double kProfileDrop = 3.841458820694124;
/// Of levels from 0 to 1: a rise within a sixtieth of their range.
constexpr double kLargestSlope = 60.0;

BinomialModel modelOf(const std::vector<PersonLevel>& trials, double guess, double lapse,
                      std::optional<double> threshold) {
    BinomialModel model;
    model.link = Link::probit;
    model.guess = guess;
    model.lapse = lapse;
    model.largestCoefficient = kLargestSlope;
    for (const PersonLevel& one : trials) {
        // With the threshold given, b0 = -b1 t: one coefficient is left.
        std::vector<double> x = threshold ? std::vector{one.level - *threshold} : std::vector{1.0, one.level};
        model.rows.push_back({one.participant, std::move(x), one.correct, one.trials});
    }
    return model;
}

} // namespace

tl::expected<GroupThreshold, ModelRefusal> groupThreshold(const std::vector<PersonLevel>& trials,
                                                          double guess, double lapse) {
    if (trials.empty())
        return tl::unexpected(ModelRefusal::noData);
    const auto [least, most] = std::ranges::minmax_element(trials, {}, &PersonLevel::level);
    const double lowest = least->level;
    const double range = most->level - lowest;
    if (!(range > 0.0))
        return tl::unexpected(ModelRefusal::noData);
    // Fitted to levels from 0 to 1, so that the limit of a coefficient does not depend on the unit.
    std::vector<PersonLevel> scaled = trials;
    for (PersonLevel& one : scaled)
        one.level = (one.level - lowest) / range;
    tl::expected<BinomialFit, ModelRefusal> fit = fitBinomial(modelOf(scaled, guess, lapse, {}));
    if (!fit)
        return tl::unexpected(fit.error());
    const double slope = fit->b[1];
    if (!(slope > 0.0))
        return tl::unexpected(ModelRefusal::falls);
    const double middle = -fit->b[0] / slope;
    BinomialFit near;
    near.b = {slope};
    near.s = fit->s;
    const auto excess = [&](double threshold) {
        const auto profile = fitBinomial(modelOf(scaled, guess, lapse, threshold), &near);
        // Without a fit the likelihood is far below the highest one.
        return profile ? 2.0 * (fit->logLikelihood - profile->logLikelihood) - kProfileDrop : 1e6;
    };
    const auto end = [&](double limit) -> std::optional<double> {
        if ((limit - middle) * (limit - 0.5) <= 0.0 || excess(limit) <= 0.0)
            return std::nullopt;
        std::uintmax_t steps = 100;
        const auto [from, to] =
            boost::math::tools::toms748_solve(excess, std::min(middle, limit), std::max(middle, limit),
                                              boost::math::tools::eps_tolerance<double>(30), steps);
        return lowest + range * (from + to) / 2.0;
    };
    GroupThreshold group;
    group.threshold = lowest + range * middle;
    group.low = end(-1.0);
    group.high = end(2.0);
    group.participantSd = range * fit->s / slope;
    group.fit = std::move(*fit);
    // Back to the unit of the levels.
    group.fit.b[1] = slope / range;
    group.fit.b[0] -= group.fit.b[1] * lowest;
    Eigen::Matrix2d unit;
    unit << 1.0, -lowest / range, 0.0, 1.0 / range;
    group.fit.covariance = unit * group.fit.covariance * unit.transpose();
    return group;
}

} // namespace teleta::study
