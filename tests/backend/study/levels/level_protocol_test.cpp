// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/stimulus_set.h"
#include "tests/backend/study/levels/level_protocol.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace teleta::study {

namespace {

core::Error errorOf(const std::string& task) {
    const auto read = parseProtocol(levelProtocolText(task), "levels.toml");
    EXPECT_FALSE(read) << task;
    return read ? core::Error{} : read.error();
}

/// The keys of a task as a protocol may have them, one of each design and procedure.
const std::vector<std::string>& tasks() {
    static const std::vector<std::string> kTasks{
        "design = \"interval\"\nintervals = 3\ngap_s = 0.75\nquestion = \"Which one?\"\n" + kTwoTracks +
            kStimulus + kLogLevels +
            "procedure = { kind = \"staircase\", first = 0.8, down = 3, step_up = 0.07, step_down = 0.05, "
            "fast_reversals = 3, fast_factor = 2.5, reversals = 10, skip_reversals = 2, most_trials = 70 }\n",
        "design = \"yes_no\"\ncatch_share = 0.25\n" + kTwoTracks + kStimulus + kLogLevels +
            "procedure = { kind = \"bayes\", function = \"weibull\", slope = [2, 4], lapse = [0.01], guess = "
            "[0.0, "
            "0.1], grid = 21, prior_mean = -1.0, prior_sd = 0.5, most_trials = 30, least_trials = 20, "
            "sd_at_most "
            "= 0.07 }\n",
        "design = \"same_different\"\n" + kStimulus +
            "level = { lowest = 0.2, highest = 1.0, reference = 0.4, values = [0.5, 0.75, 1.0], practice = "
            "0.75 "
            "}\nprocedure = { kind = \"constant\" }\n",
        "design = \"compare\"\ntrack = [{ id = \"a\", tactors = [2, 3], reference_tactors = [1, 6] }]\n" +
            kStimulus + "level = { lowest = 0.2, highest = 0.8, reference = 0.5 }\n" +
            "procedure = { kind = \"bayes\", most_trials = 40 }\n"};
    return kTasks;
}

} // namespace

