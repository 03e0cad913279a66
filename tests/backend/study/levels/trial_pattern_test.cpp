// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/trial_pattern.h"
#include "tests/backend/study/levels/level_protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

using pattern::Pattern;

/// One tactor at full strength for 0.3 s.
Pattern burst() {
    Pattern pattern;
    pattern.id = "burst";
    pattern.duration_s = 0.3;
    pattern.tracks[0] = {{0.0, 1.0, pattern::Easing::hold}, {0.3, 1.0}};
    return pattern;
}

Pattern taps() {
    Pattern pattern;
    pattern.duration_s = 0.5;
    pattern.objects.push_back({"taps", pattern::Sweep{0.0, 0.1, 0.1, {0, 1}, 1.0}, {}});
    return pattern;
}

StudyTask task(const std::string& design, const std::string& level = "",
               const std::string& vary = "intensity") {
    return levelProtocol("design = \"" + design + "\"\n" + kTwoTracks +
                         "stimulus = { file = \"b.json\", vary = \"" + vary + "\" }\n" +
                         (level.empty() ? std::string("level = { lowest = 0.0, highest = 1.0 }\n") : level) +
                         "procedure = { kind = \"staircase\", first = 0.4 }\n")
        .tasks[0];
}

PlannedTrial trial(const std::string& track, double level, std::size_t target) {
    PlannedTrial planned;
    planned.track = track;
    planned.level = level;
    planned.target = target;
    return planned;
}

bool isSilent(const Pattern& pattern) {
    for (int i = 0; i <= 2000; ++i) {
        for (const double intensity : evaluate(pattern, pattern.duration_s * i / 2000.0)) {
            if (intensity != 0.0)
                return false;
        }
    }
    return true;
}

} // namespace

TEST(TrialPattern, hasItsIntervalsOneAfterTheOther) {
    const StudyTask interval = task("interval");
    const auto whole = trialPattern(interval, "rest", burst(), 0.5, trial("t2", 0.4, 1));
    ASSERT_TRUE(whole) << core::describe(whole.error());
    EXPECT_EQ(whole->duration_s, 1.5);
    // Nothing in the first interval and in the gap.
    for (const double t_s : {0.0, 0.1, 0.29, 0.6, 0.99}) {
        for (const double intensity : evaluate(*whole, t_s))
            EXPECT_EQ(intensity, 0.0) << t_s;
    }
    for (const double t_s : {1.0, 1.1, 1.29}) {
        EXPECT_EQ(evaluate(*whole, t_s)[1], 0.4) << t_s;
        EXPECT_EQ(evaluate(*whole, t_s)[0], 0.0) << "the track is another tactor";
    }
    EXPECT_EQ(evaluate(*whole, 1.31)[1], 0.0);
    const auto first = trialPattern(interval, "rest", burst(), 0.5, trial("t1", 0.4, 0));
    EXPECT_EQ(evaluate(*first, 0.1)[0], 0.4);
    EXPECT_EQ(evaluate(*first, 0.31)[0], 0.0);
    EXPECT_EQ(evaluate(*first, 1.1)[0], 0.0);
}

TEST(TrialPattern, ofACatchTrialIsSilentAllTheTime) {
    const auto whole = trialPattern(task("yes_no"), "rest", burst(), 0.5, trial("t1", 0.0, 0));
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->duration_s, 0.5);
    EXPECT_TRUE(isSilent(*whole));
}

TEST(TrialPattern, hasTheReferenceWhereTheLevelIsNot) {
    const StudyTask compare = task("compare", "level = { lowest = 0.0, highest = 1.0, reference = 0.6 }\n");
    const auto whole = trialPattern(compare, "rest", burst(), 0.5, trial("t1", 0.3, 1));
    EXPECT_EQ(evaluate(*whole, 0.1)[0], 0.6);
    EXPECT_EQ(evaluate(*whole, 1.1)[0], 0.3);

    const StudyTask same =
        task("same_different", "level = { lowest = 0.0, highest = 1.0, reference = 0.6 }\n");
    const std::vector<std::pair<double, double>> pairs{{0.6, 0.6}, {0.3, 0.3}, {0.6, 0.3}, {0.3, 0.6}};
    for (std::size_t target = 0; target < pairs.size(); ++target) {
        const auto both = trialPattern(same, "rest", burst(), 0.5, trial("t1", 0.3, target));
        EXPECT_EQ(evaluate(*both, 0.1)[0], pairs[target].first) << target;
        EXPECT_EQ(evaluate(*both, 1.1)[0], pairs[target].second) << target;
    }
}

