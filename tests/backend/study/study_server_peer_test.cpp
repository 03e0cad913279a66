// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/rehearsal.h"
#include "backend/study/store/study_store.h"
#include "backend/study/store/trial_journal.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"
#include "tests/support/breakable_line.h"
#include "tests/support/postgres_server.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlQuery>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <sys/types.h>
#include <thread>
#include <tuple>

namespace teleta::study {

namespace {

using test::PostgresServer;
using test::TemporaryFolder;

/// Qt finds its database drivers through the application.
const struct Application {
    int argc = 1;
    std::array<char, 5> name{"test"};
    std::array<char*, 2> argv{name.data(), nullptr};
    QCoreApplication application{argc, argv.data()};
} kApplication;

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33, 250), Qt::UTC);

using Row = std::tuple<std::string, std::string, Phase, std::size_t, std::size_t, std::size_t,
                       std::optional<std::size_t>, Outcome, std::optional<double>, qint64>;

std::vector<Row> rowsOf(const StudyStore& store) {
    std::vector<Row> rows;
    const auto participants = store.participants().value();
    for (const Participant& participant : participants) {
        const auto sessions = store.sessions(participant).value();
        for (const SessionRecord& session : sessions) {
            const auto trials = store.trials(session).value();
            for (const StoredTrial& trial : trials) {
                const TrialResult& r = trial.result;
                rows.emplace_back(participant.id, session.id, r.planned.phase, r.planned.trial,
                                  r.planned.attempt, r.planned.stimulus, r.response, r.outcome,
                                  r.responseTime_s, trial.time.toMSecsSinceEpoch());
            }
        }
    }
    return rows;
}

TrialResult trialNumber(std::size_t number) {
    TrialResult result;
    result.planned = {Phase::test, number, 2, 1, 1};
    result.trialInBlock = number;
    result.response = 2;
    result.outcome = Outcome::incorrect;
    result.responseTime_s = 0.1 + 0.2;
    result.responseTimeOffset_s = -1.75;
    result.responseDevice = "keyboard";
    result.responseKey = "3";
    result.earlyPresses = 2;
    result.onset_s = 12.1;
    result.duration_s = 2.0;
    result.deviceLatency_ms = 1.0 / 3.0;
    return result;
}

/// One server for all tests; each has a study of its own.
/// While one exists, warnings of Qt are counted instead of written.
class Warnings {
public:
    Warnings()
        : m_before(qInstallMessageHandler(&Warnings::take)) {
        s_count = 0;
    }
    ~Warnings() { qInstallMessageHandler(m_before); }
    Warnings(const Warnings&) = delete;
    Warnings& operator=(const Warnings&) = delete;
    [[nodiscard]] static int count() { return s_count; }

private:
    static void take(QtMsgType /*type*/, const QMessageLogContext& /*context*/, const QString& text) {
        ++s_count;
        std::fprintf(stderr, "Qt: %s\n", qPrintable(text));
    }
    static inline std::atomic<int> s_count = 0;
    QtMessageHandler m_before;
};

class StudyServerTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (!PostgresServer::programs().empty())
            s_server = std::make_unique<PostgresServer>();
    }
    static void TearDownTestSuite() { s_server.reset(); }

    void SetUp() override {
        if (s_server == nullptr)
            GTEST_SKIP() << "PostgreSQL is not installed, so there is no server to talk to";
        m_study = "study_" + std::to_string(s_studies++);
    }

    static StudyHead head(Mode mode = Mode::pilot) {
        StudyHead head;
        head.protocol = smallProtocol();
        head.seed = 18'000'000'000'000'000'001U;
        head.mode = mode;
        head.plannedParticipants = 3;
        head.created = kNow;
        head.appVersion = "0.1.0";
        return head;
    }

    [[nodiscard]] StoreLocation at(const std::string& folder = "here") const {
        return {m_folder.path(folder), s_server->url(m_study)};
    }

    StudyStore create() {
        auto store = StudyStore::create(at(), head());
        if (!store)
            throw std::runtime_error(core::describe(store.error()));
        return std::move(*store);
    }

    static SessionRecord begin(StudyStore& store, const Participant& participant) {
        const auto plan = planSessions(store.head().protocol, store.head().seed, participant.enrolment);
        return store.beginSession(participant, 0, plan[0], kNow).value();
    }

    [[nodiscard]] StoreLocation through(const test::BreakableLine& line) const {
        return {m_folder.path("here"), PostgresServer::urlAt(line.port(), m_study)};
    }

    /// The process of the server that has a participant's lock; the tests have one at a time.
    static pid_t holder() {
        pid_t pid = 0;
        {
            QSqlDatabase beside =
                QSqlDatabase::addDatabase(QStringLiteral("QPSQL"), QStringLiteral("beside"));
            beside.setHostName(QStringLiteral("127.0.0.1"));
            beside.setPort(s_server->port());
            beside.setDatabaseName(QStringLiteral("postgres"));
            beside.setUserName(QStringLiteral("console"));
            beside.setPassword(QString::fromLatin1(PostgresServer::kPassword));
            if (!beside.open())
                throw std::runtime_error("cannot look at the locks");
            QSqlQuery query(QStringLiteral("SELECT pid FROM pg_locks WHERE locktype = 'advisory'"), beside);
            if (query.next())
                pid = static_cast<pid_t>(query.value(0).toInt());
        }
        QSqlDatabase::removeDatabase(QStringLiteral("beside"));
        return pid;
    }

    [[nodiscard]] bool hasPending() const { return !TrialJournal::sessionsIn(m_folder.path("here")).empty(); }

    static inline std::unique_ptr<PostgresServer> s_server;
    static inline int s_studies = 0;
    TemporaryFolder m_folder;
    std::string m_study;
};

} // namespace

TEST_F(StudyServerTest, givesAStudyBackAsItWas) {
    SessionRecord session;
    {
        StudyStore store = create();
        session = begin(store, store.enrol("O'Neil, \"参加者\"").value());
        ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow));
        ASSERT_TRUE(store.finishSession(session));
    }
    const auto store = StudyStore::open(at("elsewhere"));
    ASSERT_TRUE(store) << core::describe(store.error());
    EXPECT_EQ(store->head().seed, 18'000'000'000'000'000'001U);
    EXPECT_EQ(store->head().mode, Mode::pilot);
    EXPECT_EQ(store->head().created, kNow);
    EXPECT_EQ(store->head().protocol.source, smallProtocol().source);
    EXPECT_EQ(store->head().stimulusSetSha256.size(), 64U);
    const Participant participant = store->participants()->front();
    EXPECT_EQ(participant.id, "O'Neil, \"参加者\"");
    EXPECT_TRUE(store->sessions(participant)->front().finished);
    const auto trials = store->trials(session).value();
    ASSERT_EQ(trials.size(), 1U);
    EXPECT_EQ(trials[0].result.responseTime_s, 0.1 + 0.2);
    EXPECT_EQ(trials[0].result.deviceLatency_ms, 1.0 / 3.0);
    EXPECT_EQ(trials[0].result.onset_s, 12.1);
    EXPECT_EQ(trials[0].result.response, 2U);
    EXPECT_EQ(trials[0].time, kNow);
}

TEST_F(StudyServerTest, refusesWhatIsThereAlready) {
    StudyStore store = create();
    EXPECT_EQ(StudyStore::create(at(), head()).error().kind, core::ErrorKind::refused);
    const Participant participant = store.enrol("P07").value();
    EXPECT_EQ(store.enrol("P07").error().kind, core::ErrorKind::refused);
    const SessionRecord session = begin(store, participant);
    ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow));
    TrialResult other = trialNumber(1);
    other.response = 0;
    EXPECT_EQ(store.keepTrial(session, other, kNow).error().kind, core::ErrorKind::refused);
    EXPECT_EQ(store.trials(session)->front().result.response, 2U);
    const StoreLocation missing{m_folder.path("here"), s_server->url("nobody_made_this")};
    EXPECT_EQ(StudyStore::open(missing).error().kind, core::ErrorKind::notFound);
}

