// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace teleta::pattern;
using teleta::core::ErrorKind;
using teleta::core::Expected;

namespace {

Pattern withObjects(std::vector<ObjectForm> forms, double duration_s) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    for (ObjectForm& form : forms)
        pattern.objects.push_back({"", std::move(form), {}});
    return pattern;
}

/// Largest difference at times that are no corners of either.
double difference(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (int k = 0; k < 5000; ++k) {
        const double t_s = a.duration_s * (k + 0.37) / 5000.0;
        for (std::size_t i = 0; i < 6; ++i)
            largest = std::max(largest, std::abs(evaluate(a, t_s)[i] - evaluate(b, t_s)[i]));
    }
    return largest;
}

} // namespace

TEST(Bake, ofEveryKindOfObjectStaysWithinTheTolerance) {
    Pattern pattern = withObjects(
        {Ring{0.0, 2.0, 4, 1, true, std::nullopt, 0.9}, Sweep{2.0, 0.1, std::nullopt, {0, 3, 1, 5}, 1.0},
         Phantom{0.5, 2.0, 2, 4, 0.1, 0.9, 1.0}, Ramp{1.0, 1.5, {0, 5}, 0.3, 0.95, Easing::easeInOut},
         PulseTrain{2.5, 0.9, 0.21, 0.1, {2}, 0.7}, Stroke{0.2, {{0.0, 0.3, 0.4}, {2.9, 5.9, 0.6}}, 0.8}},
        4.0);
    pattern.tracks[0] = {{0.0, 0.5, Easing::easeIn}, {3.0, 1.0}, {4.0, 0.0}};
    const Expected<Pattern> baked = bake(pattern);
    ASSERT_TRUE(baked) << describe(baked.error());
    EXPECT_TRUE(baked->objects.empty());
    EXPECT_LT(difference(pattern, *baked), kBakeTolerance);
    for (const Track& track : baked->tracks)
        EXPECT_LT(track.size(), 1000U);
}

TEST(Bake, ofBurstsIsTheirCornersAndNothingElse) {
    const Expected<Pattern> baked = bake(withObjects({Sweep{0.5, 0.2, 0.3, {2, 3, 2}, 0.75}}, 2.0));
    ASSERT_TRUE(baked);
    ASSERT_EQ(baked->tracks[2].size(), 6U); // up, down; off; up, down
    const double corners_s[] = {0.5, 0.7, 0.7, 1.1, 1.1, 1.3};
    const double intensities[] = {0.75, 0.75, 0.0, 0.0, 0.75, 0.75};
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(baked->tracks[2][k].time_s, corners_s[k], 1e-8);
        EXPECT_NEAR(baked->tracks[2][k].intensity, intensities[k], 1e-9);
    }
    EXPECT_EQ(baked->tracks[3].size(), 2U);
    EXPECT_TRUE(baked->tracks[0].empty());
}

TEST(Bake, ofOneObjectLeavesTheOthersEditable) {
    const Pattern pattern = withObjects(
        {Ramp{0.0, 1.0, {0}, 0.0, 1.0, Easing::linear}, Ramp{0.0, 1.0, {1}, 1.0, 0.0, Easing::linear}}, 1.0);
    const Expected<Pattern> baked = bake(pattern, {1});
    ASSERT_TRUE(baked);
    ASSERT_EQ(baked->objects.size(), 1U);
    EXPECT_EQ(baked->objects[0], pattern.objects[0]);
    EXPECT_TRUE(baked->tracks[0].empty());
    EXPECT_EQ(baked->tracks[1].size(), 2U);
    EXPECT_LT(difference(pattern, *baked), 1e-6);
}

TEST(Bake, leavesTracksAloneThatNoObjectTouches) {
    Pattern pattern = *findBuiltIn("stiffness.A.dynamic");
    pattern.objects.push_back({"", Ramp{0.0, 1.0, {0}, 0.0, 1.0, Easing::linear}, {}});
    const Expected<Pattern> baked = bake(pattern);
    ASSERT_TRUE(baked);
    for (std::size_t i = 1; i < 6; ++i)
        EXPECT_EQ(baked->tracks[i], pattern.tracks[i]);
}

TEST(Bake, refusesMorePulsesThanATrackHolds) {
    const Expected<Pattern> baked =
        bake(withObjects({PulseTrain{0.0, 1000.0, 1e-6, 1e-7, {0}, 1.0}}, 1000.0));
    ASSERT_FALSE(baked);
    EXPECT_EQ(baked.error().kind, ErrorKind::refused);
    EXPECT_TRUE(bake(Pattern{}));
    EXPECT_TRUE(bake(withObjects({Ring{}, Stroke{}, Sweep{}}, 0.0)));
}

TEST(Linearised, keepsLinesAndHoldsExactly) {
    Pattern pattern;
    pattern.duration_s = 3.0;
    pattern.tracks[4] = {{0.1, 0.2, Easing::hold}, {1.1, 0.4}, {2.1, 0.9}};
    const Expected<Track> lines = linearised(pattern, 4);
    ASSERT_TRUE(lines);
    EXPECT_EQ(*lines, (Track{{0.1, 0.2}, {1.1, 0.2}, {1.1, 0.4}, {2.1, 0.9}}));
}

TEST(Linearised, ofTheSquareRootStaysWithinTheToleranceToo) {
    Pattern pattern = *findBuiltIn("shape.F.dynamic");
    const Expected<Track> lines = linearised(pattern, 0, [](double a) { return std::sqrt(a); });
    ASSERT_TRUE(lines);
    Pattern root = pattern;
    root.tracks[0] = *lines;
    for (int k = 0; k < 1000; ++k) {
        const double t_s = 0.002 * (k + 0.5);
        EXPECT_NEAR(evaluate(root, t_s)[0], std::sqrt(t_s / 2.0), kBakeTolerance) << t_s;
    }
}

TEST(Simplified, takesOutWhatLiesOnALine) {
    EXPECT_EQ(simplified({{0.0, 0.0}, {1.0, 0.25}, {2.0, 0.5}, {3.0, 0.75}, {3.0, 0.75}, {4.0, 0.0}}),
              (Track{{0.0, 0.0}, {3.0, 0.75}, {4.0, 0.0}}));
    EXPECT_EQ(simplified({{1.0, 0.0}, {1.0, 0.5}, {1.0, 1.0}, {2.0, 1.0}}),
              (Track{{1.0, 0.0}, {1.0, 1.0}, {2.0, 1.0}}));
    EXPECT_TRUE(simplified({}).empty());
}
