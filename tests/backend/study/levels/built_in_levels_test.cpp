// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/methods/adaptive/track.h"
#include "backend/study/methods/bracelet/best_onset.h"
#include "backend/study/protocol/level_sequence.h"
#include "backend/study/protocol/trial_pattern.h"
#include "backend/study/session/rehearsal.h"
#include "backend/study/session/simulated_observer.h"
#include "tests/backend/core/temporary_folder.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

/// Qt finds its database drivers through the application.
QCoreApplication& application() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    static QCoreApplication* application = QCoreApplication::instance() != nullptr
                                               ? QCoreApplication::instance()
                                               : new QCoreApplication(argc, argv);
    return *application;
}

Protocol builtIn(const std::string& name) {
    return readProtocol(":/studies/" + name + ".toml").value();
}

class BuiltInLevels : public testing::Test {
protected:
    BuiltInLevels() { application(); }

    StudyStore create(const std::string& name, const std::string& observer) {
        StudyHead head;
        head.protocol = builtIn(name);
        head.seed = 3;
        head.mode = Mode::simulated;
        head.plannedParticipants = 1;
        head.observer = observer;
        head.created = QDateTime(QDate(2026, 11, 3), QTime(14, 0), Qt::UTC);
        head.appVersion = "0.1.0";
        auto store = StudyStore::create(m_folder.path(name), head);
        EXPECT_TRUE(store) << core::describe(store.error());
        return std::move(*store);
    }

    /// Test trials of one condition by track.
    static std::map<std::string, std::vector<KeptTrial>> tracksOf(const StudyStore& store,
                                                                  std::size_t session = 0) {
        std::map<std::string, std::vector<KeptTrial>> tracks;
        const Participant participant = store.participants()->front();
        const SessionRecord record = store.sessions(participant)->at(session);
        const StudyTask& task = store.head().protocol.tasks[0];
        const auto trials = store.trials(record);
        for (const StoredTrial& stored : trials.value()) {
            const TrialResult& result = stored.result;
            if (result.planned.phase != Phase::test)
                continue;
            const bool yes = task.design == Design::yesNo ? result.response == 0U
                                                          : result.response == result.planned.target;
            tracks[result.planned.track].push_back(
                {*result.planned.level, result.response.value_or(0), yes,
                 movesTrack(task.design, *result.planned.target) &&
                     (task.design != Design::compare || result.response.has_value())});
        }
        return tracks;
    }

