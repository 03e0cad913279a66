// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace teleta::pattern;
using teleta::core::Intensities;

namespace {

Pattern withTrack(Track track, double duration_s) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    pattern.tracks[2] = std::move(track);
    return pattern;
}

double at(const Pattern& pattern, double t_s) {
    const Intensities intensities = evaluate(pattern, t_s);
    for (const std::size_t other : {0, 1, 3, 4, 5})
        EXPECT_EQ(intensities[other], 0.0);
    return intensities[2];
}

} // namespace

TEST(Evaluate, isLinearBetweenBreakpoints) {
    const Pattern pattern = withTrack({{0.5, 0.2}, {1.5, 0.8}, {2.0, 0.0}}, 3.0);
    EXPECT_DOUBLE_EQ(at(pattern, 0.5), 0.2);
    EXPECT_DOUBLE_EQ(at(pattern, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(at(pattern, 1.75), 0.4);
}

TEST(Evaluate, isOffOutsideTheTrackAndThePattern) {
    const Pattern pattern = withTrack({{0.5, 1.0}, {4.0, 1.0}}, 3.0);
    EXPECT_EQ(at(pattern, -0.1), 0.0);
    EXPECT_EQ(at(pattern, 0.499), 0.0);
    EXPECT_EQ(at(pattern, 0.5), 1.0);
    EXPECT_EQ(at(pattern, 2.999), 1.0);
    EXPECT_EQ(at(pattern, 3.0), 0.0);
    const Pattern shorter = withTrack({{0.5, 1.0}, {2.0, 1.0}}, 3.0);
    EXPECT_EQ(at(shorter, 1.999), 1.0);
    EXPECT_EQ(at(shorter, 2.0), 0.0);
}

TEST(Evaluate, goesDownTheEasedSegmentsByTheirFormulas) {
    const double u = 0.3;
    const auto value = [&](Easing easing) { return at(withTrack({{0.0, 0.0, easing}, {1.0, 1.0}}, 1.0), u); };
    EXPECT_NEAR(value(Easing::linear), u, 1e-15);
    EXPECT_EQ(value(Easing::hold), 0.0);
    EXPECT_NEAR(value(Easing::easeIn), 1.0 - std::cos(std::numbers::pi * u / 2.0), 1e-15);
    EXPECT_NEAR(value(Easing::easeOut), std::sin(std::numbers::pi * u / 2.0), 1e-15);
    EXPECT_NEAR(value(Easing::easeInOut), (1.0 - std::cos(std::numbers::pi * u)) / 2.0, 1e-15);
}

TEST(Evaluate, stepsAtTwoBreakpointsOfOneTime) {
    const Pattern pattern = withTrack({{0.0, 0.1}, {1.0, 0.1}, {1.0, 0.9}, {2.0, 0.9}}, 2.0);
    EXPECT_DOUBLE_EQ(at(pattern, std::nextafter(1.0, 0.0)), 0.1);
    EXPECT_DOUBLE_EQ(at(pattern, 1.0), 0.9);
}

TEST(Evaluate, takesTheStrongerOfTrackAndObjects) {
    Pattern pattern = withTrack({{0.0, 0.0}, {1.0, 1.0}}, 1.0);
    pattern.objects.push_back({"", Ramp{0.0, 1.0, {2}, 0.5, 0.5, Easing::linear}, {}});
    EXPECT_DOUBLE_EQ(at(pattern, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(at(pattern, 0.75), 0.75);
}

TEST(Evaluate, limitsWhatBreakpointsAskForAndTakesNaNForOff) {
    const double nan = std::nan("");
    EXPECT_EQ(at(withTrack({{0.0, 7.0}, {1.0, 7.0}}, 1.0), 0.5), 1.0);
    EXPECT_EQ(at(withTrack({{0.0, -7.0}, {1.0, -7.0}}, 1.0), 0.5), 0.0);
    EXPECT_EQ(at(withTrack({{0.0, nan}, {1.0, 1.0}}, 1.0), 0.5), 0.0);
}

TEST(CompiledPattern, hasTheValuesOfEvaluateBitForBit) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Pattern pattern;
    pattern.duration_s = 10.0;
    for (Track& track : pattern.tracks) {
        for (int k = 0; k < 40; ++k)
            track.push_back({0.25 * k, uniform(random), static_cast<Easing>(k % 5)});
    }
    const auto add = [&](ObjectForm form) { pattern.objects.push_back({"", std::move(form), {}}); };
    add(Ring{6.0, 2.0, 3, 1, false, std::nullopt, 1.0});
    add(Sweep{1.0, 0.2, std::nullopt, {0, 2, 4}, 0.9});
    add(Phantom{0.5, 8.0, 2, 3, 0.0, 1.0, 1.0});
    add(PulseTrain{3.0, 4.0, 0.3, 0.1, {0, 5}, 1.0});
    add(Ramp{5.0, 0.0, {1}, 1.0, 1.0, Easing::linear});
    add(Stroke{2.0, {{0.0, 0.0, 0.0}, {3.0, 9.0, 1.0}}, 1.0});
    const CompiledPattern compiled(pattern);
    for (int k = -10; k < 1100; ++k)
        EXPECT_EQ(compiled.evaluate(0.01 * k), evaluate(pattern, 0.01 * k)) << k;
}