TEST_F(StudyServerTest, bringsAnOlderStudyUpToDateAndKeepsItsTrials) {
    SessionRecord session;
    {
        StudyStore store = create();
        session = begin(store, store.enrol("P07").value());
        ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow));
    }
    // As schema 2 left it.
    s_server->sql(
        "DROP TABLE " + m_study + ".answer, " + m_study + ".note, " + m_study + ".stimulus, " + m_study +
        ".deletion; ALTER TABLE " + m_study +
        ".trial DROP COLUMN frame_write_ms, DROP COLUMN frames_missed, DROP COLUMN track, DROP COLUMN "
        "level, DROP COLUMN target, DROP COLUMN trigger_ms, DROP COLUMN recording, DROP COLUMN "
        "recording_s, DROP COLUMN device_latency_spread_ms; ALTER TABLE " +
        m_study + ".study DROP COLUMN observer; DELETE FROM " + m_study +
        ".schema_version WHERE version > 2");
    const auto store = StudyStore::open(at());
    ASSERT_TRUE(store) << core::describe(store.error());
    EXPECT_EQ(store->trials(session)->size(), 1U);
    EXPECT_TRUE(store->answers(store->participants()->front())->empty());
    s_server->sql("INSERT INTO " + m_study + ".schema_version VALUES (1000)");
    EXPECT_EQ(StudyStore::open(at()).error().kind, core::ErrorKind::refused);
}

TEST_F(StudyServerTest, keepsAnswersOfAQuestionnaireTogetherAndOnce) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const SessionRecord session = begin(store, participant);
    Questionnaire effort{"effort", "Effort", QuestionnaireTime::afterSession, {}};
    effort.items.resize(2);
    effort.items[0].id = "hard";
    effort.items[1].id = "more";
    effort.items[1].required = false;
    ASSERT_TRUE(store.keepAnswers(participant, session, effort, {{"hard", "very"}, {"more", {}}}, kNow));
    EXPECT_EQ(
        store.keepAnswers(participant, session, effort, {{"hard", "no"}, {"more", {}}}, kNow).error().kind,
        core::ErrorKind::refused);
    const auto answers = StudyStore::open(at())->answers(participant).value();
    ASSERT_EQ(answers.size(), 2U);
    EXPECT_EQ(answers[0].value, "very");
    EXPECT_EQ(answers[0].session, session.key);
    EXPECT_FALSE(answers[1].value);
}

TEST_F(StudyServerTest, ofStationsThatCreateItAtOnceOneDoesAndQtWritesNothing) {
    const Warnings warnings;
    constexpr int kStations = 6;
    std::atomic<int> created = 0;
    std::atomic<int> refused = 0;
    {
        std::vector<std::jthread> stations;
        for (int i = 0; i < kStations; ++i)
            stations.emplace_back([&, i] {
                const auto store = StudyStore::create(at("station" + std::to_string(i)), head());
                created += store ? 1 : 0;
                refused += !store && store.error().kind == core::ErrorKind::refused ? 1 : 0;
            });
    }
    EXPECT_EQ(created, 1);
    EXPECT_EQ(refused, kStations - 1);
    EXPECT_EQ(warnings.count(), 0);
}

TEST_F(StudyServerTest, stationsThatEnrolAtOnceGetNumbersOfTheirOwn) {
    (void)create();
    constexpr int kStations = 3;
    constexpr int kEach = 15;
    std::array<std::set<std::size_t>, kStations> numbers;
    {
        std::vector<std::jthread> stations;
        for (int i = 0; i < kStations; ++i)
            stations.emplace_back([&, i] {
                auto store = StudyStore::open(at("station" + std::to_string(i)));
                for (int j = 0; store && j < kEach; ++j) {
                    const auto participant = store->enrol(std::to_string(i) + "-" + std::to_string(j));
                    if (participant)
                        numbers[static_cast<std::size_t>(i)].insert(participant->enrolment);
                }
            });
    }
    std::set<std::size_t> all;
    for (const auto& of : numbers) {
        EXPECT_EQ(of.size(), static_cast<std::size_t>(kEach));
        all.insert(of.begin(), of.end());
    }
    EXPECT_EQ(all.size(), static_cast<std::size_t>(kStations * kEach));
    EXPECT_EQ(*all.rbegin(), static_cast<std::size_t>(kStations * kEach) - 1);
}

