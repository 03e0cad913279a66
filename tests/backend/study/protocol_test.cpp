// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/protocol.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace teleta::study {

namespace {

const std::string kSmall = R"(name = "small"
stimulus_s = 1.0
response_limit_s = 4.0
response_window = "from_end"
order = "blocked_random"
[practice]
repetitions = 0
[test]
repetitions = 2
[masking_noise]
colour = "none"
[[task]]
id = "shape"
pattern = [{ letter = "A" }, { letter = "B" }]
condition = [{ id = "x" }, { id = "y" }, { id = "z" }]
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

core::Error errorOf(const std::string& text) {
    const core::Expected<Protocol> protocol = parseProtocol(text, "p.toml");
    EXPECT_FALSE(protocol);
    return protocol ? core::Error{} : protocol.error();
}

} // namespace

// Numbers: TeleTA, 5.3.
TEST(Protocol, ofThePaperHasItsTrialsAndTimes) {
    const core::Expected<Protocol> protocol = paperProtocol();
    ASSERT_TRUE(protocol) << core::describe(protocol.error());
    EXPECT_EQ(protocol->testTrials(), 110U);
    EXPECT_EQ(protocol->stimulus_s, 2.0);
    EXPECT_EQ(protocol->responseLimit_s, 10.0);
    EXPECT_EQ(protocol->noise_dBA, 65.0);
    EXPECT_TRUE(protocol->practice.feedback && protocol->practice.diagram);
    EXPECT_FALSE(protocol->test.feedback || protocol->test.diagram);
    const std::vector<PlannedSession> sessions = planSessions(*protocol, 1, 0);
    ASSERT_EQ(sessions.size(), 4U);
    EXPECT_EQ(sessions[0].practice.size(), 18U);
    EXPECT_EQ(sessions[0].test.size(), 30U);
    EXPECT_EQ(sessions[3].practice.size(), 15U);
    EXPECT_EQ(sessions[3].test.size(), 25U);
}

TEST(Protocol, ofThePaperIsTheFirstOfThoseThatComeWithTheProgram) {
    const core::Expected<std::vector<Protocol>> all = builtInProtocols();
    ASSERT_TRUE(all) << core::describe(all.error());
    ASSERT_FALSE(all->empty());
    EXPECT_EQ(all->front().source, paperProtocol()->source);
}

TEST(Protocol, hasRestsWhereItSaysSo) {
    EXPECT_EQ(parseProtocol(kSmall, "p.toml")->rest.everyTrials, 0U);
    const std::string rests = with(kSmall, "[masking_noise]",
                                   "[pause]\nevery_trials = 10\nat_least_s = 30.5\n"
                                   "[masking_noise]");
    const RestSettings rest = parseProtocol(rests, "p.toml").value().rest;
    EXPECT_EQ(rest.everyTrials, 10U);
    EXPECT_EQ(rest.atLeast_s, 30.5);
    for (const std::size_t completed : {0U, 9U, 11U, 19U})
        EXPECT_FALSE(rest.isDueAfter(completed)) << completed;
    EXPECT_TRUE(rest.isDueAfter(10) && rest.isDueAfter(20));
    EXPECT_FALSE(RestSettings().isDueAfter(10));
    const auto line = [&](const std::string& from, const std::string& to) {
        return errorOf(with(rests, from, to)).where.line;
    };
    EXPECT_EQ(line("every_trials = 10", "every_trials = 0"), 11);
    EXPECT_EQ(line("at_least_s = 30.5", "at_least_s = -1.0"), 12);
    EXPECT_EQ(line("at_least_s = 30.5", "at_least = 30.5"), 12) << "a key without its unit";
    EXPECT_EQ(line("every_trials = 10\n", ""), 10);
}

TEST(Protocol, readsWhatMayBeChanged) {
    const core::Expected<Protocol> protocol = parseProtocol(kSmall, "p.toml");
    ASSERT_TRUE(protocol) << core::describe(protocol.error());
    EXPECT_EQ(protocol->window, ResponseWindow::fromEnd);
    EXPECT_EQ(protocol->order, OrderMethod::blockedRandom);
    EXPECT_EQ(protocol->noiseColour, "none");
    EXPECT_EQ(protocol->tasks[0].conditions.size(), 3U);
    EXPECT_EQ(protocol->tasks[0].patterns[1].name, "B");
    EXPECT_EQ(protocol->source, kSmall);
    const std::vector<PlannedSession> sessions = planSessions(*protocol, 1, 5);
    ASSERT_EQ(sessions.size(), 3U);
    EXPECT_TRUE(sessions[0].practice.empty());
}

