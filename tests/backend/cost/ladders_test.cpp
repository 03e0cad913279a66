// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/ladders/ladders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

using namespace teleta;
using namespace teleta::cost;

namespace {

Ladder ladderNamed(const std::string& name) {
    const std::vector<Ladder> ladders = allLadders();
    return *std::ranges::find(ladders, name, &Ladder::name);
}

/// Mean errors over the first trials, by rung.
std::map<std::string, double> meanErrors(const Ladder& ladder, std::size_t trials) {
    std::map<std::string, double> means;
    const core::Expected<std::vector<Rung>> rungs = ladder.makeRungs();
    EXPECT_TRUE(rungs);
    for (const Rung& rung : *rungs) {
        std::vector<double> errors;
        for (std::size_t i = 0; i < trials; ++i) {
            Trial trial(i);
            rung.run(trial);
            EXPECT_GT(trial.time_s(), 0.0) << rung.name;
            errors.insert(errors.end(), trial.errors().begin(), trial.errors().end());
        }
        EXPECT_TRUE(std::ranges::all_of(errors, [](double e) { return std::isfinite(e) && e >= 0.0; }))
            << rung.name;
        means[rung.name] =
            std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    }
    return means;
}

} // namespace

TEST(Ladders, haveNamesOfTheirOwnAndAtLeastTwoRungs) {
    std::set<std::string> names;
    for (const Ladder& ladder : allLadders()) {
        EXPECT_TRUE(names.insert(ladder.name).second) << ladder.name;
        EXPECT_FALSE(ladder.title.empty() || ladder.truth.empty() || ladder.errorUnit.empty());
        EXPECT_GE(ladder.trials, kFewestTrials);
    }
}

// Without noise both methods are exact; with the noise s of a torque the paper's two samples at the borders
// of the window w are off by sqrt(2) s / w on average over many touches, which a regression over n samples
// divides by sqrt(n / 6) (variance of the slope of n even torques).
TEST(StiffnessLadder, regressionBeatsTwoPointsAsTheNumberOfSamplesGrows) {
    const auto errors = meanErrors(ladderNamed("stiffness"), 200);
    EXPECT_LT(errors.at("regression-1000"), 0.3 * errors.at("two-point-1000"));
    EXPECT_LT(errors.at("regression-1000"), 0.5 * errors.at("regression-30"));
    EXPECT_LT(errors.at("regression-1000"), 0.02);
    EXPECT_GT(errors.at("two-point-2"), 0.005) << "2.4 % of noise in the torque rise cannot vanish";
}

// An approximating spline draws a circle of n points with (2 + cos(2 pi / n)) / 3 of its radius: with 8
// points 9.8 % too small. An interpolating one goes through them.
TEST(ContourLadder, interpolatingIsNearerWithFewPointsAndApproximatingSmoothsTheNoiseOfMany) {
    const auto errors = meanErrors(ladderNamed("contour"), 90);
    EXPECT_LT(errors.at("interpolating-16"), 0.6 * errors.at("approximating-16"));
    EXPECT_LT(errors.at("approximating-360"), errors.at("interpolating-360"));
    EXPECT_LT(errors.at("interpolating-64"), 0.0003) << "the noise of a touch is 0.2 mm";
    EXPECT_GT(errors.at("approximating-8"), 0.001);
}

TEST(TactileFeaturesLadder, aSummitIsNearerThanACentroidWhereTheBorderCutsTheContact) {
    const auto errors = meanErrors(ladderNamed("tactile-features"), 8);
    EXPECT_LT(errors.at("weighted"), errors.at("binarised"));
    EXPECT_LT(errors.at("sub-taxel"), 0.8 * errors.at("weighted"));
    EXPECT_LT(errors.at("sub-taxel"), 0.1 * 0.0034) << "a tenth of the pitch";
}
