// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/store/file_claim.h"
#include "backend/study/store/study_store.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"
#include "tests/support/generated_locale.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlQuery>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <clocale>
#include <csignal>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace teleta::study {

namespace {

using test::TemporaryFolder;

/// Qt finds its database drivers through the application.
const struct Application {
    int argc = 1;
    std::array<char, 5> name{"test"};
    std::array<char*, 2> argv{name.data(), nullptr};
    QCoreApplication application{argc, argv.data()};
} kApplication;

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);

class StudyStoreTest : public testing::Test {
protected:
    StudyHead head() {
        StudyHead head;
        head.protocol = smallProtocol();
        head.seed = 18'000'000'000'000'000'001U;
        head.mode = Mode::pilot;
        head.created = kNow;
        head.appVersion = "0.1.0";
        head.observer = "t=0.2,slope=3.5";
        return head;
    }

    StudyStore create() {
        auto store = StudyStore::create(folder(), head());
        EXPECT_TRUE(store) << core::describe(store.error());
        return std::move(*store);
    }

    [[nodiscard]] std::string folder() const { return m_folder.path("study"); }

    /// Runs a statement on the file, bypassing the store.
    void runSql(const QString& sql) {
        {
            QSqlDatabase database =
                QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("beside"));
            database.setDatabaseName(QString::fromStdString(folder() + "/study.sqlite"));
            ASSERT_TRUE(database.open());
            ASSERT_TRUE(QSqlQuery(database).exec(sql));
        }
        QSqlDatabase::removeDatabase(QStringLiteral("beside"));
    }

    static TrialResult answered() {
        TrialResult result;
        result.planned = {Phase::test, 3, 2, 1, 1};
        result.trialInBlock = 4;
        result.response = 2;
        result.outcome = Outcome::incorrect;
        result.responseTime_s = 0.1 + 0.2;
        result.responseTimeOffset_s = -1.75;
        result.responseDevice = "keyboard";
        result.responseKey = std::string("3");
        result.replays = 1;
        result.earlyPresses = 2;
        result.onset_s = 12.5;
        result.duration_s = 2.0;
        result.deviceLatency_ms = 4.25;
        result.deviceFaults = 1;
        result.frameWrite_ms = 0.125;
        result.framesMissed = 3;
        result.planned.track = "t2";
        result.planned.level = 0.1;
        result.planned.target = 1;
        result.trigger_ms = 0.75;
        result.latencySpread_ms = 1.5;
        result.recording = "P07_1.teleta";
        result.recording_s = 12.625;
        return result;
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(StudyStoreTest, keepsWhatTheStudyIs) {
    (void)create();
    const auto store = StudyStore::open(folder());
    ASSERT_TRUE(store) << core::describe(store.error());
    EXPECT_EQ(store->head().seed, 18'000'000'000'000'000'001U);
    EXPECT_EQ(store->head().mode, Mode::pilot);
    EXPECT_EQ(store->head().created, kNow);
    EXPECT_EQ(store->head().observer, "t=0.2,slope=3.5");
    EXPECT_EQ(store->head().protocol.tasks[0].patterns.size(), 3U);
    EXPECT_EQ(store->head().protocol.source, smallProtocol().source);
}

TEST_F(StudyStoreTest, neverOverwritesAStudy) {
    (void)create();
    const auto again = StudyStore::create(folder(), head());
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().kind, core::ErrorKind::refused);
}

