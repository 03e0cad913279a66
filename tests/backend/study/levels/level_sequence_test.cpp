// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/protocol/level_sequence.h"
#include "tests/backend/study/levels/level_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

const std::string kStaircase =
    "procedure = { kind = \"staircase\", first = 0.6, down = 2, step_up = 0.05, step_down = 0.05, "
    "fast_reversals = 2, fast_factor = 2, reversals = 8, skip_reversals = 4, most_trials = 80 }\n";
const std::string kLinear = "level = { lowest = 0.0, highest = 1.0 }\n";

TrialResult answered(const PlannedTrial& trial, bool right, std::size_t answers) {
    TrialResult result;
    result.planned = trial;
    result.response = right ? trial.stimulus : (trial.stimulus + 1) % answers;
    result.outcome = right ? Outcome::correct : Outcome::incorrect;
    return result;
}

/// All trials of a session in which every answer is right.
std::vector<PlannedTrial> allRight(const Protocol& protocol, std::uint64_t seed = 7) {
    const PlannedSession plan = planSessions(protocol, seed, 0)[0];
    LevelSequence sequence(protocol, plan);
    std::vector<PlannedTrial> trials;
    while (const auto trial = sequence.next()) {
        trials.push_back(*trial);
        sequence.take(answered(*trial, true, protocol.tasks[0].patterns.size()));
        if (trials.size() > 5000)
            break;
    }
    return trials;
}

} // namespace

// Levels and reversals were computed by hand from the rules of Levitt 1971.
TEST(LevelSequence, followsAStaircase) {
    const Protocol protocol = levelProtocol("design = \"interval\"\n" + kStimulus + kLinear + kStaircase, 0);
    LevelSequence sequence(protocol, planSessions(protocol, 3, 0)[0]);
    const std::string answers = "111111011011101011011";
    const std::vector<double> levels{.6, .6,  .5,  .5, .4, .4,  .3,  .4, .4,  .35, .4,
                                     .4, .35, .35, .4, .4, .45, .45, .4, .45, .45};
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto trial = sequence.next();
        ASSERT_TRUE(trial) << i;
        EXPECT_NEAR(*trial->level, levels[i], 1e-12) << i;
        EXPECT_EQ(trial->trial, i + 1);
        sequence.take(answered(*trial, answers[i] == '1', 2));
    }
    EXPECT_FALSE(sequence.next()) << "the eighth reversal ends the track";
}

TEST(LevelSequence, drawsTheTargetOfEachTrialFromItsOwnSeed) {
    const Protocol protocol = levelProtocol(
        "design = \"interval\"\nintervals = 4\n" + kTwoTracks + kStimulus + kLinear + kStaircase, 2);
    const PlannedSession plan = planSessions(protocol, 3, 0)[0];
    LevelSequence sequence(protocol, plan);
    std::map<std::pair<Phase, std::string>, std::size_t> drawn;
    while (const auto trial = sequence.next()) {
        const std::size_t track = trial->track == "t1" ? 0 : 1;
        const std::uint64_t part = trial->phase == Phase::practice ? 0 : 1;
        const std::uint64_t seed = derivedSeed(derivedSeed(plan.seed, part), track);
        const std::size_t i = drawn[{trial->phase, trial->track}]++;
        EXPECT_EQ(trial->target, core::RandomStream(derivedSeed(seed, i)).below(4));
        EXPECT_EQ(trial->stimulus, trial->target);
        sequence.take(answered(*trial, i % 3 != 0, 4));
    }
    EXPECT_EQ((drawn[{Phase::practice, "t1"}]), 2U);
    EXPECT_GT((drawn[{Phase::test, "t2"}]), 8U);
}

