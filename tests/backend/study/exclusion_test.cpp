// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/exclusion.h"
#include "backend/study/analysis/trials/exclusion_book.h"
#include "backend/study/analysis/trials/exclusion_results.h"
#include "backend/study/protocol/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace teleta::study {

namespace {

ExclusionRule rule(ExclusionKind kind, double value) {
    return {toString(kind), kind, value, false};
}

/// A right answer after a time.
ExcludableTrial answered(double time_s) {
    ExcludableTrial trial;
    trial.task = "shape";
    trial.condition = "static";
    trial.session = "s1";
    trial.stimulus = trial.response = "A";
    trial.responseTime_s = time_s;
    trial.chance = 0.5;
    return trial;
}

ExcludableTrial answer(Phase phase, bool right, std::string_view session = "s1") {
    ExcludableTrial trial = answered(1.0);
    trial.session = session;
    trial.phase = phase;
    trial.response = right ? "A" : "B";
    trial.chance = 1.0 / 6.0;
    return trial;
}

std::vector<std::size_t> excludedOf(const Exclusions& exclusions) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < exclusions.rule.size(); ++i) {
        if (exclusions.rule[i])
            indices.push_back(i);
    }
    return indices;
}

std::vector<std::size_t> excludedBy(const ExclusionRule& one, const std::vector<ExcludableTrial>& trials) {
    return excludedOf(applyExclusions(std::array{one}, trials));
}

constexpr std::array kTimes_s{.61, .72, .80, .85, .93, 1.02, 1.10, 1.31, 2.9, 4.8};

} // namespace

// Expected values: R, mad(log(x)).
TEST(MadLimits, areThoseOfR) {
    const auto limits = madLimits(kTimes_s, 3.0);
    ASSERT_TRUE(limits);
    EXPECT_NEAR(limits->low_s, .3252548, 1e-6 * .3252548);
    EXPECT_NEAR(limits->high_s, 2.916482, 1e-6 * 2.916482);
}

TEST(Exclusions, madLeavesOutWhatIsBeyondItsLimits) {
    std::vector<ExcludableTrial> trials;
    for (const double time_s : kTimes_s)
        trials.push_back(answered(time_s));
    EXPECT_EQ(excludedBy(rule(ExclusionKind::responseTimeMad, 3.0), trials), std::vector<std::size_t>{9});
}

TEST(Exclusions, aMadOfZeroExcludesNothingAndSaysSo) {
    std::vector<ExcludableTrial> trials(4, answered(1.0));
    trials.push_back(answered(9.0));
    const Exclusions exclusions =
        applyExclusions(std::array{rule(ExclusionKind::responseTimeMad, 3.0)}, trials);
    EXPECT_TRUE(excludedOf(exclusions).empty());
    EXPECT_EQ(exclusions.counts[0].cellsWithoutSpread, 1U);
    EXPECT_EQ(exclusions.counts[0].trials, 0U);
}

TEST(Exclusions, madLooksAtEachConditionByItself) {
    std::vector<ExcludableTrial> trials;
    for (const double time_s : {1.0, 1.1, 1.2, 1.3})
        trials.push_back(answered(time_s));
    for (const double time_s : {10.0, 11.0, 12.0, 13.0}) {
        trials.push_back(answered(time_s));
        trials.back().condition = "dynamic";
    }
    EXPECT_TRUE(excludedBy(rule(ExclusionKind::responseTimeMad, 3.0), trials).empty());
}

TEST(Exclusions, rulesAboutTimesLookAtAnsweredTestTrials) {
    std::vector<ExcludableTrial> trials{answered(0.1), answered(0.2), answered(5.0), answered(0.1),
                                        answered(0.1)};
    trials[3].response = {};
    trials[4].phase = Phase::practice;
    // The limit itself counts.
    EXPECT_EQ(excludedBy(rule(ExclusionKind::responseTimeBelow_s, 0.2), trials), std::vector<std::size_t>{0});
    EXPECT_EQ(excludedBy(rule(ExclusionKind::responseTimeAbove_s, 4.9), trials), std::vector<std::size_t>{2});
}

