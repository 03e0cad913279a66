// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/methods/adaptive/bayes_grid.h"
#include "backend/study/methods/adaptive/staircase.h"
#include "tests/backend/study/methods/observer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace teleta::study {
namespace {

constexpr LevelRange kDrive{LevelScale::log10, 0.01, 1.0};

struct StaircaseRule {
    const char* name;
    double guess;
    std::size_t down;
    double stepUp, stepDown;
    std::size_t mostTrials;
    double lapse;
    double bias, rmse; ///< limits; of rmse 0: none
    double refused;    ///< share
};

StaircaseSettings settingsOf(const StaircaseRule& rule) {
    StaircaseSettings settings;
    settings.first = std::pow(10.0, -0.1);
    settings.down = rule.down;
    settings.stepUp = rule.stepUp;
    settings.stepDown = rule.stepDown;
    settings.mostTrials = rule.mostTrials;
    return settings;
}

TrackEnd runStaircase(const StaircaseSettings& settings, Observer& observer, std::size_t& trials) {
    std::vector<KeptTrial> kept;
    for (;;) {
        const TrackStep step = staircaseTrack(settings, kDrive, kept).next;
        if (const auto* end = std::get_if<TrackEnd>(&step)) {
            trials += kept.size();
            return *end;
        }
        const double level = std::get<NextLevel>(step).level;
        kept.push_back({level, 0, observer.answers(level)});
    }
}

struct BayesCase {
    const char* name;
    double guess;
    double slope, lapse;
    double bias, rmse;
    bool guessIsFree;
};

} // namespace

// Thresholds log-uniform in 10^-1.6 .. 10^-0.4; the error is against the level where the observer has the
// share that the rule tends to. Limits: those of another program's simulation of 2000 observers, widened.
TEST(StaircaseAccuracy, estimatesAreAsGoodAsThoseOfAnotherProgram) {
    const double ratio2 = 0.05 / 0.5488;
    const double ratio3 = 0.05 / 0.7393;
    const StaircaseRule rules[] = {
        {"2AFC 2 down", 0.5, 2, .05, .05, 80, .02, .02, .09, .01},
        {"2AFC 3 down", 0.5, 3, .05, .05, 120, .02, .025, .08, .01},
        {"2AFC 2 down ratio", 0.5, 2, ratio2, .05, 80, .02, .02, .08, .01},
        {"2AFC 3 down ratio", 0.5, 3, ratio3, .05, 120, .02, .03, .08, .01},
        {"2AFC 1 down 75 %", 0.5, 1, .15, .05, 80, .02, .025, .11, .02},
        {"3AFC 2 down", 1.0 / 3.0, 2, .05, .05, 80, .02, .02, .065, .01},
        {"yes/no 1 down", 0.02, 1, .05, .05, 80, .02, .02, .055, .01},
    };
    for (const StaircaseRule& rule : rules) {
        const StaircaseSettings settings = settingsOf(rule);
        core::RandomStream random(7, rule.name);
        Errors errors;
        std::size_t trials = 0;
        constexpr std::size_t kObservers = 2000;
        for (std::size_t i = 0; i < kObservers; ++i) {
            const PsychometricFunction truth{RiseShape::weibull,
                                             std::pow(10.0, -1.6 + 1.2 * random.uniform()), 3.5, rule.guess,
                                             rule.lapse};
            Observer observer(truth, random);
            const TrackEnd end = runStaircase(settings, observer, trials);
            if (end.estimate)
                errors.add(std::log10(*end.estimate / *truth.levelOf(targetShare(settings))));
        }
        EXPECT_LT(std::abs(errors.bias()), rule.bias) << rule.name;
        EXPECT_LT(errors.rmse(), rule.rmse) << rule.name;
        EXPECT_LT(static_cast<double>(kObservers - errors.count) / kObservers, rule.refused) << rule.name;
        RecordProperty(std::string(rule.name) + " trials", static_cast<int>(trials / kObservers));
    }
}

// Lapses send a staircase up, and it needs two or three right answers to come back down.
TEST(StaircaseAccuracy, lapsesShiftAStaircase) {
    const StaircaseRule rule{"lapses", 0.5, 2, .05, .05, 80, .05, 0, 0, 0};
    const StaircaseSettings settings = settingsOf(rule);
    double bias[2];
    for (const bool lapses : {false, true}) {
        core::RandomStream random(7, rule.name);
        Errors errors;
        std::size_t trials = 0;
        for (std::size_t i = 0; i < 2000; ++i) {
            const PsychometricFunction truth{RiseShape::weibull,
                                             std::pow(10.0, -1.6 + 1.2 * random.uniform()), 3.5, 0.5,
                                             lapses ? 0.05 : 0.0};
            Observer observer(truth, random);
            const TrackEnd end = runStaircase(settings, observer, trials);
            if (end.estimate)
                errors.add(std::log10(*end.estimate / *truth.levelOf(targetShare(settings))));
        }
        bias[lapses ? 1 : 0] = errors.bias();
    }
    EXPECT_GT(bias[1], bias[0] + 0.015);
}