TEST_F(StudyStoreTest, givesATrialBackAsItWas) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
    const SessionRecord session = store.beginSession(participant, 0, plan, kNow).value();
    TrialResult silent;
    silent.planned = {Phase::test, 4, 1, 1, 0};
    silent.trialInBlock = 5;
    ASSERT_TRUE(store.keepTrial(session, answered(), kNow));
    ASSERT_TRUE(store.keepTrial(session, silent, kNow.addSecs(20)));
    const auto trials = StudyStore::open(folder())->trials(session);
    ASSERT_TRUE(trials);
    ASSERT_EQ(trials->size(), 2U);
    const TrialResult& first = trials->front().result;
    EXPECT_EQ(first.planned.phase, Phase::test);
    EXPECT_EQ(first.planned.trial, 3U);
    EXPECT_EQ(first.planned.repetition, 2U);
    EXPECT_EQ(first.planned.attempt, 1U);
    EXPECT_EQ(first.planned.stimulus, 1U);
    EXPECT_EQ(first.trialInBlock, 4U);
    EXPECT_EQ(first.response, 2U);
    EXPECT_EQ(first.outcome, Outcome::incorrect);
    EXPECT_EQ(first.responseTime_s, 0.1 + 0.2);
    EXPECT_EQ(first.responseTimeOffset_s, -1.75);
    EXPECT_EQ(first.responseDevice, "keyboard");
    EXPECT_EQ(first.responseKey, "3");
    EXPECT_EQ(first.replays, 1U);
    EXPECT_EQ(first.earlyPresses, 2U);
    EXPECT_EQ(first.onset_s, 12.5);
    EXPECT_EQ(first.duration_s, 2.0);
    EXPECT_EQ(first.deviceLatency_ms, 4.25);
    EXPECT_EQ(first.deviceFaults, 1U);
    EXPECT_EQ(first.frameWrite_ms, 0.125);
    EXPECT_EQ(first.framesMissed, 3U);
    EXPECT_EQ(first.planned.track, "t2");
    EXPECT_EQ(first.planned.level, 0.1);
    EXPECT_EQ(first.planned.target, 1U);
    EXPECT_EQ(first.trigger_ms, 0.75);
    EXPECT_EQ(first.latencySpread_ms, 1.5);
    EXPECT_EQ(first.recording, "P07_1.teleta");
    EXPECT_EQ(first.recording_s, 12.625);
    EXPECT_EQ(trials->front().time, kNow);
    const TrialResult& second = trials->back().result;
    EXPECT_FALSE(second.response);
    EXPECT_FALSE(second.responseTime_s);
    EXPECT_FALSE(second.deviceLatency_ms);
    EXPECT_FALSE(second.frameWrite_ms);
    EXPECT_FALSE(second.framesMissed);
    EXPECT_EQ(second.planned.track, "");
    EXPECT_FALSE(second.planned.level);
    EXPECT_FALSE(second.planned.target);
    EXPECT_FALSE(second.trigger_ms);
    EXPECT_FALSE(second.latencySpread_ms);
    EXPECT_EQ(second.recording, "");
    EXPECT_FALSE(second.recording_s);
    EXPECT_EQ(second.outcome, Outcome::timeout);
}

TEST_F(StudyStoreTest, refusesTheSameAttemptOfATrialTwice) {
    StudyStore store = create();
    const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
    const SessionRecord session = store.beginSession(store.enrol("P07").value(), 0, plan, kNow).value();
    ASSERT_TRUE(store.keepTrial(session, answered(), kNow));
    TrialResult other = answered();
    other.response = 0;
    const auto again = store.keepTrial(session, other, kNow);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(store.trials(session)->size(), 1U);
    EXPECT_EQ(store.trials(session)->front().result.response, 2U);
}

TEST_F(StudyStoreTest, takesAnyNameOfAParticipantButEachOnce) {
    StudyStore store = create();
    const std::vector<std::string> names = {"P07",        "O'Neil", "a,b",  "two\nlines",
                                            "\"quoted\"", "参加者", "Иван", "'; DROP TABLE trial; --"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto participant = store.enrol(names[i]);
        ASSERT_TRUE(participant) << names[i];
        EXPECT_EQ(participant->enrolment, i);
    }
    const auto again = store.enrol("参加者");
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().kind, core::ErrorKind::refused);
    EXPECT_FALSE(store.enrol(""));
    EXPECT_FALSE(store.enrol("  "));
    EXPECT_FALSE(store.enrol("NA"));
    EXPECT_FALSE(store.enrol(std::string(65, 'x')));
    // Tables with these would run something in a spreadsheet or a terminal.
    for (const char* harmful : {"=1+2", "@SUM(A1)", "+1", "-1", "a\x1b[31m", "\x7f"})
        EXPECT_FALSE(store.enrol(harmful)) << harmful;
    const auto participants = StudyStore::open(folder())->participants();
    ASSERT_EQ(participants->size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_EQ((*participants)[i].id, names[i]);
}