TEST(Exclusions, faultsAndMissedFramesAreCounted) {
    std::vector<ExcludableTrial> trials(3, answered(1.0));
    trials[1].deviceFaults = 1;
    trials[2].framesMissed = 4;
    EXPECT_EQ(excludedBy(rule(ExclusionKind::deviceFaults, 0.0), trials), std::vector<std::size_t>{1});
    EXPECT_EQ(excludedBy(rule(ExclusionKind::framesMissedAbove, 3.0), trials), std::vector<std::size_t>{2});
    EXPECT_TRUE(excludedBy(rule(ExclusionKind::framesMissedAbove, 4.0), trials).empty());
}

TEST(Exclusions, eachRuleSeesWhatTheOnesBeforeHaveLeft) {
    std::vector<ExcludableTrial> trials;
    for (const double time_s : kTimes_s)
        trials.push_back(answered(time_s));
    // Without 4.8 the median and the MAD are others: 2.9 is out as well.
    const std::array rules{rule(ExclusionKind::responseTimeAbove_s, 4.0),
                           rule(ExclusionKind::responseTimeMad, 3.0)};
    const Exclusions exclusions = applyExclusions(rules, trials);
    EXPECT_EQ(exclusions.rule[9], 0U);
    EXPECT_EQ(exclusions.rule[8], 1U);
    EXPECT_EQ(exclusions.counts[0].trialsBefore, 10U);
    EXPECT_EQ(exclusions.counts[1].trialsBefore, 9U);
}