TEST_F(StudyServerTest, aParticipantIsAtOneStationAtATime) {
    StudyStore one = create();
    StudyStore two = StudyStore::open(at("there")).value();
    const Participant participant = one.enrol("P07").value();
    {
        const auto claim = one.claim(participant);
        ASSERT_TRUE(claim) << core::describe(claim.error());
        EXPECT_EQ(two.claim(participant).error().kind, core::ErrorKind::refused);
        EXPECT_EQ(one.claim(participant).error().kind, core::ErrorKind::refused);
        EXPECT_TRUE(two.runner(participant).value());
    }
    EXPECT_FALSE(two.runner(participant).value());
    auto claim = std::make_unique<core::Expected<ParticipantClaim>>(two.claim(participant));
    ASSERT_TRUE(*claim);
    {
        // A station that disconnects releases its participants.
        const StudyStore gone = std::move(two);
    }
    EXPECT_TRUE(one.claim(participant));
}

TEST_F(StudyServerTest, aServerThatIsKilledInASessionLosesAndRepeatsNothing) {
    StudyStore store = create();
    const SessionRecord session = begin(store, store.enrol("P07").value());
    ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow));
    s_server->kill();
    for (int attempt = 0; attempt < 2; ++attempt) {
        const auto kept = store.keepTrial(session, trialNumber(2), kNow.addSecs(9));
        ASSERT_FALSE(kept);
        EXPECT_EQ(kept.error().kind, core::ErrorKind::unavailable) << core::describe(kept.error());
        EXPECT_NE(kept.error().message.find("pending-"), std::string::npos) << kept.error().message;
        EXPECT_EQ(core::describe(kept.error()).find("cret"), std::string::npos) << "the password is shown";
        EXPECT_EQ(TrialJournal(m_folder.path("here"), session.key).read()->size(), 1U);
    }
    EXPECT_EQ(store.trials(session).error().kind, core::ErrorKind::unavailable);
    s_server->start();
    const auto again = store.keepTrial(session, trialNumber(2), kNow.addSecs(60));
    ASSERT_TRUE(again) << "whatever the clock says at the second try: " << core::describe(again.error());
    EXPECT_FALSE(hasPending());
    ASSERT_TRUE(store.keepTrial(session, trialNumber(3), kNow.addSecs(70)));
    const auto trials = store.trials(session).value();
    ASSERT_EQ(trials.size(), 3U);
    EXPECT_EQ(trials[1].result.planned.trial, 2U);
    EXPECT_EQ(trials[1].time, kNow.addSecs(9));
}

TEST_F(StudyServerTest, aTrialThatWaitedWhenTheProgramEndedIsSentWithTheNextStart) {
    SessionRecord session;
    {
        StudyStore store = create();
        session = begin(store, store.enrol("P07").value());
        s_server->kill();
        EXPECT_FALSE(store.keepTrial(session, trialNumber(1), kNow));
    }
    EXPECT_EQ(StudyStore::open(at()).error().kind, core::ErrorKind::unavailable);
    EXPECT_TRUE(hasPending());
    s_server->start();
    for (int start = 0; start < 2; ++start) {
        const auto store = StudyStore::open(at());
        ASSERT_TRUE(store) << core::describe(store.error());
        EXPECT_FALSE(hasPending());
        ASSERT_EQ(store->trials(session)->size(), 1U);
        EXPECT_EQ(store->trials(session)->front().result.deviceLatency_ms, 1.0 / 3.0);
    }
}