TEST(TrialPattern, mayHaveTheReferenceOnOtherTactors) {
    const StudyTask compare =
        levelProtocol(
            "design = \"compare\"\ntrack = [{ id = \"t2\", tactors = [2], reference_tactors = [1] }]\n" +
            kStimulus + "level = { lowest = 0.2, highest = 1.0, reference = 0.6 }\n" +
            "procedure = { kind = \"bayes\" }\n")
            .tasks[0];
    const auto whole = trialPattern(compare, "rest", burst(), 0.5, trial("t2", 0.8, 0));
    EXPECT_EQ(evaluate(*whole, 0.1)[1], 0.8);
    EXPECT_EQ(evaluate(*whole, 0.1)[0], 0.0);
    EXPECT_EQ(evaluate(*whole, 1.1)[0], 0.6);
    EXPECT_EQ(evaluate(*whole, 1.1)[1], 0.0);
}

TEST(TrialPattern, setsWhatVaries) {
    const auto onset = [](double level) {
        const auto set = stimulusAt(taps(), Vary::onset, level, {3, 4});
        EXPECT_TRUE(set);
        return *set;
    };
    // Both at once.
    EXPECT_EQ(evaluate(onset(0.0), 0.05)[3], 1.0);
    EXPECT_EQ(evaluate(onset(0.0), 0.05)[4], 1.0);
    EXPECT_EQ(evaluate(onset(0.2), 0.05)[4], 0.0);
    EXPECT_EQ(evaluate(onset(0.2), 0.25)[4], 1.0);
    EXPECT_EQ(evaluate(onset(0.2), 0.25)[3], 0.0);
    EXPECT_EQ(evaluate(*stimulusAt(taps(), Vary::burst, 0.02, {}), 0.03)[0], 0.0);

    Pattern phantom;
    phantom.duration_s = 1.0;
    phantom.objects.push_back({"point", pattern::Phantom{0.0, 1.0, 0, 1, 0.5, 0.5, 1.0}, {}});
    const auto moved = stimulusAt(phantom, Vary::balance, 0.25, {4, 5});
    ASSERT_TRUE(moved);
    EXPECT_NEAR(evaluate(*moved, 0.5)[4], std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(evaluate(*moved, 0.5)[5], std::sqrt(0.25), 1e-12);
    EXPECT_EQ(evaluate(*stimulusAt(phantom, Vary::duration, 0.2, {}), 0.3)[0], 0.0);
}

TEST(TrialPattern, isFeltOnTheTactorsOfItsTrack) {
    const auto both = stimulusAt(burst(), Vary::intensity, 0.5, {2, 4});
    ASSERT_TRUE(both);
    EXPECT_EQ(evaluate(*both, 0.1)[2], 0.5);
    EXPECT_EQ(evaluate(*both, 0.1)[4], 0.5);
    EXPECT_EQ(evaluate(*both, 0.1)[0], 0.0);
    Pattern all;
    all.duration_s = 0.3;
    for (pattern::Track& track : all.tracks)
        track = {{0.0, 1.0, pattern::Easing::hold}, {0.3, 1.0}};
    const auto one = stimulusAt(all, Vary::intensity, 0.5, {3});
    ASSERT_TRUE(one);
    for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor)
        EXPECT_EQ(evaluate(*one, 0.1)[tactor], tactor == 3 ? 0.5 : 0.0);
}

TEST(TrialPattern, refusesAStimulusThatDoesNotFit) {
    EXPECT_FALSE(stimulusAt(burst(), Vary::onset, 0.1, {})) << "no sweep";
    Pattern two = taps();
    two.objects.push_back(two.objects.front());
    EXPECT_FALSE(stimulusAt(two, Vary::onset, 0.1, {})) << "two sweeps";
    EXPECT_FALSE(stimulusAt(taps(), Vary::onset, 0.1, {2, 3, 4})) << "two tactors do not become three";
    Pattern ring;
    ring.duration_s = 2.0;
    ring.objects.push_back({"ring", pattern::Ring{}, {}});
    EXPECT_TRUE(stimulusAt(ring, Vary::intensity, 0.1, {}));
    EXPECT_FALSE(stimulusAt(ring, Vary::intensity, 0.1, {2}));

    Protocol protocol = levelProtocol("design = \"interval\"\n" + kStimulus + kLogLevels +
                                          "procedure = { kind = \"bayes\" }\n",
                                      0, 1, 0.25);
    const auto fits = checkStimulus(protocol, protocol.tasks[0], burst());
    ASSERT_FALSE(fits) << "0.3 s in intervals of 0.25 s";
    EXPECT_NE(fits.error().message.find("0.3 s"), std::string::npos) << fits.error().message;
    protocol.stimulus_s = 0.3;
    EXPECT_TRUE(checkStimulus(protocol, protocol.tasks[0], burst()));
}

} // namespace teleta::study
