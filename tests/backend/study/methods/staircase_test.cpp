// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/staircase.h"
#include "tests/backend/study/methods/tracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace teleta::study {
namespace {

constexpr LevelRange kUnit{LevelScale::linear, 0.0, 1.0};

StaircaseSettings settingsOf(double first, std::size_t down, double up, double downStep, double factor,
                             std::size_t reversals) {
    StaircaseSettings settings;
    settings.first = first;
    settings.down = down;
    settings.stepUp = up;
    settings.stepDown = downStep;
    settings.fastFactor = factor;
    settings.reversals = reversals;
    return settings;
}

void expectLevels(const std::vector<double>& got, const std::vector<double>& expected) {
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-12) << i;
}

std::vector<double> reversalLevels(const StaircaseTrack& track) {
    std::vector<double> levels;
    for (const std::size_t i : track.reversals)
        levels.push_back(track.levels[i]);
    return levels;
}

TrackEnd endOf(const StaircaseTrack& track) {
    const auto* end = std::get_if<TrackEnd>(&track.next);
    EXPECT_NE(end, nullptr);
    return end == nullptr ? TrackEnd{} : *end;
}

} // namespace

TEST(Staircase, twoDownTrackIsThatOfAnotherProgram) {
    const StaircaseSettings settings = settingsOf(0.6, 2, 0.05, 0.05, 2.0, 8);
    const auto kept = answeredTrials(settings, kUnit, "111111011011101011011");
    const StaircaseTrack track = staircaseTrack(settings, kUnit, kept);
    expectLevels(track.levels,
                 {.6, .6, .5, .5, .4, .4, .3, .4, .4, .35, .4, .4, .35, .35, .4, .4, .45, .45, .4, .45, .45});
    expectLevels(reversalLevels(track), {.3, .4, .35, .4, .35, .45, .4, .45});
    EXPECT_EQ(endOf(track).reason, EndReason::reversals);
    EXPECT_NEAR(*endOf(track).estimate, 0.4125, 1e-12);
}

TEST(Staircase, weightedTrackIsThatOfAnotherProgram) {
    const StaircaseSettings settings = settingsOf(0.5, 1, 0.09, 0.03, 1.0, 12);
    const auto kept = answeredTrials(settings, kUnit, "110101110110101101");
    const StaircaseTrack track = staircaseTrack(settings, kUnit, kept);
    expectLevels(track.levels,
                 {.5, .47, .44, .53, .5, .59, .56, .53, .5, .59, .56, .53, .62, .59, .68, .65, .62, .71});
    expectLevels(reversalLevels(track), {.44, .53, .5, .59, .5, .59, .53, .62, .59, .68, .62, .71});
    EXPECT_NEAR(*endOf(track).estimate, 0.605, 1e-12);
}

TEST(Staircase, endsAtTheFloorWithoutAnEstimate) {
    const LevelRange range{LevelScale::linear, 0.05, 1.0};
    const StaircaseSettings settings = settingsOf(0.3, 2, 0.05, 0.05, 2.0, 12);
    const auto kept = answeredTrials(settings, range, std::string(40, '1'));
    const StaircaseTrack track = staircaseTrack(settings, range, kept);
    expectLevels(track.levels, {.3, .3, .2, .2, .1, .1, .05, .05, .05, .05, .05, .05});
    EXPECT_TRUE(track.reversals.empty());
    EXPECT_EQ(endOf(track).reason, EndReason::atFloor);
    EXPECT_EQ(endOf(track).note, TrackNote::atFloor);
    EXPECT_FALSE(endOf(track).estimate);
}

TEST(Staircase, endsAtTheCeilingWithoutAnEstimate) {
    const StaircaseSettings settings = settingsOf(0.7, 2, 0.05, 0.05, 2.0, 12);
    const auto kept = answeredTrials(settings, kUnit, std::string(40, '0'));
    const StaircaseTrack track = staircaseTrack(settings, kUnit, kept);
    expectLevels(track.levels, {.7, .8, .9, 1., 1., 1.});
    EXPECT_EQ(endOf(track).reason, EndReason::atCeiling);
    EXPECT_FALSE(endOf(track).estimate);
}