TEST_F(StudyServerTest, whoOnlyReadsLeavesAWaitingTrialToTheOneWhoRunsTheStudy) {
    StudyStore store = create();
    const SessionRecord session = begin(store, store.enrol("P07").value());
    ASSERT_TRUE(TrialJournal(m_folder.path("here"), session.key)
                    .append({session.key, session.id, trialNumber(1), kNow}));
    const auto reader = StudyStore::openForReading(at());
    ASSERT_TRUE(reader) << core::describe(reader.error());
    EXPECT_TRUE(reader->trials(session)->empty());
    EXPECT_TRUE(hasPending());
    ASSERT_TRUE(store.keepTrial(session, trialNumber(2), kNow.addSecs(9)));
    EXPECT_FALSE(hasPending());
    EXPECT_EQ(reader->trials(session)->size(), 2U);
}

// The server stored the trial but could not confirm it.
TEST_F(StudyServerTest, aWaitingTrialThatTheServerHasIsNotKeptTwice) {
    StudyStore store = create();
    const SessionRecord session = begin(store, store.enrol("P07").value());
    ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow));
    const TrialJournal journal(m_folder.path("here"), session.key);
    ASSERT_TRUE(journal.append({session.key, session.id, trialNumber(1), kNow}));
    ASSERT_TRUE(StudyStore::open(at()));
    EXPECT_FALSE(hasPending());
    EXPECT_EQ(store.trials(session)->size(), 1U);
    TrialResult other = trialNumber(1);
    other.response = 0;
    ASSERT_TRUE(journal.append({session.key, session.id, other, kNow}));
    EXPECT_EQ(StudyStore::open(at()).error().kind, core::ErrorKind::refused);
    EXPECT_TRUE(hasPending()) << "what differs is kept for a person to look at";
    ASSERT_TRUE(journal.remove());
    other = trialNumber(1);
    other.onset_s += 1.0;
    ASSERT_TRUE(journal.append({session.key, session.id, other, kNow}));
    EXPECT_EQ(StudyStore::open(at()).error().kind, core::ErrorKind::refused) << "it began at another time";
    ASSERT_TRUE(journal.remove());
    ASSERT_TRUE(journal.append({session.key, "another study", trialNumber(2), kNow}));
    EXPECT_EQ(StudyStore::open(at()).error().kind, core::ErrorKind::badInput);
}

TEST_F(StudyServerTest, connectsAgainByItselfAndKeepsItsParticipant) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const auto claim = store.claim(participant);
    ASSERT_TRUE(claim);
    const SessionRecord session = begin(store, participant);
    s_server->kill();
    s_server->start();
    const auto kept = store.keepTrial(session, trialNumber(1), kNow);
    ASSERT_TRUE(kept) << core::describe(kept.error());
    StudyStore other = StudyStore::open(at("there")).value();
    EXPECT_EQ(other.claim(participant).error().kind, core::ErrorKind::refused);
}

TEST_F(StudyServerTest, keepsNothingOfAParticipantThatAnotherStationTookWhileTheServerWasAway) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    auto claim = std::make_unique<core::Expected<ParticipantClaim>>(store.claim(participant));
    ASSERT_TRUE(*claim);
    const SessionRecord session = begin(store, participant);
    s_server->kill();
    s_server->start();
    {
        StudyStore other = StudyStore::open(at("there")).value();
        const auto theirs = other.claim(participant);
        ASSERT_TRUE(theirs) << core::describe(theirs.error());
        for (int attempt = 0; attempt < 2; ++attempt)
            EXPECT_EQ(store.keepTrial(session, trialNumber(1), kNow).error().kind, core::ErrorKind::refused);
        EXPECT_TRUE(other.trials(session)->empty());
    }
    ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow)) << "the other station has left";
    claim.reset();
    EXPECT_FALSE(store.runner(participant).value());
}

