// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/report/exports/study_export.h"
#include "backend/study/store/study_store.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <QSqlDatabase>
#include <QSqlQuery>

#include <gtest/gtest.h>

#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace teleta::study {

namespace {

namespace fs = std::filesystem;

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);

/// A study with one answered trial in a read-only folder, and an unprivileged user.
class ReadOnlyStudyTest : public testing::Test {
protected:
    static constexpr uid_t kNobody = 65'534;

    [[nodiscard]] std::string folder() const { return m_folder.path("study"); }

    static StudyHead head() {
        StudyHead head;
        head.protocol = smallProtocol();
        head.mode = Mode::pilot;
        head.created = kNow;
        return head;
    }

    static TrialResult answered(const PlannedSession& plan, std::size_t trial) {
        TrialResult result;
        result.planned = {Phase::test, trial, 1, 1, plan.test[trial - 1]};
        result.trialInBlock = trial;
        result.outcome = Outcome::timeout;
        return result;
    }

    /// Leaves the study open: the caller closes it, or is killed.
    StudyStore make() const {
        StudyStore store = std::move(StudyStore::create(folder(), head()).value());
        const PlannedSession plan = planSessions(store.head().protocol, store.head().seed, 0)[0];
        const SessionRecord session = store.beginSession(store.enrol("P07").value(), 0, plan, kNow).value();
        EXPECT_TRUE(store.keepTrial(session, answered(plan, 1), kNow));
        return store;
    }

    void makeAndKill() const {
        const pid_t child = fork();
        if (child == 0) {
            const StudyStore store = make();
            kill(getpid(), SIGKILL);
        }
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
        ASSERT_TRUE(fs::exists(folder() + "/study.sqlite-wal"));
    }

    void protect() {
        fs::permissions(m_folder.path("."), fs::perms(0755));
        for (const auto& file : fs::directory_iterator(folder()))
            fs::permissions(file.path(), fs::perms(0444));
        fs::permissions(folder(), fs::perms(0555));
        if (geteuid() == 0) {
            ASSERT_EQ(seteuid(kNobody), 0);
        }
    }
    void free() const {
        ASSERT_EQ(seteuid(m_user), 0);
        fs::permissions(folder(), fs::perms(0755));
        for (const auto& file : fs::directory_iterator(folder()))
            fs::permissions(file.path(), fs::perms(0644));
    }
    void TearDown() override {
        (void)seteuid(m_user);
        if (fs::exists(folder()))
            fs::permissions(folder(), fs::perms(0755));
    }

    [[nodiscard]] static std::int64_t trialsIn(const std::string& folder) {
        const auto store = StudyStore::openForReading(folder);
        EXPECT_TRUE(store) << core::describe(store.error());
        ModeFilter modes;
        TrialTally tally;
        if (!store || !tallyStore(*store, modes, tally))
            return -1;
        std::int64_t sum = 0;
        for (const auto& [key, cell] : tally.cells())
            for (const auto& [answer, count] : cell.counts)
                sum += count;
        return sum;
    }
    [[nodiscard]] static std::size_t filesIn(const std::string& folder) {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    const uid_t m_user = geteuid();
    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(ReadOnlyStudyTest, isOneFileWhenTheLastOneHasClosedIt) {
    {
        const StudyStore store = make();
        const auto other = StudyStore::open(folder());
        ASSERT_TRUE(other);
    }
    EXPECT_EQ(filesIn(folder()), 1U);
}

TEST_F(ReadOnlyStudyTest, isReadAndNothingIsLeftBeside) {
    make();
    protect();
    EXPECT_EQ(trialsIn(folder()), 1);
    {
        const auto store = StudyStore::openForReading(folder());
        ASSERT_TRUE(store);
        EXPECT_TRUE(store->isReadOnly());
    }
    free();
    EXPECT_EQ(filesIn(folder()), 1U);
    EXPECT_FALSE(StudyStore::open(folder())->isReadOnly());
}

TEST_F(ReadOnlyStudyTest, isReadWithTheEmptyLogThatAnEarlierProgramLeft) {
    make();
    const QString name = "earlier";
    {
        QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", name);
        database.setDatabaseName(QString::fromStdString(folder() + "/study.sqlite"));
        ASSERT_TRUE(database.open());
        ASSERT_TRUE(QSqlQuery(database).exec("PRAGMA journal_mode = WAL"));
    }
    QSqlDatabase::removeDatabase(name);
    protect();
    EXPECT_EQ(trialsIn(folder()), 1);
    free();
    EXPECT_EQ(trialsIn(folder()), 1);
}

TEST_F(ReadOnlyStudyTest, takesNoTrialAndKeepsWhatIsThere) {
    make();
    fs::create_directory(m_folder.path("bare"));
    fs::permissions(m_folder.path("bare"), fs::perms(0555));
    protect();
    const auto created = StudyStore::create(m_folder.path("other"), head());
    // The folder exists, but no file can be created in it.
    const auto createdInIt = StudyStore::create(m_folder.path("bare"), head());
    const auto opened = StudyStore::open(folder());
    core::Expected<Participant> enrolled = core::Unexpected(core::Error{});
    core::Expected<void> kept;
    {
        auto store = StudyStore::openForReading(folder());
        ASSERT_TRUE(store) << core::describe(store.error());
        const Participant participant = store->participants()->front();
        const SessionRecord session = store->sessions(participant)->front();
        const PlannedSession plan = planSessions(store->head().protocol, store->head().seed, 0)[0];
        enrolled = store->enrol("P08");
        kept = store->keepTrial(session, answered(plan, 2), kNow);
    }
    free();
    ASSERT_FALSE(created);
    EXPECT_EQ(created.error().kind, core::ErrorKind::ioFailed);
    ASSERT_FALSE(createdInIt);
    EXPECT_EQ(createdInIt.error().kind, core::ErrorKind::ioFailed);
    EXPECT_TRUE(fs::is_empty(m_folder.path("bare")));
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, core::ErrorKind::ioFailed);
    EXPECT_NE(opened.error().message.find("read-only"), std::string::npos) << opened.error().message;
    ASSERT_FALSE(enrolled);
    EXPECT_EQ(enrolled.error().kind, core::ErrorKind::ioFailed);
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().kind, core::ErrorKind::ioFailed);
    EXPECT_EQ(trialsIn(folder()), 1);
}

