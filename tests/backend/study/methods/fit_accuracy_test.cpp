// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "tests/backend/study/methods/fit_data.h"

#include <gtest/gtest.h>

namespace teleta::study {
namespace {

/// Shares of profile intervals that hold the truth, of threshold and slope.
struct Coverage {
    double threshold = 0.0;
    double slope = 0.0;
};

Coverage coverageOf(std::int64_t trials, double slope, double lapse, std::uint64_t seed) {
    const PsychometricFunction truth{RiseShape::weibull, 0.07, slope, 0.5, lapse};
    const FitSettings settings = fitSettings(RiseShape::weibull, LevelScale::log10, 0.5, 0.0, 0.06);
    core::RandomStream random(seed);
    std::vector<LevelCount> counts = countsOf(kSixLevels, std::vector<int>(6), trials);
    constexpr int kSets = 1000;
    int held = 0;
    int slopeHeld = 0;
    int fitted = 0;
    for (int set = 0; set < kSets; ++set) {
        for (LevelCount& count : counts) {
            count.correct = 0;
            for (std::int64_t i = 0; i < trials; ++i)
                count.correct += random.uniform() < truth.shareAt(count.level) ? 1 : 0;
        }
        const PsychometricFit fit = fitPsychometric(counts, settings);
        if (!fit.threshold)
            continue;
        ++fitted;
        const auto holds = [](const OpenInterval& interval, double value) {
            return (!interval.low || *interval.low <= value) && (!interval.high || value <= *interval.high);
        };
        held += holds(fit.thresholdInterval, truth.threshold) ? 1 : 0;
        slopeHeld += fit.note == FitNote::slopeAtLimit || holds(fit.spreadInterval, slope) ? 1 : 0;
    }
    EXPECT_GT(fitted, 950);
    return {static_cast<double>(held) / fitted, static_cast<double>(slopeHeld) / fitted};
}

} // namespace

// Another program: .933, .930, .949, .959 for the threshold, .936 to .948 for the slope.
TEST(FitAccuracy, profileIntervalsHoldTheTruthAsOftenAsTheySay) {
    struct Case {
        std::int64_t trials;
        double slope, lapse;
    };
    std::uint64_t seed = 1;
    for (const Case& c : {Case{40, 2.0, .02}, Case{20, 2.0, .02}, Case{40, 4.0, .02}, Case{40, 2.0, .05}}) {
        const Coverage coverage = coverageOf(c.trials, c.slope, c.lapse, seed++);
        EXPECT_GE(coverage.threshold, 0.92) << c.trials << ' ' << c.slope << ' ' << c.lapse;
        EXPECT_LE(coverage.threshold, 0.97) << c.trials << ' ' << c.slope << ' ' << c.lapse;
        EXPECT_GE(coverage.slope, 0.92) << c.trials << ' ' << c.slope << ' ' << c.lapse;
        // A step has no slope, and counts as holding it.
        EXPECT_LE(coverage.slope, 0.98) << c.trials << ' ' << c.slope << ' ' << c.lapse;
    }
}

} // namespace teleta::study