TEST_F(StudyServerTest, aStationWhoseNetworkWentAwayKeepsItsParticipant) {
    test::BreakableLine line(s_server->port());
    StudyStore store = StudyStore::create(through(line), head()).value();
    const Participant participant = store.enrol("P07").value();
    const auto claim = store.claim(participant);
    ASSERT_TRUE(claim) << core::describe(claim.error());
    const SessionRecord session = begin(store, participant);
    ASSERT_TRUE(store.keepTrial(session, trialNumber(1), kNow));
    StudyStore other = StudyStore::open(at("there")).value();
    // Twice: the new connection breaks too.
    for (std::size_t number = 2; number < 4; ++number) {
        const pid_t before = holder();
        line.cut();
        EXPECT_TRUE(other.runner(participant).value()) << "the server has not noticed";
        const auto kept = store.keepTrial(session, trialNumber(number), kNow.addSecs(9));
        ASSERT_TRUE(kept) << core::describe(kept.error());
        EXPECT_FALSE(hasPending());
        EXPECT_NE(holder(), before) << "the connection that broke has gone";
        EXPECT_EQ(other.claim(participant).error().kind, core::ErrorKind::refused);
    }
    EXPECT_EQ(other.trials(session)->size(), 3U);
}

TEST_F(StudyServerTest, aTrialIsSafeWhileTheServerCannotEndTheConnectionThatBroke) {
    test::BreakableLine line(s_server->port());
    StudyStore store = StudyStore::create(through(line), head()).value();
    const Participant participant = store.enrol("P07").value();
    const auto claim = store.claim(participant);
    ASSERT_TRUE(claim) << core::describe(claim.error());
    const SessionRecord session = begin(store, participant);
    const pid_t stuck = holder();
    ASSERT_GT(stuck, 0);
    line.cut();
    ::kill(stuck, SIGSTOP);
    const auto kept = store.keepTrial(session, trialNumber(1), kNow);
    ::kill(stuck, SIGCONT);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().kind, core::ErrorKind::unavailable) << core::describe(kept.error());
    EXPECT_TRUE(hasPending());
    const auto again = store.keepTrial(session, trialNumber(1), kNow);
    ASSERT_TRUE(again) << core::describe(again.error());
    EXPECT_FALSE(hasPending());
    EXPECT_EQ(store.trials(session)->size(), 1U);
}

TEST_F(StudyServerTest, aConnectionThatCameBackIncompletelyIsMadeOnceMore) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    s_server->kill();
    s_server->start();
    s_server->sql("ALTER SCHEMA " + m_study + " RENAME TO hidden_" + m_study);
    for (int attempt = 0; attempt < 2; ++attempt)
        EXPECT_EQ(store.participants().error().kind, core::ErrorKind::notFound);
    s_server->sql("ALTER SCHEMA hidden_" + m_study + " RENAME TO " + m_study);
    const auto participants = store.participants();
    ASSERT_TRUE(participants) << core::describe(participants.error());
    EXPECT_EQ(participants->size(), 1U);
}

TEST_F(StudyServerTest, aFolderIsThatOfOneStudy) {
    (void)create();
    const std::string folder = m_folder.path("here");
    StudyHead later = head();
    later.created = kNow.addSecs(1);
    const StoreLocation second{folder, s_server->url(m_study + "_second")};
    EXPECT_EQ(StudyStore::create(second, later).error().kind, core::ErrorKind::refused);
    const StoreLocation apart{m_folder.path("there"), second.server};
    ASSERT_TRUE(StudyStore::create(apart, later));
    const auto mixed = StudyStore::open(second);
    ASSERT_FALSE(mixed);
    EXPECT_EQ(mixed.error().kind, core::ErrorKind::refused);
    EXPECT_NE(mixed.error().message.find("study=" + m_study), std::string::npos) << mixed.error().message;
    EXPECT_EQ(core::describe(mixed.error()).find("cret"), std::string::npos) << "the password is shown";
    EXPECT_TRUE(StudyStore::open(at())) << "its own stays open to it";
    ASSERT_TRUE(StudyStore::create(m_folder.path("local"), head()));
    EXPECT_EQ(StudyStore::open(at("local")).error().kind, core::ErrorKind::refused);
}

