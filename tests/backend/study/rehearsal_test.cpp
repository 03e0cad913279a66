// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/protocol.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/session/simulated_participant.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/paper_tables.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace teleta::study {

namespace {

using Row = std::tuple<std::string, std::string, int, std::size_t, std::size_t, std::size_t,
                       std::optional<std::size_t>, Outcome, std::optional<double>, qint64>;

class RehearsalTest : public testing::Test {
protected:
    StudyStore create(const std::string& name, std::size_t participants, Mode mode = Mode::simulated,
                      double lapses = 0.0) {
        StudyHead head;
        head.protocol = smallProtocol();
        head.seed = 5;
        head.mode = mode;
        head.plannedParticipants = participants;
        head.lapses = lapses;
        head.created = QDateTime(QDate(2026, 11, 3), QTime(9, 0), Qt::UTC);
        return std::move(StudyStore::create(m_folder.path(name), head).value());
    }

    static std::vector<Row> rows(const StudyStore& store) {
        std::vector<Row> all;
        const auto participants = store.participants().value();
        for (const Participant& participant : participants) {
            const auto sessions = store.sessions(participant).value();
            for (const SessionRecord& session : sessions) {
                const auto trials = store.trials(session).value();
                for (const StoredTrial& trial : trials) {
                    const TrialResult& r = trial.result;
                    all.emplace_back(participant.id, session.id, static_cast<int>(r.planned.phase),
                                     r.planned.trial, r.planned.attempt, r.planned.stimulus, r.response,
                                     r.outcome, r.responseTime_s, trial.time.toMSecsSinceEpoch());
                }
            }
        }
        return all;
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(RehearsalTest, takesEveryParticipantThroughAllTrials) {
    StudyStore store = create("study", 4);
    const auto progress = rehearse(store);
    ASSERT_TRUE(progress) << core::describe(progress.error());
    EXPECT_EQ(progress->participants, 4U);
    EXPECT_EQ(progress->trials, 4U * 2U * 9U);
    EXPECT_EQ(rows(store).size(), 72U);
    const auto participants = store.participants().value();
    for (const Participant& participant : participants) {
        const auto sessions = store.sessions(participant).value();
        for (const SessionRecord& session : sessions)
            EXPECT_TRUE(session.finished);
    }
}

TEST_F(RehearsalTest, isTheSameAfterAnInterruptionAtAnyTrial) {
    StudyStore whole = create("whole", 2);
    ASSERT_TRUE(rehearse(whole));
    const std::vector<Row> expected = rows(whole);
    for (std::size_t stop = 0; stop < expected.size(); stop += 9) {
        const std::string name = "stopped" + std::to_string(stop);
        {
            StudyStore store = create(name, 2);
            const auto progress = rehearse(
                store, {.goOn = [stop](const RehearsalProgress& now) { return now.allTrials() < stop; }});
            ASSERT_TRUE(progress);
            EXPECT_TRUE(progress->interrupted);
            EXPECT_EQ(progress->trials, stop);
        }
        StudyStore store = StudyStore::open(m_folder.path(name)).value();
        const auto progress = rehearse(store);
        ASSERT_TRUE(progress);
        EXPECT_EQ(progress->trialsBefore, stop);
        EXPECT_EQ(rows(store), expected) << "stopped after " << stop;
    }
}

TEST_F(RehearsalTest, restsWhereTheProtocolSaysSo) {
    const auto onsets_s = [&](const std::string& name, const RestSettings& rest) {
        StudyHead head;
        head.protocol = smallProtocol();
        head.protocol.rest = rest;
        head.protocol.source = protocolText(head.protocol);
        head.seed = 5;
        head.mode = Mode::simulated;
        head.plannedParticipants = 1;
        head.created = QDateTime(QDate(2026, 11, 3), QTime(9, 0), Qt::UTC);
        StudyStore store = std::move(StudyStore::create(m_folder.path(name), head).value());
        EXPECT_TRUE(rehearse(store));
        std::vector<double> onsets;
        const std::vector<Participant> participants = store.participants().value();
        const std::vector<SessionRecord> sessions = store.sessions(participants.front()).value();
        const std::vector<StoredTrial> trials = store.trials(sessions.front()).value();
        for (const StoredTrial& trial : trials)
            if (trial.result.planned.phase == Phase::test)
                onsets.push_back(trial.result.onset_s);
        return onsets;
    };
    const std::vector<double> without = onsets_s("without", {});
    const std::vector<double> with = onsets_s("with", {2, 100.0});
    ASSERT_EQ(with.size(), without.size());
    ASSERT_GE(with.size(), 5U);
    // Rests in practice move all of them; those in the test, one after every second trial.
    for (std::size_t i = 0; i < with.size(); ++i)
        EXPECT_NEAR(with[i] - without[i] - (with[0] - without[0]), 100.0 * static_cast<double>(i / 2), 1e-6)
            << i;
}

TEST_F(RehearsalTest, refusesAStudyWithRealParticipants) {
    StudyStore store = create("real", 2, Mode::run);
    const auto progress = rehearse(store);
    ASSERT_FALSE(progress);
    EXPECT_EQ(progress.error().kind, core::ErrorKind::refused);
    EXPECT_TRUE(store.participants()->empty());
}

TEST_F(RehearsalTest, lapsesTimeOut) {
    StudyStore store = create("lapses", 1, Mode::simulated, 1.0);
    ASSERT_TRUE(rehearse(store));
    for (const Row& row : rows(store)) {
        EXPECT_EQ(std::get<7>(row), Outcome::timeout);
        EXPECT_FALSE(std::get<6>(row));
        EXPECT_FALSE(std::get<8>(row));
    }
}

TEST(SimulatedParticipant, knowsTheTablesOfThePaper) {
    EXPECT_EQ(paperMatrix("shape", "dynamic"), matrixOf(kPaperTables[0].counts));
    EXPECT_EQ(paperMatrix("shape", "static"), matrixOf(kPaperTables[1].counts));
    EXPECT_EQ(paperMatrix("stiffness", "dynamic"), matrixOf(kPaperTables[2].counts));
    EXPECT_EQ(paperMatrix("stiffness", "static"), matrixOf(kPaperTables[3].counts));
    EXPECT_FALSE(paperMatrix("colour", "static"));
}

// Five standard deviations of a binomial share, and exactly none where the table has none.
TEST(SimulatedParticipant, givesTheMatrixBackWithinSamplingError) {
    constexpr int kTrials = 20'000;
    std::uint64_t seed = 0;
    for (const PaperTable& table : kPaperTables) {
        const SimulatedParticipant participant{matrixOf(table.counts)};
        ConfusionMatrix seen(table.counts.size());
        for (std::size_t i = 0; i < table.counts.size(); ++i) {
            for (int trial = 0; trial < kTrials; ++trial)
                seen.add(i, participant.answer(i, ++seed).response);
            for (std::size_t j = 0; j < table.counts.size(); ++j) {
                const double share = table.counts[i][j] / 30.0;
                EXPECT_NEAR(static_cast<double>(seen.count(i, j)) / kTrials, share,
                            5.0 * std::sqrt(share * (1.0 - share) / kTrials))
                    << table.name;
            }
        }
    }
}

// Median of a log-normal distribution; the standard error of its logarithm is 1.2533 spread / sqrt(n).
TEST(SimulatedParticipant, answersAfterTheMedianTimeInHalfOfTheTrials) {
    const SimulatedParticipant participant{assumedMatrix(5), 0.0, 2.5, 0.5};
    int later = 0;
    for (int i = 0; i < 10'000; ++i)
        later += participant.answer(1, static_cast<std::uint64_t>(i)).time_s > 2.5 ? 1 : 0;
    EXPECT_NEAR(later, 5000, 5.0 * 50.0);
}

TEST(SimulatedParticipant, guessesWhereTheMatrixSaysNothing) {
    const SimulatedParticipant participant{ConfusionMatrix(4)};
    ConfusionMatrix seen(4);
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        seen.add(0, participant.answer(0, seed).response);
    for (std::size_t j = 0; j < 4; ++j)
        EXPECT_NEAR(static_cast<double>(seen.count(0, j)), 1000.0, 5.0 * std::sqrt(4000 * 0.25 * 0.75));
}

TEST(SimulatedParticipant, leavesTheOtherDrawsAloneWhenOneIsLeftOut) {
    const SimulatedParticipant whole{assumedMatrix(5), 0.2, 2.5, 0.5};
    SimulatedParticipant sure = whole;
    sure.matrix.reset();
    SimulatedParticipant awake = whole;
    awake.lapses = 0.0;
    SimulatedParticipant steady = whole;
    steady.logSpread = 0.0;
    int lapses = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const SimulatedParticipant::Answer answer = whole.answer(3, seed);
        EXPECT_EQ(sure.answer(3, seed).time_s, answer.time_s);
        EXPECT_EQ(sure.answer(3, seed).response.has_value(), answer.response.has_value());
        EXPECT_EQ(awake.answer(3, seed).time_s, answer.time_s);
        EXPECT_EQ(steady.answer(3, seed).response, answer.response);
        EXPECT_EQ(steady.answer(3, seed).time_s, 2.5);
        EXPECT_EQ(sure.response(3, seed), 3U);
        EXPECT_EQ(answer.response.value_or(*awake.answer(3, seed).response), awake.answer(3, seed).response);
        lapses += answer.response ? 0 : 1;
    }
    EXPECT_NEAR(lapses, 100, 5.0 * std::sqrt(500 * 0.2 * 0.8));
}

} // namespace teleta::study