TEST(LevelSequence, givesEachTrackItsTurnAndRestsItsPlace) {
    const Protocol protocol = levelProtocol(
        "design = \"interval\"\ntrack = [{ id = \"a\" }, { id = \"b\" }, { id = \"c\" }]\n" + kStimulus +
            "level = { lowest = 0.1, highest = 1.0, values = [0.2, 0.4, 0.6, 0.8] }\n" +
            "procedure = { kind = \"constant\" }\n",
        0, 10);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const std::vector<PlannedTrial> trials = allRight(protocol, seed);
        ASSERT_EQ(trials.size(), 120U);
        const std::uint64_t session = planSessions(protocol, seed, 0)[0].seed;
        std::map<std::pair<std::string, double>, int> counts;
        for (std::size_t i = 0; i < trials.size(); ++i) {
            ++counts[{trials[i].track, *trials[i].level}];
            EXPECT_TRUE(i == 0 || trials[i].track != trials[i - 1].track)
                << "seed " << seed << " trial " << i;
            if (i % 3 != 0)
                continue;
            const std::set<std::string> round{trials[i].track, trials[i + 1].track, trials[i + 2].track};
            EXPECT_EQ(round.size(), 3U);
            // The order, as it was decided once and for all.
            std::vector<std::string> order{"a", "b", "c"};
            core::RandomStream random(derivedSeed(session, 2 + i / 3));
            random.shuffle(std::span<std::string>(order));
            if (i > 0 && order[0] == trials[i - 1].track)
                std::swap(order[0], order[1]);
            EXPECT_EQ(trials[i].track, order[0]);
            EXPECT_EQ(trials[i + 2].track, order[2]);
        }
        EXPECT_EQ(counts.size(), 12U);
        for (const auto& [cell, count] : counts)
            EXPECT_EQ(count, 10) << cell.first << ' ' << cell.second;
    }
}

TEST(LevelSequence, showsAFaultyTrialAgainAndMovesNothing) {
    const Protocol protocol =
        levelProtocol("design = \"interval\"\n" + kTwoTracks + kStimulus + kLinear + kStaircase, 0);
    LevelSequence sequence(protocol, planSessions(protocol, 3, 0)[0]);
    const PlannedTrial before = *sequence.next();
    TrialResult fault;
    fault.planned = before;
    fault.outcome = Outcome::deviceError;
    sequence.take(fault);
    fault.outcome = Outcome::aborted;
    sequence.take(fault);
    const PlannedTrial again = *sequence.next();
    EXPECT_EQ(again.track, before.track);
    EXPECT_EQ(again.level, before.level);
    EXPECT_EQ(again.target, before.target);
    EXPECT_EQ(again.trial, before.trial);
    EXPECT_EQ(again.attempt, 3U);
}

TEST(LevelSequence, letsCatchTrialsMoveNoTrack) {
    const Protocol protocol =
        levelProtocol("design = \"yes_no\"\ncatch_share = 0.5\n" + kStimulus + kLinear +
                          "procedure = { kind = \"staircase\", first = 0.9, most_trials = "
                          "30, reversals = 20, step_up = 0.02, step_down = 0.02 }\n",
                      0);
    LevelSequence sequence(protocol, planSessions(protocol, 3, 0)[0]);
    std::size_t catches = 0;
    std::size_t signals = 0;
    double level = 0.9;
    while (const auto trial = sequence.next()) {
        TrialResult result;
        result.planned = *trial;
        result.response = 0; // always yes
        result.outcome = trial->stimulus == 0 ? Outcome::correct : Outcome::incorrect;
        if (trial->target == 0U) {
            ++catches;
            EXPECT_EQ(trial->level, 0.0);
            EXPECT_EQ(trial->stimulus, 1U) << "no is right";
        } else {
            ++signals;
            EXPECT_LE(*trial->level, level);
            level = *trial->level;
        }
        sequence.take(result);
    }
    EXPECT_GT(catches, 3U);
    EXPECT_LE(signals, 30U);
}