TEST_F(StudyStoreTest, sessionsOfOneParticipantInTheSameSecondGetNamesOfTheirOwn) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const auto plan = planSessions(store.head().protocol, store.head().seed, 0);
    EXPECT_EQ(store.beginSession(participant, 0, plan[0], kNow)->id, "20261103T142233");
    EXPECT_EQ(store.beginSession(participant, 1, plan[1], kNow)->id, "20261103T142233x2");
    const Participant other = store.enrol("P08").value();
    EXPECT_EQ(store.beginSession(other, 0, plan[0], kNow)->id, "20261103T142233");
}

TEST_F(StudyStoreTest, aSessionThatBeganIsTheSameAgainEvenIfTheClockWasSetBack) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const auto plan = planSessions(store.head().protocol, store.head().seed, 0);
    const SessionRecord first = store.beginSession(participant, 0, plan[0], kNow).value();
    ASSERT_TRUE(store.keepTrial(first, answered(), kNow));
    TrialResult next = answered();
    next.planned.trial = 4;
    next.trialInBlock = 5;
    ASSERT_TRUE(store.keepTrial(first, next, kNow.addDays(-1)));
    const SessionRecord again = store.beginSession(participant, 0, plan[0], kNow.addDays(-1)).value();
    EXPECT_EQ(again.key, first.key);
    EXPECT_EQ(again.id, first.id);
    const auto trials = store.trials(again).value();
    ASSERT_EQ(trials.size(), 2U);
    EXPECT_EQ(trials[1].result.planned.trial, 4U);
}

TEST_F(StudyStoreTest, twoStationsSeeEachOther) {
    StudyStore one = create();
    StudyStore two = StudyStore::open(folder()).value();
    ASSERT_TRUE(one.enrol("P07"));
    EXPECT_FALSE(two.enrol("P07"));
    EXPECT_EQ(two.enrol("P08")->enrolment, 1U);
    const auto plan = planSessions(one.head().protocol, one.head().seed, 0);
    const SessionRecord first = one.beginSession(one.participants()->front(), 0, plan[0], kNow).value();
    const SessionRecord second = two.beginSession(two.participants()->front(), 0, plan[0], kNow).value();
    EXPECT_EQ(first.key, second.key);
    ASSERT_TRUE(one.keepTrial(first, answered(), kNow));
    EXPECT_EQ(two.keepTrial(second, answered(), kNow).error().kind, core::ErrorKind::refused);
}

TEST_F(StudyStoreTest, finishedSessionsStayFinished) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const auto plan = planSessions(store.head().protocol, store.head().seed, 0);
    const SessionRecord session = store.beginSession(participant, 0, plan[0], kNow).value();
    EXPECT_FALSE(session.finished);
    ASSERT_TRUE(store.finishSession(session));
    EXPECT_TRUE(StudyStore::open(folder())->sessions(participant)->front().finished);
}

TEST_F(StudyStoreTest, tellsAFolderWithoutStudyFromADamagedOneAndANewerOne) {
    EXPECT_EQ(StudyStore::open(folder()).error().kind, core::ErrorKind::notFound);
    std::filesystem::create_directory(folder());
    m_folder.write("study/study.sqlite", "this is no database, but it is long enough to look at");
    EXPECT_EQ(StudyStore::open(folder()).error().kind, core::ErrorKind::badInput);
    std::filesystem::remove_all(folder());
    (void)create();
    runSql(QStringLiteral("PRAGMA user_version = 1000"));
    EXPECT_EQ(StudyStore::open(folder()).error().kind, core::ErrorKind::refused);
    runSql(QStringLiteral("PRAGMA user_version = -1"));
    EXPECT_EQ(StudyStore::open(folder()).error().kind, core::ErrorKind::badInput);
}

TEST_F(StudyStoreTest, wordsThatFilesHaveForSomethingElseNameNobody) {
    StudyStore store = create();
    for (const char* word : {"NA", "n/a", "NONE", "GROUP"}) {
        const auto refused = store.enrol(word);
        ASSERT_FALSE(refused) << word;
        EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
        EXPECT_NE(refused.error().expected.find("NA, n/a, NONE, GROUP"), std::string::npos)
            << refused.error().expected;
    }
    EXPECT_EQ(store.enrol(std::string(65, 'a')).error().expected,
              "a text of 1 to 64 characters that does not begin with = + - or @");
}