// Limits: those of another program's simulation of 1000 observers, widened.
TEST(BayesAccuracy, estimatesAreAsGoodAsThoseOfAnotherProgram) {
    const BayesCase cases[] = {
        {"2AFC b 3.5", 0.5, 3.5, .02, .045, .09, false},
        {"2AFC b 2", 0.5, 2.0, .02, .025, .13, false},
        {"2AFC b 6", 0.5, 6.0, 0.0, .06, .08, false},
        {"2AFC lapses", 0.5, 3.5, .05, .025, .11, false},
        {"3AFC b 3.5", 1.0 / 3.0, 3.5, .02, .04, .075, false},
        {"yes/no", 0.05, 3.5, .02, .015, .05, true},
    };
    for (const BayesCase& c : cases) {
        BayesSettings settings;
        settings.guess =
            c.guessIsFree ? std::vector<double>{0.0, 0.05, 0.1, 0.2} : std::vector<double>{c.guess};
        const BayesGrid grid(settings, kDrive);
        core::RandomStream random(11, c.name);
        Errors errors;
        std::size_t held = 0;
        std::size_t flagged = 0;
        constexpr std::size_t kObservers = 400;
        for (std::size_t i = 0; i < kObservers; ++i) {
            const double place = -1.6 + 1.2 * random.uniform();
            Observer observer({RiseShape::weibull, std::pow(10.0, place), c.slope, c.guess, c.lapse}, random);
            BayesTrack track(grid);
            for (std::size_t trial = 0; trial < 40; ++trial) {
                const double level = track.bestLevel();
                track.add(level, observer.answers(level));
            }
            const ThresholdBelief belief = track.belief();
            errors.add(belief.mean - place);
            held += belief.low <= place && place <= belief.high ? 1 : 0;
            flagged += belief.note != TrackNote::none ? 1 : 0;
        }
        EXPECT_LT(std::abs(errors.bias()), c.bias) << c.name;
        EXPECT_LT(errors.rmse(), c.rmse) << c.name;
        EXPECT_EQ(flagged, 0U) << c.name << ": every threshold is in the range";
        // A prior that is uniform over the range of the truth and wider steps: at least 95 % in every case
        // whose slope and lapse rate are on the grid's range.
        EXPECT_GT(static_cast<double>(held) / kObservers, 0.93) << c.name;
    }
}

TEST(BayesAccuracy, findsEqualLevels) {
    BayesSettings settings;
    settings.function = RiseShape::gauss;
    settings.slope = {.03, .05, .08, .12, .2};
    settings.lapse = {0.0, .02, .04};
    settings.guessIsLapse = true;
    settings.grid = 25;
    const BayesGrid grid(settings, {LevelScale::linear, 0.2, 0.8});
    core::RandomStream random(13);
    Errors errors;
    for (std::size_t i = 0; i < 500; ++i) {
        const double equal = 0.35 + 0.3 * random.uniform();
        Observer observer({RiseShape::gauss, equal, 0.1, 0.02, 0.02}, random);
        BayesTrack track(grid);
        for (std::size_t trial = 0; trial < 40; ++trial) {
            const double level = track.bestLevel();
            track.add(level, observer.answers(level));
        }
        errors.add(track.belief().mean - equal);
    }
    EXPECT_LT(std::abs(errors.bias()), 0.006);
    EXPECT_LT(errors.rmse(), 0.03);
}

// Another program: 98.3 % of 10^-2.5 and 10^0.5 are flagged.
TEST(BayesAccuracy, flagsThresholdsOutsideOfTheRange) {
    const BayesGrid grid(BayesSettings{}, kDrive);
    core::RandomStream random(17);
    std::size_t flagged = 0;
    constexpr std::size_t kObservers = 200;
    for (std::size_t i = 0; i < kObservers; ++i) {
        const bool below = i % 2 == 0;
        Observer observer({RiseShape::weibull, std::pow(10.0, below ? -2.5 : 0.5), 3.5, 0.5, 0.02}, random);
        BayesTrack track(grid);
        for (std::size_t trial = 0; trial < 40; ++trial) {
            const double level = track.bestLevel();
            track.add(level, observer.answers(level));
        }
        flagged += track.belief().note == (below ? TrackNote::belowRange : TrackNote::aboveRange) ? 1 : 0;
    }
    EXPECT_GT(static_cast<double>(flagged) / kObservers, 0.95);
}

} // namespace teleta::study