TEST(LevelSequence, drawsCatchTrialsWithTheirShare) {
    const Protocol protocol = levelProtocol("design = \"yes_no\"\ncatch_share = 0.2\n" + kStimulus +
                                                "level = { lowest = 0.1, highest = 1.0, values = [0.2, 0.4] "
                                                "}\nprocedure = { kind = \"constant\" }\n",
                                            0, 1000);
    const std::vector<PlannedTrial> trials = allRight(protocol);
    const auto catches =
        std::count_if(trials.begin(), trials.end(), [](const auto& t) { return t.target == 0U; });
    EXPECT_EQ(trials.size() - static_cast<std::size_t>(catches), 2000U);
    // 2000 trials of the other kind: a negative binomial with mean 500 and standard deviation 25.
    EXPECT_NEAR(static_cast<double>(catches), 500.0, 125.0);
    EXPECT_EQ(planSessions(protocol, 7, 0)[0].testTrials, trials.size()) << "the count is exact";
}

TEST(LevelSequence, takesNothingFromAComparisonWithoutAnAnswer) {
    const Protocol protocol =
        levelProtocol("design = \"compare\"\n" + kStimulus +
                          "level = { lowest = 0.0, highest = 1.0, reference = 0.5 }\n"
                          "procedure = { kind = \"staircase\", first = 0.8, step_up = 0.1, "
                          "step_down = 0.1, fast_factor = 1 }\n",
                      0);
    LevelSequence sequence(protocol, planSessions(protocol, 3, 0)[0]);
    const PlannedTrial first = *sequence.next();
    TrialResult silent;
    silent.planned = first;
    silent.outcome = Outcome::timeout;
    sequence.take(silent);
    const PlannedTrial second = *sequence.next();
    EXPECT_EQ(second.level, first.level);
    EXPECT_EQ(second.trial, 2U);
    sequence.take(answered(second, true, 2));
    EXPECT_NEAR(*sequence.next()->level, 0.7, 1e-12);
}

TEST(LevelSequence, knowsTheRightAnswerOfEachDesign) {
    EXPECT_EQ(rightAnswer(Design::yesNo, 1, 0.3, 0.0), 0U);
    EXPECT_EQ(rightAnswer(Design::yesNo, 0, 0.0, 0.0), 1U);
    EXPECT_EQ(rightAnswer(Design::interval, 2, 0.3, 0.0), 2U);
    EXPECT_EQ(rightAnswer(Design::sameDifferent, 1, 0.3, 0.2), 0U);
    EXPECT_EQ(rightAnswer(Design::sameDifferent, 3, 0.3, 0.2), 1U);
    EXPECT_EQ(rightAnswer(Design::compare, 1, 0.7, 0.5), 1U);
    EXPECT_EQ(rightAnswer(Design::compare, 1, 0.3, 0.5), 0U);
    EXPECT_EQ(rightAnswer(Design::compare, 1, 0.5, 0.5), 1U);
}

TEST(LevelSequence, isOverWithoutTrials) {
    const Protocol protocol =
        levelProtocol("design = \"interval\"\n" + kStimulus + kLinear + kStaircase, 0, 0);
    EXPECT_TRUE(allRight(protocol).empty());
}

TEST(LevelSequence, goesOnAfterAnyTrialAsIfItHadNotBeenInterrupted) {
    const Protocol protocol =
        levelProtocol("design = \"interval\"\n" + kTwoTracks + kStimulus + kLogLevels +
                          "procedure = { kind = \"bayes\", most_trials = 12, grid = 21 }\n",
                      1);
    const PlannedSession plan = planSessions(protocol, 11, 0)[0];
    core::RandomStream people(5);
    LevelSequence whole(protocol, plan);
    std::vector<TrialResult> kept;
    while (const auto trial = whole.next()) {
        LevelSequence resumed(protocol, plan);
        for (const TrialResult& result : kept)
            resumed.take(result);
        const auto same = resumed.next();
        ASSERT_TRUE(same);
        EXPECT_EQ(same->level, trial->level);
        EXPECT_EQ(same->track, trial->track);
        EXPECT_EQ(same->target, trial->target);
        kept.push_back(answered(*trial, people.uniform() < 0.75, 2));
        whole.take(kept.back());
    }
    EXPECT_EQ(kept.size(), 26U);
}

} // namespace teleta::study