TEST(Staircase, endsWithItsMostTrialsAndDropsTheOddReversal) {
    StaircaseSettings settings = settingsOf(0.5, 1, 0.1, 0.1, 1.0, 12);
    settings.skipReversals = 1;
    settings.mostTrials = 6;
    // .5 .4 .5 .4 .5 .4: reversals at .4 .5 .4 .5 .4, the first skipped, four left.
    const StaircaseTrack even = staircaseTrack(settings, kUnit, answeredTrials(settings, kUnit, "10101010"));
    EXPECT_EQ(even.levels.size(), 6U);
    EXPECT_EQ(endOf(even).reason, EndReason::mostTrials);
    EXPECT_NEAR(*endOf(even).estimate, 0.45, 1e-12);
    // Without skipping five are left: .4 is dropped, the mean of .5 .4 .5 .4.
    settings.skipReversals = 0;
    const StaircaseTrack odd = staircaseTrack(settings, kUnit, answeredTrials(settings, kUnit, "10101010"));
    EXPECT_NEAR(*endOf(odd).estimate, 0.45, 1e-12);
    settings.mostTrials = 2;
    const StaircaseTrack few = staircaseTrack(settings, kUnit, answeredTrials(settings, kUnit, "10"));
    EXPECT_EQ(endOf(few).note, TrackNote::tooFewReversals);
    EXPECT_FALSE(endOf(few).estimate);
}

TEST(Staircase, averagesReversalsOnTheLogarithmicScale) {
    StaircaseSettings settings;
    settings.skipReversals = 0;
    const double levels[] = {0.1, 0.4};
    EXPECT_NEAR(*reversalEstimate(settings, LevelScale::log10, levels), 0.2, 1e-15);
    EXPECT_NEAR(*reversalEstimate(settings, LevelScale::linear, levels), 0.25, 1e-15);
}

TEST(Staircase, passesOverTrialsThatDoNotCount) {
    const StaircaseSettings settings = settingsOf(0.6, 2, 0.05, 0.05, 2.0, 8);
    auto kept = answeredTrials(settings, kUnit, "111111011011101011011");
    for (std::size_t i = 0; i < kept.size(); i += 4)
        kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(i), KeptTrial{0.0, 1, false, false});
    EXPECT_NEAR(*endOf(staircaseTrack(settings, kUnit, kept)).estimate, 0.4125, 1e-12);
}

// Levitt 1971 (equal steps), Kaernbach 1991 (1 down), Garcia-Perez 1998 (ratios).
TEST(Staircase, tellsTheShareThatItTendsTo) {
    EXPECT_NEAR(targetShare(settingsOf(0, 1, 0.05, 0.05, 1, 0)), 0.5, 1e-12);
    EXPECT_NEAR(targetShare(settingsOf(0, 2, 0.05, 0.05, 1, 0)), 0.707107, 1e-6);
    EXPECT_NEAR(targetShare(settingsOf(0, 3, 0.05, 0.05, 1, 0)), 0.793701, 1e-6);
    EXPECT_NEAR(targetShare(settingsOf(0, 4, 0.05, 0.05, 1, 0)), 0.840896, 1e-6);
    EXPECT_NEAR(targetShare(settingsOf(0, 1, 0.15, 0.05, 1, 0)), 0.75, 1e-12);
    const double ratios[] = {.2845, .5488, .7393, .8415};
    const double shares[] = {.7785, .8035, .8315, .8584};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(targetShare(settingsOf(0, i + 1, 1.0 / ratios[i], 1.0, 1, 0)), shares[i], 1e-4) << i;
}

} // namespace teleta::study
