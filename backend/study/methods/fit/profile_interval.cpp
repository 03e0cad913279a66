// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/fit/profile_interval.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

namespace teleta::study {

namespace {

/// Walks from the best value towards a limit until the profile has fallen far enough, then finds the place.
std::optional<double> profileEnd(const LikelihoodSearch& search, SearchPoint::Parameter parameter,
                                 const SearchPoint& best, double limit, double firstStep) {
    SearchPoint near = best;
    const auto excess = [&](double value) {
        near = search.bestWith(parameter, value, near);
        return 2.0 * (best.logLikelihood - near.logLikelihood) - kChiSquare95;
    };
    const double direction = limit > best.at[parameter] ? 1.0 : -1.0;
    const double longest = std::abs(limit - best.at[parameter]);
    double inside = best.at[parameter];
    double insideExcess = -kChiSquare95;
    double travelled = 0.0;
    double step = std::min(firstStep, longest);
    while (travelled < longest) {
        travelled = std::min(travelled + step, longest);
        const double value = travelled == longest ? limit : best.at[parameter] + direction * travelled;
        const double here = excess(value);
        if (here > 0.0) {
            std::uintmax_t most = 60;
            const auto closeEnough = [&](double a, double b) {
                return std::abs(a - b) <= 1e-9 * std::max({std::abs(a), std::abs(b), firstStep});
            };
            const bool rising = direction > 0.0;
            const auto [low, high] = boost::math::tools::toms748_solve(
                excess, rising ? inside : value, rising ? value : inside, rising ? insideExcess : here,
                rising ? here : insideExcess, closeEnough, most);
            return 0.5 * (low + high);
        }
        inside = value;
        insideExcess = here;
        step *= 1.5;
    }
    return std::nullopt;
}

} // namespace

OpenInterval profileInterval(const LikelihoodSearch& search, SearchPoint::Parameter parameter,
                             const SearchPoint& best) {
    const double low = search.lowest()[parameter];
    const double high = search.highest()[parameter];
    // About half an interval by the information, but never more than a tenth of what is allowed.
    const double step = std::min(search.errorOf(parameter, best).value_or(high - low), 0.1 * (high - low));
    return {profileEnd(search, parameter, best, low, step), profileEnd(search, parameter, best, high, step)};
}

} // namespace teleta::study