TEST_F(StudyStoreTest, bringsAnOlderStudyUpToDateAndKeepsItsTrials) {
    {
        StudyStore store = create();
        const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
        const SessionRecord session = store.beginSession(store.enrol("P07").value(), 0, plan, kNow).value();
        ASSERT_TRUE(store.keepTrial(session, answered(), kNow));
        EXPECT_EQ(store.head().stimulusSetSha256.size(), 64U);
    }
    for (const char* table : {"deletion", "stimulus", "note"})
        runSql(QStringLiteral("DROP TABLE %1").arg(QLatin1String(table)));
    runSql(QStringLiteral("ALTER TABLE trial DROP COLUMN frame_write_ms"));
    runSql(QStringLiteral("ALTER TABLE trial DROP COLUMN frames_missed"));
    for (const char* column :
         {"track", "level", "target", "trigger_ms", "recording", "recording_s", "device_latency_spread_ms"})
        runSql(QStringLiteral("ALTER TABLE trial DROP COLUMN %1").arg(QLatin1String(column)));
    runSql(QStringLiteral("ALTER TABLE study DROP COLUMN observer"));
    runSql(QStringLiteral("DROP TABLE answer"));
    runSql(QStringLiteral("ALTER TABLE study DROP COLUMN stimulus_set_sha256"));
    runSql(QStringLiteral("PRAGMA user_version = 1"));
    const auto store = StudyStore::open(folder());
    ASSERT_TRUE(store) << core::describe(store.error());
    EXPECT_EQ(store->head().stimulusSetSha256, "");
    EXPECT_TRUE(store->head().stimuli.missing().empty());
    EXPECT_NE(store->head().stimuli.find("shape.A.static"), nullptr);
    const Participant participant = store->participants()->front();
    const SessionRecord session = store->sessions(participant)->front();
    EXPECT_EQ(store->trials(session)->size(), 1U);
    EXPECT_FALSE(store->trials(session)->front().result.frameWrite_ms);
    EXPECT_FALSE(store->trials(session)->front().result.latencySpread_ms);
}

TEST_F(StudyStoreTest, keepsNotesOfASessionInTheirOrder) {
    StudyStore store = create();
    const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
    const SessionRecord session = store.beginSession(store.enrol("P07").value(), 0, plan, kNow).value();
    ASSERT_TRUE(store.keepNote(session, "coughed; \"again\"", kNow));
    ASSERT_TRUE(store.keepNote(session, "\u96d1\u97f3", kNow.addSecs(-5)));
    const auto notes = StudyStore::open(folder())->notes(session);
    ASSERT_TRUE(notes);
    ASSERT_EQ(notes->size(), 2U);
    EXPECT_EQ(notes->front().text, "coughed; \"again\"");
    EXPECT_EQ(notes->front().time, kNow);
    EXPECT_EQ(notes->back().text, "\u96d1\u97f3");
}

