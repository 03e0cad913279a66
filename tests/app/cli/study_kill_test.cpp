// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/store/study_store.h"
#include "tests/app/cli/program_run.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>
#include <poll.h>
#include <string>
#include <tuple>
#include <vector>

namespace {

using namespace teleta::study;
using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::TemporaryFolder;

/// Qt finds its database drivers through the application.
const struct Application {
    int argc = 1;
    std::array<char, 5> name{"test"};
    std::array<char*, 2> argv{name.data(), nullptr};
    QCoreApplication application{argc, argv.data()};
} kApplication;

using Row = std::tuple<std::string, std::size_t, Phase, std::size_t, std::size_t, std::size_t,
                       std::optional<std::size_t>, std::optional<double>, std::string, std::optional<double>,
                       std::optional<std::size_t>>;

/// All trials of a study in the order of participants and sessions; nothing when it was not made yet.
std::vector<Row> rowsOf(const std::string& folder) {
    std::vector<Row> rows;
    const auto store = StudyStore::open(folder);
    if (!store)
        return rows;
    const auto participants = store->participants().value();
    for (const Participant& participant : participants) {
        const auto sessions = store->sessions(participant).value();
        for (const SessionRecord& session : sessions) {
            const auto trials = store->trials(session).value();
            for (const StoredTrial& trial : trials) {
                const TrialResult& r = trial.result;
                rows.emplace_back(participant.id, session.planIndex, r.planned.phase, r.planned.trial,
                                  r.planned.attempt, r.planned.stimulus, r.response, r.responseTime_s,
                                  r.planned.track, r.planned.level, r.planned.target);
            }
        }
    }
    return rows;
}

} // namespace

// A rehearsal of the paper's study is killed 100 times, each time after a random while, and goes on. What is
// there is always the beginning of what an undisturbed rehearsal of the same seed leaves, and never less than
// before.
TEST(StudyKill, aStudyKilledAtAHundredRandomInstantsLosesAndRepeatsNothing) {
    constexpr int kKills = 100;
    const TemporaryFolder folder;
    const std::string whole = folder.path("whole");
    ASSERT_EQ(run({"study", "rehearse", "--out", whole, "--seed", "3"}).exitCode, 0);
    const std::vector<Row> expected = rowsOf(whole);
    ASSERT_EQ(expected.size(), 6U * 176U);

    teleta::core::RandomStream random(11);
    int studies = 0;
    int killsBetweenTrials = 0;
    // The while in which the kill falls follows the machine: longer when the program had not come to its
    // first trial, shorter when it was done before.
    std::uint64_t longest_ms = 120;
    std::string killed;
    std::size_t before = expected.size();
    for (int kill = 0; kill < kKills; ++kill) {
        if (before == expected.size()) {
            killed = folder.path("killed" + std::to_string(studies++));
            before = 0;
        }
        const bool made = StudyStore::open(killed).has_value();
        {
            RunningProgram program(
                made ? std::vector<std::string>{"study", "resume", killed}
                     : std::vector<std::string>{"study", "rehearse", "--out", killed, "--seed", "3"});
            poll(nullptr, 0, static_cast<int>(random.below(longest_ms)));
            program.send(SIGKILL);
            (void)program.wait();
        }
        const std::vector<Row> rows = rowsOf(killed);
        ASSERT_GE(rows.size(), before);
        ASSERT_LE(rows.size(), expected.size());
        ASSERT_TRUE(std::equal(rows.begin(), rows.end(), expected.begin()));
        if (rows.size() == before)
            longest_ms += longest_ms / 4;
        else if (rows.size() == expected.size())
            longest_ms -= longest_ms / 4;
        else
            ++killsBetweenTrials;
        before = rows.size();
    }
    EXPECT_GT(killsBetweenTrials, kKills / 10) << "the program was hardly ever killed at work";

    if (StudyStore::open(killed)) {
        const ProgramResult resumed = run({"study", "resume", killed});
        EXPECT_EQ(resumed.exitCode, 0) << resumed.err;
        EXPECT_EQ(rowsOf(killed), expected);
    }
}

// Levels depend on the answers before them: a study of thresholds that is killed twice at work goes on with
// the levels that an undisturbed one has, and can be analysed.
TEST(StudyKill, aStudyOfThresholdsKilledTwiceEndsLikeAnUndisturbedOne) {
    const TemporaryFolder folder;
    const std::vector<std::string> rehearse{
        "study", "rehearse",   "tactor-detection",           "--participants", "1", "--seed",
        "3",     "--observer", "t=0.1,slope=3.5,lapse=0.02", "--out"};
    const auto into = [&](const std::string& where) {
        std::vector<std::string> arguments = rehearse;
        arguments.push_back(where);
        return arguments;
    };
    const std::string whole = folder.path("whole");
    const ProgramResult undisturbed = run(into(whole));
    ASSERT_EQ(undisturbed.exitCode, 0) << undisturbed.err;
    const std::vector<Row> expected = rowsOf(whole);
    ASSERT_EQ(expected.size(), 12U + 240U);

    // On a busy machine the program may be at its end before the kill comes: then there is another try.
    constexpr int kTries = 20;
    std::string killed;
    int kills = 0;
    for (int attempt = 0; kills < 2 && attempt < kTries; ++attempt) {
        killed = folder.path("killed" + std::to_string(attempt));
        std::size_t before = 0;
        for (kills = 0; kills < 2; ++kills) {
            RunningProgram program(kills == 0 ? into(killed)
                                              : std::vector<std::string>{"study", "resume", killed});
            // Until it has come some trials further.
            std::size_t now = before;
            while (now < before + 40) {
                poll(nullptr, 0, 5);
                now = rowsOf(killed).size();
            }
            program.send(SIGKILL);
            (void)program.wait();
            const std::vector<Row> rows = rowsOf(killed);
            ASSERT_GE(rows.size(), now);
            ASSERT_LE(rows.size(), expected.size());
            ASSERT_TRUE(std::equal(rows.begin(), rows.end(), expected.begin()));
            if (rows.size() == expected.size())
                break;
            before = rows.size();
        }
    }
    ASSERT_EQ(kills, 2) << "it was not killed at work";
    const ProgramResult resumed = run({"study", "resume", killed});
    EXPECT_EQ(resumed.exitCode, 0) << resumed.err;
    EXPECT_EQ(rowsOf(killed), expected);
    const ProgramResult results = run({"study", "analyze", killed, "--out", folder.path("results")});
    EXPECT_EQ(results.exitCode, 0) << results.err;
}