TEST_F(StudyServerTest, noFolderIsMadeForAStudyThatIsNotThere) {
    for (const char* name : {"nobody_made_this", "../../x"}) {
        EXPECT_FALSE(StudyStore::open({m_folder.path("new"), s_server->url(name)}));
        EXPECT_FALSE(std::filesystem::exists(m_folder.path("new"))) << name;
    }
    EXPECT_FALSE(StudyStore::create({m_folder.path("new"), s_server->url("../../x")}, head()));
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("new")));
}

TEST_F(StudyServerTest, aParticipantOfAnotherDatabaseDoesNotCount) {
    StudyStore store = create();
    const Participant participant = store.enrol("P07").value();
    const std::string database = "other_" + m_study;
    s_server->sql("CREATE DATABASE " + database);
    std::string url = at().server;
    url.replace(url.find("/postgres?"), 10, '/' + database + '?');
    StudyStore other = StudyStore::create({m_folder.path("there"), url}, head()).value();
    const Participant namesake = other.enrol("P07").value();
    ASSERT_EQ(namesake.key, participant.key);
    const auto claim = store.claim(participant);
    ASSERT_TRUE(claim);
    EXPECT_FALSE(other.runner(namesake).value());
    EXPECT_TRUE(other.claim(namesake));
}

TEST_F(StudyServerTest, aRehearsalThatTheServerLeftGoesOnAndIsTheSameAsInAFile) {
    StudyStore local = StudyStore::create(m_folder.path("local"), head(Mode::simulated)).value();
    ASSERT_TRUE(rehearse(local));
    StudyStore remote = StudyStore::create(at(), head(Mode::simulated)).value();
    const auto broken = rehearse(remote, {.goOn = [](const RehearsalProgress& now) {
                                     if (now.allTrials() == 13)
                                         s_server->kill();
                                     return true;
                                 }});
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().kind, core::ErrorKind::unavailable);
    s_server->start();
    StudyStore again = StudyStore::open(at()).value();
    const auto progress = rehearse(again);
    ASSERT_TRUE(progress) << core::describe(progress.error());
    EXPECT_GE(progress->trialsBefore, 13U);
    EXPECT_EQ(rowsOf(again), rowsOf(local));
}

TEST_F(StudyServerTest, errorsNeverShowAPassword) {
    const std::string wrong = s_server->url(m_study, "wr0ng-pass");
    const auto refused = StudyStore::open({m_folder.path("here"), wrong});
    ASSERT_FALSE(refused);
    EXPECT_EQ(core::describe(refused.error()).find("wr0ng"), std::string::npos)
        << core::describe(refused.error());
    for (const char* url :
         {"mysql://console:wr0ng-pass@host/db", "postgresql://console:wr0ng-pass@host/db?pet=cat",
          "postgresql://console:wr0ng-pass@host/db?study=No%20name",
          "postgresql://console:wr0ng-pass@host/db?port=abc",
          "postgresql://console:wr0ng-pass@host/db?port=70000"}) {
        const auto bad = StudyStore::open({m_folder.path("here"), url});
        ASSERT_FALSE(bad) << url;
        EXPECT_EQ(bad.error().kind, core::ErrorKind::badInput) << core::describe(bad.error());
        EXPECT_EQ(core::describe(bad.error()).find("wr0ng"), std::string::npos);
    }
    const auto semicolon =
        StudyStore::open({m_folder.path("here"), "postgresql://console:wr0ng-pass@host/db?sslcert=/a;b"});
    ASSERT_FALSE(semicolon);
    EXPECT_NE(semicolon.error().message.find("\"sslcert\" of the address has a semicolon"), std::string::npos)
        << semicolon.error().message;
    EXPECT_EQ(shownServer("postgresql://me:wr0ng@host/db?study=a&password=wr0ng"),
              "postgresql://me@host/db?study=a");
}

} // namespace teleta::study