TEST_F(ReadOnlyStudyTest, saysWhyOrReadsAllWhenItWasKilled) {
    makeAndKill();
    protect();
    {
        // SQLite may or may not be able to read the log here; a study without its last trials must not be
        // opened.
        const auto store = StudyStore::openForReading(folder());
        if (store) {
            EXPECT_EQ(trialsIn(folder()), 1);
        } else {
            EXPECT_EQ(store.error().kind, core::ErrorKind::ioFailed);
            EXPECT_NE(store.error().message.find("study.sqlite-wal"), std::string::npos);
            EXPECT_NE(store.error().expected.find("copy"), std::string::npos);
        }
    }
    free();
    EXPECT_EQ(trialsIn(folder()), 1);
}

TEST_F(ReadOnlyStudyTest, saysWhyWhenOnlyTheLogOfAKilledProgramIsLeftWithIt) {
    makeAndKill();
    fs::remove(folder() + "/study.sqlite-shm");
    protect();
    const auto store = StudyStore::openForReading(folder());
    free();
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().kind, core::ErrorKind::ioFailed);
    EXPECT_NE(store.error().message.find("study.sqlite-wal"), std::string::npos) << store.error().message;
    EXPECT_EQ(trialsIn(folder()), 1);
}

TEST_F(ReadOnlyStudyTest, ofAnOlderProgramIsRefusedThereAndBroughtUpToDateElsewhere) {
    make();
    const auto setSchema = [&] {
        {
            QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", "older");
            database.setDatabaseName(QString::fromStdString(folder() + "/study.sqlite"));
            ASSERT_TRUE(database.open());
            // Schema 3 had no notes, no frame statistics, and no custom patterns.
            QSqlQuery query(database);
            for (const char* step :
                 {"DROP TABLE deletion", "DROP TABLE stimulus", "DROP TABLE note",
                  "ALTER TABLE trial DROP COLUMN frame_write_ms",
                  "ALTER TABLE trial DROP COLUMN frames_missed", "ALTER TABLE trial DROP COLUMN track",
                  "ALTER TABLE trial DROP COLUMN level", "ALTER TABLE trial DROP COLUMN target",
                  "ALTER TABLE trial DROP COLUMN trigger_ms", "ALTER TABLE trial DROP COLUMN recording",
                  "ALTER TABLE trial DROP COLUMN recording_s",
                  "ALTER TABLE trial DROP COLUMN device_latency_spread_ms",
                  "ALTER TABLE study DROP COLUMN observer", "PRAGMA user_version = 3"})
                ASSERT_TRUE(query.exec(step)) << step;
        }
        QSqlDatabase::removeDatabase("older");
    };
    setSchema();
    protect();
    const auto store = StudyStore::openForReading(folder());
    free();
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().kind, core::ErrorKind::refused);
    EXPECT_NE(store.error().message.find("older program"), std::string::npos) << store.error().message;
    EXPECT_EQ(trialsIn(folder()), 1);
}

} // namespace teleta::study