TEST_F(StudyStoreTest, keepsAnswersOfAQuestionnaireTogetherAndOnce) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const auto plan = planSessions(store.head().protocol, store.head().seed, 0);
    const SessionRecord first = store.beginSession(participant, 0, plan[0], kNow).value();
    const SessionRecord second = store.beginSession(participant, 1, plan[1], kNow).value();
    const auto item = [](const char* id, ItemKind kind, bool required) {
        QuestionnaireItem made;
        made.id = id;
        made.kind = kind;
        made.required = required;
        return made;
    };
    const Questionnaire person{"person",
                               "About you",
                               QuestionnaireTime::beforeStudy,
                               {item("name", ItemKind::text, true), item("more", ItemKind::text, false)}};
    const Questionnaire effort{
        "effort", "Effort", QuestionnaireTime::afterSession, {item("hard", ItemKind::likert, true)}};
    ASSERT_TRUE(store.keepAnswers(participant, {}, person, {{"name", "O'Neil, \"参\""}, {"more", {}}}, kNow));
    EXPECT_EQ(store.keepAnswers(participant, {}, person, {{"name", "x"}, {"more", {}}}, kNow).error().kind,
              core::ErrorKind::refused);
    ASSERT_TRUE(store.keepAnswers(participant, first, effort, {{"hard", "7"}}, kNow));
    ASSERT_TRUE(store.keepAnswers(participant, second, effort, {{"hard", "2"}}, kNow));
    EXPECT_FALSE(store.keepAnswers(participant, first, effort, {{"hard", "1"}}, kNow));
    // Perhaps nobody learned that they were stored.
    const QDateTime later = kNow.addSecs(60);
    EXPECT_TRUE(
        store.keepAnswers(participant, {}, person, {{"name", "O'Neil, \"参\""}, {"more", {}}}, later));
    EXPECT_TRUE(store.keepAnswers(participant, second, effort, {{"hard", "2"}}, later));
    EXPECT_FALSE(store.keepAnswers(participant, second, effort, {{"hard", "7"}}, later));
    EXPECT_FALSE(store.keepAnswers(participant, {}, effort, {{"hard", "1"}}, kNow));
    EXPECT_FALSE(store.keepAnswers(store.enrol("P08").value(), {}, person, {{"name", "x"}}, kNow));
    const auto answers = StudyStore::open(folder())->answers(participant).value();
    ASSERT_EQ(answers.size(), 4U);
    EXPECT_EQ(answers[0].value, "O'Neil, \"参\"");
    EXPECT_FALSE(answers[0].session);
    EXPECT_EQ(answers[0].time, kNow);
    EXPECT_FALSE(answers[1].value);
    EXPECT_EQ(answers[2].session, first.key);
    EXPECT_EQ(answers[3].value, "2");
}

TEST_F(StudyStoreTest, aParticipantIsInOneSessionAtATime) {
    StudyStore one = create();
    StudyStore two = StudyStore::open(folder()).value();
    const Participant participant = one.enrol("P07").value();
    EXPECT_FALSE(one.runner(participant).value());
    {
        const auto claim = one.claim(participant);
        ASSERT_TRUE(claim) << core::describe(claim.error());
        EXPECT_EQ(two.claim(participant).error().kind, core::ErrorKind::refused);
        EXPECT_TRUE(two.runner(participant).value());
        EXPECT_TRUE(two.claim(one.enrol("P08").value()));
    }
    EXPECT_FALSE(two.runner(participant).value());
    EXPECT_TRUE(two.claim(participant));
    EXPECT_FALSE(std::filesystem::exists(folder() + "/running-0.lock")) << "nobody holds it";
}

// A waiter must not get the lock of a file that its last holder has just removed.
TEST_F(StudyStoreTest, ofManyWhoTakeAParticipantInTurnNoTwoHaveHimAtOnce) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    std::atomic<int> holders = 0;
    std::atomic<int> taken = 0;
    std::atomic<bool> overlap = false;
    std::vector<std::thread> stations;
    for (int station = 0; station < 4; ++station) {
        stations.emplace_back([&, path = folder() + "/running-0.lock"] {
            for (int turn = 0; turn < 2000; ++turn) {
                const auto claim = FileClaim::take(path, "station");
                if (!claim || *claim == nullptr)
                    continue;
                overlap = overlap || ++holders != 1;
                ++taken;
                --holders;
            }
        });
    }
    for (std::thread& station : stations)
        station.join();
    EXPECT_FALSE(overlap);
    EXPECT_GT(taken, 0);
    EXPECT_TRUE(store.claim(participant));
}

TEST_F(StudyStoreTest, whatKilledProgramsLeftBehindIsGoneWhenTheStudyIsOpened) {
    StudyStore store = create();
    const Participant held = store.enrol("P07").value();
    m_folder.write("study/running-7.lock", "station, process 1");
    const auto claim = store.claim(held);
    ASSERT_TRUE(claim);
    ASSERT_TRUE(StudyStore::open(folder()));
    EXPECT_FALSE(std::filesystem::exists(folder() + "/running-7.lock"));
    EXPECT_TRUE(std::filesystem::exists(folder() + "/running-0.lock"));
    EXPECT_TRUE(store.runner(held).value()) << "who runs a participant goes on";
}

TEST_F(StudyStoreTest, aProgramThatWasKilledDoesNotKeepItsParticipant) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const pid_t child = fork();
    if (child == 0) {
        const auto claim = store.claim(participant);
        kill(getpid(), claim ? SIGKILL : SIGABRT);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(WTERMSIG(status), SIGKILL);
    EXPECT_FALSE(store.runner(participant).value());
    EXPECT_TRUE(store.claim(participant));
}

