// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/edit.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta::pattern;
using teleta::core::Expected;
using teleta::core::Intensities;

namespace {

/// One object of each kind over tracks.
Pattern everything() {
    const Expected<Pattern> read =
        loadPattern(std::string(TELETA_SOURCE_DIR) + "/tests/data/patterns/everything.json");
    EXPECT_TRUE(read);
    return read ? *read : Pattern{};
}

/// Tactor i of a is tactor place(i) of b, at every time.
template <typename Place>
void expectMoved(const Pattern& a, const Pattern& b, Place place) {
    for (double t_s = 0.003; t_s < a.duration_s; t_s += 0.017) {
        const Intensities before = evaluate(a, t_s);
        const Intensities after = evaluate(b, t_s);
        for (int i = 0; i < 6; ++i)
            EXPECT_NEAR(before[static_cast<std::size_t>(i)], after[static_cast<std::size_t>(place(i))], 1e-6)
                << t_s << ' ' << i;
    }
}

Pattern withTrack(Track track, double duration_s) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    pattern.tracks[1] = std::move(track);
    return pattern;
}

} // namespace

TEST(Edit, rotatingMovesTracksAndObjectsAroundTheRing) {
    const Pattern pattern = everything();
    for (const int steps : {1, 2, 5, -1, 7})
        expectMoved(pattern, rotated(pattern, steps), [steps](int i) { return (i + steps + 12) % 6; });
    EXPECT_EQ(rotated(pattern, 0), pattern);
}

TEST(Edit, mirroringMovesTracksAndObjectsToTheOtherSide) {
    const Pattern pattern = everything();
    for (const int axis : {0, 1, 2, 5})
        expectMoved(pattern, mirrored(pattern, axis), [axis](int i) { return (axis - i + 12) % 6; });
    expectMoved(pattern, forOtherArm(forOtherArm(pattern)), [](int i) { return i; });
    EXPECT_EQ(pattern.arm, Arm::right);
    EXPECT_EQ(forOtherArm(pattern).arm, Arm::left);
    EXPECT_EQ(forOtherArm(forOtherArm(pattern)).arm, Arm::right);
    EXPECT_EQ(mirrored(pattern, 0).arm, Arm::right) << "on the same arm";
}

TEST(Edit, stretchingMultipliesAllTimes) {
    Pattern pattern = everything();
    std::get<Sweep>(pattern.objects[0].form).onset_s = 0.08;
    std::get<Ring>(pattern.objects[1].form).burst_s = 0.12;
    const Expected<Pattern> longer = stretched(pattern, 3.0);
    ASSERT_TRUE(longer);
    EXPECT_DOUBLE_EQ(longer->duration_s, 13.5);
    for (double t_s = 0.0031; t_s < pattern.duration_s; t_s += 0.017) {
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_NEAR(evaluate(*longer, 3.0 * t_s)[i], evaluate(pattern, t_s)[i], 1e-9) << t_s;
    }
    for (const double factor : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e9})
        EXPECT_FALSE(stretched(pattern, factor)) << factor;
}

TEST(Edit, cuttingCopyingAndPastingInPlaceChangesNothing) {
    const Pattern pattern =
        withTrack({{0.0, 0.2}, {1.0, 0.8, Easing::hold}, {2.0, 0.4}, {2.0, 1.0}, {3.0, 0.0}}, 4.0);
    for (const Span range : {Span{0.5, 2.5}, Span{0.0, 4.0}, Span{1.5, 1.75}, Span{2.0, 3.5}}) {
        const Clip clip = copied(pattern, range);
        const Pattern again = pasted(erased(pattern, range), clip, range.begin_s);
        for (double t_s = 0.0; t_s < 4.0; t_s += 0.01)
            EXPECT_NEAR(evaluate(again, t_s)[1], evaluate(pattern, t_s)[1], 1e-12)
                << t_s << " cut from " << range.begin_s;
    }
}

TEST(Edit, erasingIsSilentInTheRangeAndNowhereElse) {
    const Pattern pattern = withTrack({{0.0, 0.2}, {1.0, 0.8}, {3.0, 0.4}}, 4.0);
    const Pattern cut = erased(pattern, {0.5, 2.0});
    for (double t_s = 0.005; t_s < 4.0; t_s += 0.01)
        EXPECT_NEAR(evaluate(cut, t_s)[1], t_s >= 0.5 && t_s < 2.0 ? 0.0 : evaluate(pattern, t_s)[1], 1e-12);
    TactorSet others = kAllTactors;
    others[1] = false;
    EXPECT_EQ(erased(pattern, {0.5, 2.0}, others), pattern);
}

TEST(Edit, pastingReplacesAndMakesThePatternLonger) {
    const Pattern pattern = withTrack({{0.0, 0.5}, {2.0, 0.5}}, 2.0);
    const Clip clip = copied(withTrack({{0.0, 1.0}, {1.0, 1.0}}, 1.0), {0.0, 1.0});
    const Pattern result = pasted(pattern, clip, 1.5);
    EXPECT_EQ(result.duration_s, 2.5);
    EXPECT_EQ(evaluate(result, 1.49)[1], 0.5);
    EXPECT_EQ(evaluate(result, 1.5)[1], 1.0);
    EXPECT_EQ(evaluate(result, 2.4)[1], 1.0);
    const Pattern gap = pasted(pattern, clip, 3.0);
    EXPECT_EQ(evaluate(gap, 2.5)[1], 0.0);
    EXPECT_EQ(evaluate(gap, 3.5)[1], 1.0);
}

TEST(Edit, easedSegmentsThatAreCutStayWithinTheTolerance) {
    for (const Easing easing : {Easing::easeIn, Easing::easeOut, Easing::easeInOut}) {
        const Pattern pattern = withTrack({{0.0, 0.0, easing}, {4.0, 1.0}}, 4.0);
        const Pattern again = pasted(pattern, copied(pattern, {0.01, 3.99}), 0.01);
        for (double t_s = 0.0; t_s < 4.0; t_s += 0.007)
            EXPECT_NEAR(evaluate(again, t_s)[1], evaluate(pattern, t_s)[1], kBakeTolerance) << t_s;
    }
}

TEST(Edit, rangesAndPlacesThatAreNoneChangeNothing) {
    const double nan = std::nan("");
    const Pattern pattern = withTrack({{0.0, 0.5}, {2.0, 0.5}}, 2.0);
    for (const Span range : {Span{1.0, 1.0}, Span{1.5, 0.5}, Span{nan, 1.0}, Span{0.0, nan}}) {
        EXPECT_EQ(erased(pattern, range), pattern);
        EXPECT_EQ(copied(pattern, range).duration_s, 0.0);
        EXPECT_EQ(pasted(pattern, copied(pattern, range), 0.5), pattern);
    }
    const Clip clip = copied(pattern, {0.0, 1.0});
    for (const double begin_s : {-1.0, nan, 1e9})
        EXPECT_EQ(pasted(pattern, clip, begin_s), pattern);
}
