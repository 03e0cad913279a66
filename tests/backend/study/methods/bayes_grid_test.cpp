// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "tests/backend/study/methods/tracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace teleta::study {
namespace {

constexpr LevelRange kDrive{LevelScale::log10, 0.01, 1.0};
const std::string kAnswers = "1101110111011111011101111";

void expectTrack(const BayesSettings& settings, const std::vector<double>& places) {
    const auto kept = answeredTrials(settings, kDrive, kAnswers);
    ASSERT_EQ(kept.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(std::log10(kept[i].level), places[i], 1e-9) << i;
}

BayesTrack runOf(const BayesGrid& grid, const std::string& answers) {
    BayesTrack track(grid);
    for (const char answer : answers)
        track.add(track.bestLevel(), answer == '1');
    return track;
}

} // namespace

// Level by level what the Python package questplus shows, in terms of this threshold.
TEST(BayesGrid, trackOfOneSlopeIsThatOfAnotherProgram) {
    BayesSettings settings;
    settings.slope = {3.5};
    settings.lapse = {0.02};
    expectTrack(settings, {-.85, -1.05, -1.25, -.75, -.8,  -.9, -.95, -.65, -.7,  -.75, -.8, -.6, -.65,
                           -.7,  -.75,  -.75,  -.8,  -.65, -.7, -.7,  -.75, -.65, -.7,  -.7, -.7});
    const BayesGrid grid(settings, kDrive);
    EXPECT_NEAR(runOf(grid, kAnswers).belief().mean, -.8149041, 1e-7);
}

TEST(BayesGrid, trackOfTheDefaultGridIsThatOfAnotherProgram) {
    const BayesSettings settings;
    expectTrack(settings, {-.9,  -1.05, -1.2, -.75, -.8,  -.9,  -1., -.7, -.8, -.85, -.85, -.65, -.7,
                           -.75, -.8,   -.9,  -.9,  -.75, -.75, -.8, -.8, -.7, -.7,  -.75, -.75});
    const BayesGrid grid(settings, kDrive);
    const BayesTrack track = runOf(grid, kAnswers);
    EXPECT_NEAR(track.belief().mean, -.8908002, 1e-7);
    EXPECT_NEAR(track.meanSlope(), 4.834940, 1e-6);
    EXPECT_NEAR(track.meanLapse(), .02905956, 1e-8);
}

TEST(BayesGrid, saysThatAThresholdIsBelowOrAboveTheRange) {
    const BayesGrid grid(BayesSettings{}, kDrive);
    const BayesTrack right = runOf(grid, std::string(30, '1'));
    EXPECT_EQ(right.belief().note, TrackNote::belowRange);
    const std::vector<double> mass = right.thresholdMass();
    EXPECT_NEAR(mass[0] + mass[1], .976, 5e-4);
    const auto kept = answeredTrials(BayesSettings{}, kDrive, std::string(30, '1'));
    EXPECT_NEAR(std::log10(kept.back().level), -1.9, 1e-9);
    EXPECT_EQ(runOf(grid, std::string(30, '0')).belief().note, TrackNote::aboveRange);
}

} // namespace teleta::study