// A program that was killed right after creating the file has not written its name yet.
TEST_F(StudyStoreTest, anEmptyFileThatWasLeftBehindHoldsNobody) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    m_folder.write("study/running-0.lock", "");
    EXPECT_FALSE(store.runner(participant).value());
    EXPECT_TRUE(store.claim(participant));
}

TEST_F(StudyStoreTest, numbersThatTheProtocolDoesNotHaveAreDamage) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
    const SessionRecord session = store.beginSession(participant, 0, plan, kNow).value();
    ASSERT_TRUE(store.keepTrial(session, answered(), kNow));
    ASSERT_TRUE(store.trials(session));
    for (const char* damage : {"stimulus = 99", "stimulus = -1", "stimulus = 1, response = 99"}) {
        runSql(QStringLiteral("UPDATE trial SET %1").arg(QString::fromLatin1(damage)));
        const auto trials = store.trials(session);
        ASSERT_FALSE(trials) << damage;
        EXPECT_EQ(trials.error().kind, core::ErrorKind::badInput);
        TrialTally tally;
        ModeFilter modes;
        EXPECT_FALSE(tallyStore(store, modes, tally)) << damage;
        EXPECT_FALSE(exportStudy(store, ExportFormat::excel)) << damage;
    }
    runSql(QStringLiteral("UPDATE trial SET response = NULL"));
    EXPECT_TRUE(store.trials(session));
    runSql(QStringLiteral("UPDATE session SET plan_index = 99"));
    const auto sessions = store.sessions(participant);
    ASSERT_FALSE(sessions);
    EXPECT_EQ(sessions.error().kind, core::ErrorKind::badInput);
    EXPECT_NE(sessions.error().where.file, "");
    EXPECT_FALSE(store.trials({session.key, session.id, 99, false}));
}

TEST_F(StudyStoreTest, aFolderThatCannotBeMadeIsAnError) {
    m_folder.write("study", "a file stands in the way");
    EXPECT_EQ(StudyStore::create(folder(), head()).error().kind, core::ErrorKind::ioFailed);
}

// A limit on the file size simulates a full disk: the write-ahead log cannot grow.
TEST_F(StudyStoreTest, aFullDiskLosesNothingThatWasKept) {
    StudyStore store = create();
    const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
    const SessionRecord session = store.beginSession(store.enrol("P07").value(), 0, plan, kNow).value();
    TrialResult result = answered();
    ASSERT_TRUE(store.keepTrial(session, result, kNow));
    result.planned.trial = 9;
    result.trialInBlock = 9;

    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit full = before;
    full.rlim_cur = std::filesystem::file_size(folder() + "/study.sqlite-wal");
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    const auto kept = store.keepTrial(session, result, kNow);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, ignored);

    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().kind, core::ErrorKind::ioFailed) << core::describe(kept.error());
    EXPECT_EQ(store.trials(session)->size(), 1U);
    EXPECT_TRUE(store.keepTrial(session, result, kNow));
    EXPECT_EQ(StudyStore::open(folder())->trials(session)->size(), 2U);
}

TEST_F(StudyStoreTest, numbersDoNotDependOnTheLocale) {
    const test::GeneratedLocale german("de_DE");
    if (!german.exists())
        GTEST_SKIP() << "the sources of locales are not installed (package locales)";
    const std::string before = std::setlocale(LC_ALL, nullptr);
    setenv("LOCPATH", german.path().c_str(), 1);
    ASSERT_NE(std::setlocale(LC_ALL, german.name().c_str()), nullptr);
    EXPECT_EQ(std::localeconv()->decimal_point, std::string(","));
    StudyStore store = create();
    const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
    const SessionRecord session = store.beginSession(store.enrol("P07").value(), 0, plan, kNow).value();
    ASSERT_TRUE(store.keepTrial(session, answered(), kNow));
    EXPECT_EQ(store.trials(session)->front().result.responseTimeOffset_s, -1.75);
    std::setlocale(LC_ALL, before.c_str());
    unsetenv("LOCPATH");
}

} // namespace teleta::study
