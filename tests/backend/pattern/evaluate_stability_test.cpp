// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/pattern.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace teleta::pattern;
using teleta::core::Intensities;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

void expectOff(const Pattern& pattern, double t_s) {
    EXPECT_EQ(evaluate(pattern, t_s), Intensities{}) << t_s;
    EXPECT_EQ(CompiledPattern(pattern).evaluate(t_s), Intensities{}) << t_s;
}

Pattern withObject(ObjectForm form, double duration_s = 1.0) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    pattern.objects.push_back({"", std::move(form), {}});
    return pattern;
}

} // namespace

TEST(EvaluateStability, timesThatAreNoTimesAreOff) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    Pattern pattern;
    pattern.duration_s = 1.0;
    pattern.tracks.fill({{0.0, 1.0}, {1.0, 1.0}});
    for (const double t_s : {kNan, kInf, -kInf, -1.0, -1e-300, -1e300, 1e300, 1.0})
        expectOff(pattern, t_s);
    EXPECT_EQ(evaluate(pattern, -0.0)[0], 1.0);
}

TEST(EvaluateStability, emptyAndTimelessPatternsAreOff) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    Pattern pattern;
    expectOff(pattern, 0.0);
    pattern.duration_s = 1.0;
    expectOff(pattern, 0.5);
    pattern.tracks[0] = {{0.5, 1.0}};
    expectOff(pattern, 0.5);
    pattern.tracks[0] = {{0.5, 1.0}, {0.5, 1.0}, {0.5, 1.0}};
    expectOff(pattern, 0.5);
    pattern.tracks[0] = {{0.0, 1.0}, {1.0, 1.0}};
    for (const double duration_s : {0.0, -1.0, kNan}) {
        pattern.duration_s = duration_s;
        expectOff(pattern, 0.0);
    }
}

TEST(EvaluateStability, ofManyBreakpointsAtOneTimeTheLastCounts) {
    Pattern pattern;
    pattern.duration_s = 1.0;
    pattern.tracks[0].assign(1000, {0.5, 0.1});
    pattern.tracks[0].push_back({0.5, 0.7});
    pattern.tracks[0].push_back({1.0, 0.7});
    EXPECT_DOUBLE_EQ(evaluate(pattern, 0.5)[0], 0.7);
}

TEST(EvaluateStability, segmentsOfAnyLengthStayBetweenTheirEnds) {
    for (double length_s = 1.0; length_s > 1e-12; length_s *= 0.1) {
        Pattern pattern;
        pattern.duration_s = 2.0;
        pattern.tracks[0] = {{1.0, 0.0}, {1.0 + length_s, 1.0}, {2.0, 1.0}};
        for (const double share : {0.0, 0.25, 0.5, 1.0}) {
            const double t_s = 1.0 + share * length_s;
            const double expected = (t_s - 1.0) / ((1.0 + length_s) - 1.0);
            EXPECT_NEAR(evaluate(pattern, t_s)[0], t_s < 2.0 ? std::min(expected, 1.0) : 0.0, 1e-15);
        }
    }
}

TEST(EvaluateStability, aMillionBreakpointsOnEachTrackAreFound) {
    constexpr int kPoints = 1'000'000;
    Pattern pattern;
    pattern.duration_s = kPoints;
    for (Track& track : pattern.tracks) {
        for (int k = 0; k < kPoints; ++k)
            track.push_back({static_cast<double>(k), k % 2 == 0 ? 0.0 : 1.0});
    }
    const CompiledPattern compiled(pattern);
    for (const double t_s : {0.25, 1.0, 499'999.5, 499'999.75, 999'998.5}) {
        const double phase = std::fmod(t_s, 2.0);
        const double expected = phase <= 1.0 ? phase : 2.0 - phase;
        EXPECT_DOUBLE_EQ(evaluate(pattern, t_s)[5], expected);
        EXPECT_DOUBLE_EQ(compiled.evaluate(t_s)[5], expected);
    }
}

TEST(EvaluateStability, objectsWithoutTimeOrTactorsAreOff) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    for (const double time_s : {0.0, -1.0, kNan}) {
        for (const double t_s : {0.0, 0.1, 0.9}) {
            expectOff(withObject(Ring{0.0, time_s, 3, 0, true, std::nullopt, 1.0}), t_s);
            expectOff(withObject(Phantom{0.0, time_s, 0, 1, 0.5, 0.5, 1.0}), t_s);
            expectOff(withObject(Ramp{0.0, time_s, {0}, 1.0, 1.0, Easing::linear}), t_s);
            expectOff(withObject(PulseTrain{0.0, time_s, 0.1, 0.1, {0}, 1.0}), t_s);
            expectOff(withObject(Sweep{kNan, 0.1, std::nullopt, {0}, 1.0}), t_s);
        }
    }
    expectOff(withObject(Sweep{}), 0.0);
    expectOff(withObject(Stroke{}), 0.0);
    expectOff(withObject(Stroke{0.0, {{0.0, 0.0, 0.0}}, 1.0}), 0.0);
    expectOff(withObject(Stroke{0.0, {{0.0, kNan, 0.0}, {1.0, kNan, 0.0}}, 1.0}), 0.5);
    expectOff(withObject(Ramp{0.0, 1.0, {}, 1.0, 1.0, Easing::linear}), 0.5);
}

TEST(EvaluateStability, ringsWithoutTurnsAreOffAndWithManyTurnsAreOn) {
    expectOff(withObject(Ring{0.0, 1.0, 0, 0, true, std::nullopt, 1.0}), 0.5);
    expectOff(withObject(Ring{0.0, 1.0, -3, 0, true, std::nullopt, 1.0}), 0.5);
    {
        const teleta::test::WithoutFloatingPointTraps noNumber;
        expectOff(withObject(Ring{0.0, 1.0, 3, 0, true, kNan, 1.0}), 0.5);
    }
    expectOff(withObject(Ring{0.0, 1.0, 3, 0, true, -1.0, 1.0}), 0.5);
    const teleta::core::Intensities most =
        evaluate(withObject(Ring{0.0, 1.0, std::numeric_limits<int>::max(), 0, true, 1e-3, 1.0}), 0.01);
    EXPECT_LE(most[0], 1.0);
    const Pattern fast = withObject(Ring{0.0, 1.0, 1000, 0, true, std::nullopt, 1.0});
    for (int k = 0; k < 100; ++k) {
        double sum = 0.0;
        for (const double intensity : evaluate(fast, 0.01 * k + 1e-5))
            sum += intensity;
        EXPECT_EQ(sum, 1.0) << k;
    }
}

TEST(EvaluateStability, tactorsOutOfRangeCountModuloSix) {
    const Pattern pattern = withObject(
        Ramp{0.0, 1.0, {-1, 6, 1'000'000'001, std::numeric_limits<int>::min()}, 1.0, 1.0, Easing::linear});
    // 1 000 000 001 = 6 k + 5, -2^31 = 6 k + 4
    EXPECT_EQ(evaluate(pattern, 0.5), (Intensities{1, 0, 0, 0, 1, 1}));
}

TEST(EvaluateStability, raisesNoFloatingPointException) {
    const Pattern ring = withObject(Ring{0.0, 2.0, 5, 0, true, std::nullopt, 1.0}, 2.0);
    const Pattern stroke = withObject(Stroke{0.0, {{0.0, -1.0, 0.0}, {1.0, 7.0, 1.0}}, 1.0});
    for (int k = 0; k < 300; ++k) {
        (void)evaluate(ring, 0.01 * k);
        (void)evaluate(stroke, 0.01 * k);
    }
}