TEST(LevelProtocol, isReadAsItIsWritten) {
    const StudyTask interval = levelProtocol(tasks()[0]).tasks[0];
    EXPECT_EQ(interval.design, Design::interval);
    EXPECT_EQ(interval.levels.intervals, 3U);
    EXPECT_EQ(interval.levels.gap_s, 0.75);
    EXPECT_EQ(interval.levels.question, "Which one?");
    ASSERT_EQ(interval.levels.tracks.size(), 2U);
    EXPECT_EQ(interval.levels.tracks[1].tactors, std::vector<std::size_t>{1});
    const auto& staircase = std::get<StaircaseSettings>(interval.levels.procedure);
    EXPECT_EQ(staircase.down, 3U);
    EXPECT_EQ(staircase.stepUp, 0.07);
    EXPECT_EQ(staircase.mostTrials, 70U);
    ASSERT_EQ(interval.patterns.size(), 3U);
    EXPECT_EQ(interval.patterns[2].letter, "3");

    const StudyTask yesNo = levelProtocol(tasks()[1]).tasks[0];
    const auto& bayes = std::get<BayesSettings>(yesNo.levels.procedure);
    EXPECT_EQ(bayes.guess, (std::vector<double>{0.0, 0.1}));
    EXPECT_EQ(bayes.priorMean, -1.0);
    EXPECT_EQ(bayes.sdAtMost, 0.07);
    EXPECT_EQ(yesNo.levels.range.scale, LevelScale::log10);
    EXPECT_EQ(yesNo.patterns[0].letter, "yes");

    const StudyTask same = levelProtocol(tasks()[2]).tasks[0];
    EXPECT_EQ(same.levels.values, (std::vector<double>{0.5, 0.75, 1.0}));
    EXPECT_EQ(same.levels.practiceLevel, 0.75);
    EXPECT_EQ(same.levels.tracks[0].id, "all");

    const StudyTask compare = levelProtocol(tasks()[3]).tasks[0];
    EXPECT_EQ(compare.levels.tracks[0].reference, (std::vector<std::size_t>{0, 5}));
    const auto& spreads = std::get<BayesSettings>(compare.levels.procedure);
    EXPECT_EQ(spreads.function, RiseShape::gauss);
    // The grid of the published simulation of comparisons on 0.2 to 0.8.
    const std::vector<double> expected{0.03, 0.05, 0.08, 0.12, 0.2};
    ASSERT_EQ(spreads.slope.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(spreads.slope[i], expected[i], 1e-12);
    EXPECT_EQ(spreads.lapse, (std::vector<double>{0.0, 0.02, 0.04}));
}

TEST(LevelProtocol, isTheSameWhenItIsWrittenAndReadAgain) {
    for (const std::string& task : tasks()) {
        const Protocol once = levelProtocol(task);
        const std::string text = protocolText(once);
        const auto again = parseProtocol(text, "again.toml");
        ASSERT_TRUE(again) << core::describe(again.error()) << '\n' << text;
        EXPECT_EQ(protocolText(*again), text);
        EXPECT_EQ(again->tasks[0].levels.procedure.index(), once.tasks[0].levels.procedure.index());
        EXPECT_EQ(again->tasks[0].levels.tracks.size(), once.tasks[0].levels.tracks.size());
        EXPECT_EQ(again->testTrials(), once.testTrials());
    }
}

TEST(LevelProtocol, hasReferencesOfItsConditions) {
    std::string text = levelProtocolText("design = \"compare\"\n" + kStimulus +
                                         "level = { lowest = 0.1, highest = 1.0 }\nprocedure = { kind = "
                                         "\"bayes\" }\n");
    EXPECT_FALSE(parseProtocol(text, "p.toml")) << "nothing to compare with";
    const std::string one = "[{ id = \"rest\" }]";
    text.replace(text.find(one), one.size(),
                 "[{ id = \"low\", reference = 0.3 }, { id = \"high\", reference = 0.7 }]");
    const auto read = parseProtocol(text, "p.toml");
    ASSERT_TRUE(read) << core::describe(read.error());
    EXPECT_EQ(read->tasks[0].referenceOf("low"), 0.3);
    EXPECT_EQ(read->tasks[0].referenceOf("high"), 0.7);
    EXPECT_EQ(parseProtocol(protocolText(*read), "p.toml")->tasks[0].referenceOf("high"), 0.7);
}

TEST(LevelProtocol, saysWhereWhatDoesNotGoTogetherIs) {
    const std::string good = tasks()[0];
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    struct Case {
        std::string task;
        std::string part; ///< of the message
        long long line;
    };
    // The task's first key is in line 15 of the protocol.
    const long long first = 15;
    const std::vector<Case> cases{
        {with("design = \"interval\"", "design = \"intervals\""), "interval", first},
        {with("intervals = 3", "intervals = 5"), "intervals", first + 1},
        {with("gap_s = 0.75", "gap_s = 0.1"), "gap_s", first + 2},
        {with("gap_s = 0.75", "catch_share = 0.2"), "catch_share", first + 2},
        {with("tactors = [1]", "tactors = [7]"), "tactors", first + 4},
        {with("tactors = [1]", "tactors = [1, 1]"), "tactor", first + 4},
        {with("\"t2\"", "\"t1\""), "twice", first + 4},
        {with("vary = \"intensity\"", "vary = \"loudness\""), "vary", first + 5},
        {with("lowest = 0.01", "lowest = 0.0"), "logarithms", first + 6},
        {with("lowest = 0.01", "lowest = 2.0"), "lowest", first + 6},
        {with("highest = 1.0", "highest = 1.5"), "1.5", first + 6},
        {with("reference = 0.0", "values = [0.2, 0.1]"), "rise", first + 6},
        {with("reference = 0.0", "values = [0.001]"), "0.001", first + 6},
        {with("first = 0.8", "first = 1.2"), "1.2", first + 7},
        {with("reversals = 10", "reversals = 3"), "reversals", first + 7},
        {with("down = 3", "down = 0"), "down", first + 7},
        {with("kind = \"staircase\", first = 0.8, down = 3, step_up = 0.07, step_down = 0.05, fast_reversals "
              "= "
              "3, fast_factor = 2.5, reversals = 10, skip_reversals = 2, most_trials = 70",
              "kind = \"constant\""),
         "levels", first + 7},
        {with("procedure = {", "pattern = [{ letter = \"A\" }, { letter = \"B\" }]\nprocedure = {"),
         "pattern", first + 7},
    };
    for (const Case& one : cases) {
        const core::Error error = errorOf(one.task);
        EXPECT_EQ(error.where.line, one.line) << core::describe(error) << '\n' << one.task;
        EXPECT_GT(error.where.column, 0) << core::describe(error);
        EXPECT_NE(core::describe(error).find(one.part), std::string::npos) << core::describe(error);
    }
}

TEST(LevelProtocol, wantsAnswersFromTheEnd) {
    std::string text = levelProtocolText(tasks()[0]);
    text.replace(text.find("from_end"), 8, "from_onset");
    const auto read = parseProtocol(text, "p.toml");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where.line, 15);
    EXPECT_NE(read.error().expected.find("from_end"), std::string::npos) << core::describe(read.error());
}

TEST(LevelProtocol, keepsTheKeysOfPatternsAndOfLevelsApart) {
    const core::Error error = errorOf(
        "pattern = [{ letter = \"A\" }, { letter = \"B\" }]\nstimulus = { file = \"burst.json\", vary = "
        "\"intensity\" }\n");
    EXPECT_NE(error.message.find("stimulus"), std::string::npos) << error.message;
    EXPECT_EQ(error.where.line, 16);
}

TEST(LevelProtocol, countsItsTrials) {
    // Two tracks of at most 70 trials.
    EXPECT_EQ(levelProtocol(tasks()[0]).testTrials(), 140U);
    // Three levels, twice each.
    EXPECT_EQ(levelProtocol(tasks()[2], 1, 2).testTrials(), 6U);
    const Protocol protocol = levelProtocol(tasks()[2], 3, 2);
    const PlannedSession session = planSessions(protocol, 5, 0)[0];
    EXPECT_EQ(session.practiceTrials, 3U);
    // Besides them there are as many with the same in both intervals as the seed draws.
    EXPECT_GE(session.testTrials, 6U);
}

} // namespace teleta::study
