// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/track_envelope.h"
#include "backend/pattern/motors/motor_prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace teleta::pattern;

namespace {

constexpr std::atomic<bool> kGoOn{false};

/// Range by looking at every breakpoint and at both ends, as the pattern itself is evaluated there.
ValueRange bySearch(const Pattern& pattern, double begin_s, double end_s) {
    ValueRange range{1.0, 0.0};
    const auto take = [&range](double value) {
        range = {std::min(range.low, value), std::max(range.high, value)};
    };
    take(evaluate(pattern, begin_s)[0]);
    take(evaluate(pattern, end_s)[0]);
    for (const Breakpoint& point : pattern.tracks[0])
        if (point.time_s >= begin_s && point.time_s <= end_s)
            take(point.intensity);
    if (begin_s <= pattern.tracks[0].front().time_s || end_s >= pattern.tracks[0].back().time_s)
        take(0.0);
    return range;
}

Pattern bursts(int count) {
    Pattern pattern;
    pattern.duration_s = count;
    for (int k = 0; k < count; ++k)
        for (const Breakpoint& point :
             {Breakpoint{k + 0.1, 0.0}, {k + 0.1, 0.8}, {k + 0.4, 0.8}, {k + 0.4, 0.0}})
            pattern.tracks[static_cast<std::size_t>(k % 6)].push_back(point);
    return pattern;
}

} // namespace

TEST(TrackEnvelope, hasTheRangeThatASearchThroughAllBreakpointsHas) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const int count : {2, 3, 31, 32, 33, 1024, 5000}) {
        Pattern pattern;
        for (int k = 0; k < count; ++k)
            pattern.tracks[0].push_back(
                {0.5 + 0.01 * k + (k % 7 == 3 ? 0.01 : 0.0), share(random)}); // steps now and then
        pattern.duration_s = pattern.tracks[0].back().time_s + 1.0;
        const TrackEnvelope envelope(pattern.tracks[0]);
        for (int look = 0; look < 300; ++look) {
            const double a = -0.2 + share(random) * (pattern.duration_s + 0.4);
            const double b = look % 3 == 0 ? a + 0.02 * share(random) : a + share(random) * 20.0;
            const ValueRange expected = bySearch(pattern, a, b);
            const ValueRange range = envelope.over(a, b);
            EXPECT_NEAR(range.low, expected.low, 1e-12) << count << ": " << a << " to " << b;
            EXPECT_NEAR(range.high, expected.high, 1e-12) << count << ": " << a << " to " << b;
        }
    }
}

TEST(TrackEnvelope, ofNothingIsZero) {
    EXPECT_EQ(TrackEnvelope().over(0.0, 1.0), (ValueRange{0.0, 0.0}));
    EXPECT_EQ(TrackEnvelope(Track{{1.0, 0.5}}).over(2.0, 3.0), (ValueRange{0.0, 0.0}));
}

TEST(ChangedSpan, isEmptyForTheSameAndForOtherNames) {
    Pattern before = bursts(20);
    Pattern after = before;
    after.name = "other";
    after.notes = "words";
    EXPECT_FALSE(changedSpan(before, after));
}

TEST(ChangedSpan, reachesFromTheLastSameBreakpointToTheNextOne) {
    const Pattern before = bursts(60);
    Pattern after = before;
    after.tracks[0][8].intensity = 0.4; // of the burst at 12.1 s, after the one that ends at 6.4 s
    const auto span = changedSpan(before, after);
    ASSERT_TRUE(span);
    EXPECT_DOUBLE_EQ(span->begin_s, 6.4);
    EXPECT_DOUBLE_EQ(span->end_s, 12.1);
}

TEST(ChangedSpan, holdsObjectsWhereTheyWereAndAre) {
    Pattern before = bursts(60);
    before.objects.push_back({"", Ring{.start_s = 10.0, .burst_s = {}}, {}});
    Pattern after = before;
    std::get<Ring>(after.objects[0].form).start_s = 20.0;
    const auto span = changedSpan(before, after);
    ASSERT_TRUE(span);
    EXPECT_DOUBLE_EQ(span->begin_s, 10.0);
    EXPECT_DOUBLE_EQ(span->end_s, 22.0);
}

TEST(MotorPrediction, agreesWithASinglePassOfTheMotorModel) {
    const Pattern pattern = bursts(10);
    const MotorProfiles motors = assumedMotors();
    const auto prediction = MotorPrediction::of(CompiledPattern(pattern), motors, kGoOn);
    ASSERT_TRUE(prediction);
    double highest = 0.0;
    forEachPredictedSample(pattern, motors, 1000.0, [&](double t_s, const auto& intensities, const auto&) {
        const MotorPrediction::Bin bin = prediction->over(0, t_s - 0.03, t_s + 0.03);
        EXPECT_GE(intensities[0], static_cast<double>(bin.low) - 0.02) << t_s;
        EXPECT_LE(intensities[0], static_cast<double>(bin.high) + 0.02) << t_s;
        highest = std::max(highest, intensities[0]);
        return true;
    });
    EXPECT_NEAR(prediction->over(0, 0.0, 10.0).high, highest, 0.02);
    EXPECT_GT(prediction->over(0, 0.0, 1.0).apart, 0.7F);  // the step up
    EXPECT_LT(prediction->over(1, 4.0, 5.0).apart, 1e-6F); // tactor 2 rests there
}

TEST(MotorPrediction, ofAnEditComputesOnlyWhatChangedAndAgreesWithAWholeOne) {
    const Pattern before = bursts(600);
    Pattern after = before;
    after.tracks[2].insert(after.tracks[2].begin() + 200, 2, {after.tracks[2][199].time_s, 0.0});
    after.tracks[2][200].intensity = 0.5;
    const MotorProfiles motors = assumedMotors();
    const auto first = MotorPrediction::of(CompiledPattern(before), motors, kGoOn);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->computedBins(), first->bins());
    const auto span = changedSpan(before, after);
    ASSERT_TRUE(span);
    const CompiledPattern compiled(after);
    const auto quick = MotorPrediction::of(compiled, motors, kGoOn, &*first, *span);
    const auto whole = MotorPrediction::of(compiled, motors, kGoOn);
    ASSERT_TRUE(quick && whole);
    EXPECT_LT(quick->computedBins(), whole->bins() / 20);
    for (std::size_t tactor = 0; tactor < 6; ++tactor)
        for (double t_s = 0.0; t_s < 600.0; t_s += 0.25) {
            const auto a = quick->over(tactor, t_s, t_s + 0.1);
            const auto b = whole->over(tactor, t_s, t_s + 0.1);
            ASSERT_NEAR(a.low, b.low, 1e-6) << tactor << " at " << t_s;
            ASSERT_NEAR(a.high, b.high, 1e-6) << tactor << " at " << t_s;
            ASSERT_NEAR(a.apart, b.apart, 1e-6) << tactor << " at " << t_s;
        }
}

TEST(MotorPrediction, stopsWhenItIsCancelledAndLeavesDaysOut) {
    const std::atomic<bool> cancelled{true};
    EXPECT_FALSE(MotorPrediction::of(CompiledPattern(bursts(10)), assumedMotors(), cancelled));
    Pattern day;
    day.duration_s = Pattern::kLongest_s;
    EXPECT_FALSE(MotorPrediction::of(CompiledPattern(day), assumedMotors(), kGoOn));
    const auto nothing = MotorPrediction::of(CompiledPattern(), assumedMotors(), kGoOn);
    ASSERT_TRUE(nothing);
    EXPECT_EQ(nothing->over(0, 0.0, 1.0).high, 0.0F);
}