    /// The posterior mean of a track that is over, and how it ended.
    static TrackEnd endOf(const Protocol& protocol, const std::vector<KeptTrial>& kept) {
        const StudyTask& task = protocol.tasks[0];
        const TrackStep step =
            nextStep(procedureOf(task.design, task.levels, protocol.test.repetitions, false),
                     task.levels.range, 0, kept);
        EXPECT_TRUE(std::holds_alternative<TrackEnd>(step));
        return std::get<TrackEnd>(step);
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(BuiltInLevels, areThoseThatTheBraceletNeeds) {
    const std::map<std::string, Design> designs{{"tactor-detection", Design::interval},
                                                {"intensity-steps", Design::compare},
                                                {"equal-strength", Design::compare},
                                                {"two-or-one", Design::yesNo},
                                                {"motion-timing", Design::yesNo}};
    for (const auto& [name, design] : designs) {
        const auto read = readProtocol(":/studies/" + name + ".toml");
        ASSERT_TRUE(read) << core::describe(read.error());
        EXPECT_EQ(read->tasks[0].design, design) << name;
        EXPECT_EQ(read->window, ResponseWindow::fromEnd);
        EXPECT_TRUE(missingStimuli(*read).empty()) << name;
        const auto stimuli = readOwnStimuli(*read);
        ASSERT_TRUE(stimuli) << name << ' ' << core::describe(stimuli.error());
        EXPECT_EQ(stimuli->size(), 1U);
    }
}

TEST_F(BuiltInLevels, findTheThresholdOfEveryTactor) {
    StudyStore store = create("tactor-detection", "t=0.1,slope=3.5,lapse=0.02");
    const auto progress = rehearse(store);
    ASSERT_TRUE(progress) << core::describe(progress.error());
    const auto tracks = tracksOf(store);
    ASSERT_EQ(tracks.size(), 6U);
    double sum = 0.0;
    std::size_t trials = 0;
    for (const auto& [track, kept] : tracks) {
        trials += kept.size();
        const TrackEnd end = endOf(store.head().protocol, kept);
        EXPECT_EQ(end.note, TrackNote::none) << track;
        // 40 trials of this observer: a root mean square error of 0.078 in log10 units is published.
        EXPECT_NEAR(std::log10(end.estimate.value()), -1.0, 4.0 * 0.078) << track;
        sum += std::log10(*end.estimate);
    }
    EXPECT_EQ(trials, 240U);
    EXPECT_NEAR(sum / 6.0, -1.0, 0.045 + 4.0 * 0.078 / std::sqrt(6.0));
}

// A motor that is felt as soon as it turns has its threshold below what can be shown.
TEST_F(BuiltInLevels, sayBelowRangeWhereEverythingIsFelt) {
    StudyStore store = create("tactor-detection", "t=0.001,slope=3.5,lapse=0.0");
    ASSERT_TRUE(rehearse(store));
    for (const auto& [track, kept] : tracksOf(store))
        EXPECT_EQ(endOf(store.head().protocol, kept).note, TrackNote::belowRange) << track;
}

TEST_F(BuiltInLevels, findTheStepsAroundEachReference) {
    StudyStore store = create("intensity-steps", "slope=0.08,lapse=0.02");
    ASSERT_TRUE(rehearse(store));
    const Protocol& protocol = store.head().protocol;
    const std::vector<PlannedSession> plan = planSessions(protocol, store.head().seed, 0);
    ASSERT_EQ(plan.size(), 3U);
    for (std::size_t session = 0; session < 3; ++session) {
        const auto tracks = tracksOf(store, session);
        const TrackEnd end = endOf(protocol, tracks.at("all"));
        const double reference =
            protocol.tasks[0].referenceOf(protocol.tasks[0].conditions[plan[session].condition]);
        // The observer is not biased.
        EXPECT_NEAR(end.estimate.value(), reference, 0.1) << reference;
    }
}

TEST_F(BuiltInLevels, findWhereATactorFeelsAsStrongAsTheFirst) {
    StudyStore store = create("equal-strength", "t=0.72,slope=0.1,lapse=0.02");
    ASSERT_TRUE(rehearse(store));
    const auto tracks = tracksOf(store);
    ASSERT_EQ(tracks.size(), 5U);
    double sum = 0.0;
    for (const auto& [track, kept] : tracks) {
        const double pse = endOf(store.head().protocol, kept).estimate.value();
        EXPECT_NEAR(pse, 0.72, 0.12) << track;
        sum += pse;
    }
    EXPECT_NEAR(sum / 5.0, 0.72, 0.05);
}

TEST_F(BuiltInLevels, findWhenTwoTapsAreFeltAsTwo) {
    StudyStore store = create("two-or-one", "t=0.12,slope=0.03,lapse=0.02");
    ASSERT_TRUE(rehearse(store));
    const auto tracks = tracksOf(store);
    ASSERT_EQ(tracks.size(), 6U);
    std::size_t catches = 0;
    for (const auto& [track, kept] : tracks) {
        EXPECT_NEAR(endOf(store.head().protocol, kept).estimate.value(), 0.12, 0.05) << track;
        for (const KeptTrial& trial : kept) {
            catches += trial.counts ? 0 : 1;
            EXPECT_TRUE(trial.counts || trial.level == 0.0) << "a catch trial has both taps at once";
        }
    }
    EXPECT_GT(catches, 20U);
}

TEST_F(BuiltInLevels, showEveryTimingOfAMotionEquallyOften) {
    StudyStore store = create("motion-timing", "");
    ASSERT_TRUE(rehearse(store));
    std::map<double, std::size_t> counts;
    const auto tracks = tracksOf(store);
    for (const KeptTrial& trial : tracks.at("all"))
        ++counts[trial.level];
    ASSERT_EQ(counts.size(), 7U);
    for (const auto& [level, count] : counts)
        EXPECT_EQ(count, 12U) << level;
}

// People who feel one point best at 0.32 d + 47.3 ms, d = 0.1 s, and less at other times.
TEST_F(BuiltInLevels, findTheBestTimingOfAMotion) {
    constexpr double kBest_s = 0.32 * 0.1 + 0.0473;
    StudyStore store = create("motion-timing", "");
    RehearsalCast cast;
    cast.observe = [&](const StudyTask&, const std::string&, const PlannedTrial& trial, std::uint64_t,
                       std::uint64_t seed) {
        const double away = (*trial.level - kBest_s) / 0.05;
        const double share = 0.5 * std::erfc(-(1.5 - away * away) / std::sqrt(2.0));
        return SimulatedParticipant::Answer{core::RandomStream(seed).uniform() < share ? 0U : 1U, 2.0};
    };
    ASSERT_TRUE(rehearse(store, cast));
    std::map<double, OnsetCount> counts;
    const auto tracks = tracksOf(store);
    for (const KeptTrial& trial : tracks.at("all")) {
        OnsetCount& count = counts[trial.level];
        count.onset_s = trial.level;
        ++count.trials;
        count.yes += trial.correct ? 1.0 : 0.0;
    }
    std::vector<OnsetCount> list;
    for (const auto& [level, count] : counts)
        list.push_back(count);
    const BestOnset best = bestOnset(list);
    EXPECT_EQ(best.doubt, OnsetDoubt::none);
    EXPECT_LT(best.se_s, 0.02);
    EXPECT_NEAR(best.onset_s, kBest_s, 4.0 * best.se_s);
}

// Nobody has to be there for a rehearsal to be the same after an interruption.
TEST_F(BuiltInLevels, goOnWithTheSameTrialsAfterAnInterruption) {
    const auto answers = [&](const StudyStore& store) {
        std::vector<std::pair<double, std::size_t>> all;
        for (const auto& [track, kept] : tracksOf(store)) {
            for (const KeptTrial& trial : kept)
                all.emplace_back(trial.level, trial.answer);
        }
        return all;
    };
    StudyStore whole = create("tactor-detection", "t=0.2");
    ASSERT_TRUE(rehearse(whole));
    const auto expected = answers(whole);
    std::filesystem::rename(m_folder.path("tactor-detection"), m_folder.path("whole"));
    StudyStore store = create("tactor-detection", "t=0.2");
    for (const std::size_t until : {30U, 31U, 140U, 1000U}) {
        RehearsalCast cast;
        cast.goOn = [until](const RehearsalProgress& now) { return now.allTrials() < until; };
        ASSERT_TRUE(rehearse(store, cast));
    }
    EXPECT_EQ(answers(store), expected);
}

} // namespace teleta::study