TEST(Protocol, saysWhereAValueIsWrong) {
    const core::Error error = errorOf(with(kSmall, "response_limit_s = 4.0", "response_limit_s = -1.0"));
    EXPECT_EQ(error.kind, core::ErrorKind::badInput);
    EXPECT_EQ(error.where.file, "p.toml");
    EXPECT_EQ(error.where.line, 3);
}

TEST(Protocol, refusesUnknownKeysAndMissingUnits) {
    EXPECT_EQ(errorOf(with(kSmall, "stimulus_s", "stimulus")).where.line, 2);
    EXPECT_EQ(errorOf(with(kSmall, "colour = \"none\"", "colour = \"none\"\nvolume = 3")).where.line, 12);
}

TEST(Protocol, refusesNamesThatAreThereTwice) {
    EXPECT_EQ(errorOf(with(kSmall, "\"B\"", "\"A\"")).where.line, 14);
    EXPECT_EQ(errorOf(with(kSmall, "\"z\"", "\"x\"")).where.line, 15);
}

TEST(Protocol, refusesNamesThatCannotStandInFileNamesOrMeanNoAnswer) {
    EXPECT_EQ(errorOf(with(kSmall, "\"shape\"", "\"../shape\"")).where.line, 13);
    EXPECT_EQ(errorOf(with(kSmall, "\"B\"", "\"NONE\"")).where.line, 14);
}

TEST(Protocol, refusesATaskWithOnePattern) {
    EXPECT_EQ(errorOf(with(kSmall, ", { letter = \"B\" }", "")).where.line, 14);
}

TEST(Protocol, refusesMorePatternsThanThereAreDigitsToAnswerWith) {
    const auto patterns = [](int count) {
        std::string list = "{ letter = \"B\" }";
        for (int i = 2; i < count; ++i)
            list += ",\n  { letter = \"" + std::string(1, static_cast<char>('A' + i)) + "\" }";
        return list;
    };
    const auto most = parseProtocol(with(kSmall, "{ letter = \"B\" }", patterns(9)), "p.toml");
    ASSERT_TRUE(most) << core::describe(most.error());
    EXPECT_EQ(most->tasks[0].patterns.size(), kMostPatterns);
    const core::Error error = errorOf(with(kSmall, "{ letter = \"B\" }", patterns(10)));
    EXPECT_EQ(error.kind, core::ErrorKind::badInput);
    EXPECT_EQ(error.where.line, 22) << "that of the tenth";
    EXPECT_NE(error.expected.find("at most 9"), std::string::npos) << error.expected;
}

TEST(Protocol, tellsAMissingFile) {
    const core::Expected<Protocol> protocol = readProtocol("/nowhere/p.toml");
    ASSERT_FALSE(protocol);
    EXPECT_EQ(protocol.error().kind, core::ErrorKind::notFound);
}

TEST(PlanSessions, takesConditionsInTurnByEnrolment) {
    const core::Expected<Protocol> protocol = paperProtocol();
    ASSERT_TRUE(protocol);
    for (std::size_t enrolment = 0; enrolment < 6; ++enrolment) {
        const std::vector<PlannedSession> sessions = planSessions(*protocol, 1, enrolment);
        EXPECT_EQ(sessions[0].condition, enrolment % 2);
        EXPECT_EQ(sessions[1].condition, 1 - enrolment % 2);
        EXPECT_EQ(sessions[0].sequenceRow, enrolment % 2);
        EXPECT_EQ(sessions[1].conditionPosition, 1U);
    }
}

TEST(PlanSessions, givesTheSamePlanAgainAndOthersToOthers) {
    const core::Expected<Protocol> protocol = paperProtocol();
    ASSERT_TRUE(protocol);
    EXPECT_EQ(planSessions(*protocol, 7, 3)[2].test, planSessions(*protocol, 7, 3)[2].test);
    std::set<std::vector<std::size_t>> orders;
    std::set<std::uint64_t> seeds;
    for (std::size_t enrolment = 0; enrolment < 20; ++enrolment) {
        for (const PlannedSession& session : planSessions(*protocol, 7, enrolment)) {
            orders.insert(session.test);
            seeds.insert(session.seed);
        }
    }
    EXPECT_EQ(orders.size(), 80U);
    EXPECT_EQ(seeds.size(), 80U);
}

} // namespace teleta::study