TEST(Exclusions, sessionsAreLeftOutWithTheirPractice) {
    std::vector<ExcludableTrial> trials{answer(Phase::practice, true), answer(Phase::test, true),
                                        answer(Phase::test, true), answer(Phase::test, true, "s2")};
    trials[1].response = {};
    // Half of the test trials of s1 have no answer.
    EXPECT_EQ(excludedBy(rule(ExclusionKind::timeoutsShareAbove, 0.49), trials),
              (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_TRUE(excludedBy(rule(ExclusionKind::timeoutsShareAbove, 0.5), trials).empty());
    const Exclusions exclusions =
        applyExclusions(std::array{rule(ExclusionKind::timeoutsShareAbove, 0.2)}, trials);
    EXPECT_EQ(exclusions.counts[0].sessions, 1U);
    EXPECT_EQ(exclusions.counts[0].trials, 3U);
}

TEST(Exclusions, yesInCatchTrialsAndTheSameAnswerAreShares) {
    std::vector<ExcludableTrial> trials(4, answer(Phase::test, true));
    for (ExcludableTrial& trial : trials)
        trial.stimulus = "yes", trial.response = "yes";
    trials[0].stimulus = "no";
    trials[1].stimulus = "no";
    trials[1].response = "no";
    EXPECT_EQ(excludedBy(rule(ExclusionKind::catchYesShareAbove, 0.4), trials).size(), 4U);
    EXPECT_TRUE(excludedBy(rule(ExclusionKind::catchYesShareAbove, 0.5), trials).empty());
    // 3 of 4 are yes.
    EXPECT_EQ(excludedBy(rule(ExclusionKind::sameAnswerShareAbove, 0.7), trials).size(), 4U);
    EXPECT_TRUE(excludedBy(rule(ExclusionKind::sameAnswerShareAbove, 0.75), trials).empty());
}

// 10 of 30 right at 1/6: P(X >= 10) = 0.0197, 9 of 30: 0.0506 (R, pbinom).
TEST(Exclusions, participantsWhoOnlyGuessAreLeftOut) {
    const auto withRight = [](int right) {
        std::vector<ExcludableTrial> trials;
        for (int i = 0; i < 30; ++i)
            trials.push_back(answer(Phase::test, i < right));
        return trials;
    };
    const ExclusionRule chance = rule(ExclusionKind::accuracyNotAboveChance, 0.05);
    EXPECT_TRUE(excludedBy(chance, withRight(10)).empty());
    EXPECT_EQ(excludedBy(chance, withRight(9)).size(), 30U);
    const Exclusions exclusions = applyExclusions(std::array{chance}, withRight(3));
    EXPECT_TRUE(exclusions.counts[0].participant);
    // Answers without a right one say nothing about guessing.
    std::vector<ExcludableTrial> unscored = withRight(3);
    for (ExcludableTrial& trial : unscored)
        trial.chance = 0.0;
    EXPECT_TRUE(excludedBy(chance, unscored).empty());
}

TEST(Exclusions, practiceDecidesAboutAParticipant) {
    const std::vector<ExcludableTrial> trials{answer(Phase::practice, true), answer(Phase::practice, false),
                                              answer(Phase::test, true)};
    EXPECT_EQ(excludedBy(rule(ExclusionKind::practiceAccuracyBelow, 0.6), trials).size(), 3U);
    EXPECT_TRUE(excludedBy(rule(ExclusionKind::practiceAccuracyBelow, 0.5), trials).empty());
}

TEST(Exclusions, nothingInNothingOut) {
    EXPECT_TRUE(applyExclusions({}, {}).counts.empty());
    const Exclusions exclusions =
        applyExclusions(std::array{rule(ExclusionKind::accuracyNotAboveChance, 0.05),
                                   rule(ExclusionKind::practiceAccuracyBelow, 0.5),
                                   rule(ExclusionKind::responseTimeMad, 3.0)},
                        {});
    EXPECT_FALSE(exclusions.counts[0].participant);
    EXPECT_EQ(exclusions.counts.size(), 3U);
}

TEST(ExclusionBook, keepsTheResultsWithAndWithoutTheRules) {
    ExclusionRule fast = rule(ExclusionKind::responseTimeBelow_s, 0.5);
    fast.afterTheData = true;
    ExclusionBook book({fast});
    TrialTally tally;
    for (const char* id : {"P1", "P2"}) {
        for (int i = 0; i < 4; ++i) {
            const double time_s = i == 0 && std::string(id) == "P1" ? 0.1 : 1.0;
            ASSERT_TRUE(book.hold(
                {{id, "shape", "static", Phase::test, "A", i == 0 ? "B" : "A", time_s}, "s1", 0, 0, true, {}},
                {}));
        }
    }
    ASSERT_TRUE(book.finish(tally));
    ASSERT_TRUE(book.isUsed());
    const auto with = studyResults(tally);
    const ExclusionReport report = exclusionReport(book);
    ASSERT_EQ(with.size(), 1U);
    EXPECT_EQ(with[0].groups[0].matrix.total(), 7);
    EXPECT_EQ(report.withoutRules.at(0).groups[0].matrix.total(), 8);
    ASSERT_EQ(report.lines.size(), 2U);
    EXPECT_EQ(report.lines[0].participant, "");
    EXPECT_TRUE(report.lines[0].afterTheData);
    EXPECT_EQ(report.lines[0].trials, 1U);
    EXPECT_EQ(report.lines[0].trialsBefore, 8U);
    EXPECT_EQ(report.lines[1].participant, "P1");
    const auto compared = comparedResults(with, report.withoutRules);
    ASSERT_FALSE(compared.empty());
    EXPECT_NEAR(compared[0].accuracy.value(), (1.0 + 0.75) / 2, 1e-12);
    EXPECT_NEAR(compared[0].accuracyWithout.value(), 0.75, 1e-12);
}

TEST(ExclusionBook, rowsThatAreMarkedAlreadyAreNotSeenByTheRules) {
    ExclusionBook book;
    TrialTally tally;
    ASSERT_TRUE(tally.add({"P1", "shape", "static", Phase::test, "A", "A", 1.0}));
    ASSERT_TRUE(
        book.hold({{"P1", "shape", "static", Phase::test, "A", "B", 1.0}, "s1", 0, 0, true, "fast"}, {}));
    ASSERT_TRUE(book.finish(tally));
    EXPECT_EQ(studyResults(tally).at(0).groups[0].matrix.total(), 1);
    EXPECT_EQ(studyResults(book.withoutRules()).at(0).groups[0].matrix.total(), 2);
    ASSERT_FALSE(book.lines().empty());
    EXPECT_EQ(book.lines()[0].rule, "fast");
    EXPECT_FALSE(book.lines()[0].kind);
}

TEST(ExclusionBook, withoutRulesNothingIsUsed) {
    ExclusionBook book;
    TrialTally tally;
    EXPECT_FALSE(book.hasRules({}));
    EXPECT_TRUE(book.finish(tally));
    EXPECT_FALSE(book.isUsed());
    EXPECT_TRUE(exclusionReport(book).lines.empty());
}

TEST(ExclusionRule, protocolsHaveThemInTheirOrder) {
    const auto paper = paperProtocol();
    ASSERT_TRUE(paper);
    const std::string rules =
        "\n[[exclude]]\nid = \"fast\"\nof = \"trial\"\nrule = \"response_time_below_s\"\n"
        "value = 0.2\n[[exclude]]\nid = \"guess\"\nof = \"participant\"\n"
        "rule = \"accuracy_not_above_chance\"\nvalue = 0.05\n";
    const auto protocol = parseProtocol(protocolText(*paper) + rules, "p.toml");
    ASSERT_TRUE(protocol) << core::describe(protocol.error());
    ASSERT_EQ(protocol->exclusions.size(), 2U);
    EXPECT_EQ(protocol->exclusions[0].id, "fast");
    EXPECT_EQ(protocol->exclusions[1].kind, ExclusionKind::accuracyNotAboveChance);
    EXPECT_EQ(protocol->exclusions[1].of(), ExclusionOf::participant);
    const auto again = parseProtocol(protocolText(*protocol), "again.toml");
    ASSERT_TRUE(again);
    EXPECT_EQ(again->exclusions, protocol->exclusions);
}

TEST(ExclusionRule, aRuleAboutSomethingElseIsAnErrorWithItsPlace) {
    const auto paper = paperProtocol();
    ASSERT_TRUE(paper);
    const std::string text = protocolText(*paper);
    const auto line = std::count(text.begin(), text.end(), '\n');
    const auto wrong = parseProtocol(
        text + "[[exclude]]\nid = \"a\"\nof = \"session\"\nrule = \"response_time_mad\"\nvalue = 3\n",
        "p.toml");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().where.line, line + 3);
    EXPECT_NE(core::describe(wrong.error()).find("response_time_mad"), std::string::npos);
    EXPECT_FALSE(parseProtocol(text + "[[exclude]]\nid = \"a\"\nof = \"trial\"\nrule = \"luck\"\nvalue = 3\n",
                               "p.toml"));
    EXPECT_FALSE(parseProtocol(
        text + "[[exclude]]\nid = \"a\"\nof = \"session\"\nrule = \"timeouts_share_above\"\nvalue = 1.5\n",
        "p.toml"));
}

TEST(ExclusionRule, theCommandLineGivesNameAndValue) {
    const auto one = parseExclusion("response_time_below_s=0.2");
    ASSERT_TRUE(one);
    EXPECT_EQ(one->id, "response_time_below_s");
    EXPECT_EQ(one->value, 0.2);
    EXPECT_TRUE(one->afterTheData);
    for (const char* wrong : {"", "luck=3", "response_time_below_s", "response_time_below_s=",
                              "response_time_below_s=0", "timeouts_share_above=1.1", "device_faults=1x"})
        EXPECT_FALSE(parseExclusion(wrong)) << wrong;
}

} // namespace teleta::study
