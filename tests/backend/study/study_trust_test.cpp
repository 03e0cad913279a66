// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/study_export.h"
#include "backend/study/store/study_store.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <QSqlDatabase>
#include <QSqlQuery>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <sys/stat.h>

namespace teleta::study {

namespace {

const QDateTime kNow(QDate(2026, 11, 3), QTime(14, 22, 33), Qt::UTC);

/// Permissions of what is there, whatever the umask of the person who runs the tests.
class OpenUmask {
public:
    ~OpenUmask() { ::umask(m_before); }

private:
    mode_t m_before = ::umask(0);
};

std::filesystem::perms permissionsOf(const std::string& path) {
    return std::filesystem::status(path).permissions();
}

class StudyTrustTest : public testing::Test {
protected:
    static StudyHead head() {
        StudyHead head;
        head.protocol = smallProtocol();
        head.seed = 5;
        head.created = kNow;
        head.appVersion = "0.1.0";
        return head;
    }

    StudyStore create() { return StudyStore::create(folder(), head()).value(); }

    static TrialResult answered() {
        TrialResult result;
        result.planned = {Phase::test, 1, 1, 1, 0};
        result.response = 1;
        result.outcome = Outcome::incorrect;
        result.responseDevice = "keyboard";
        result.responseKey = "3";
        return result;
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

    test::TemporaryFolder m_folder;
};

TEST_F(StudyTrustTest, isForItsOwnerAloneWhateverTheUmask) {
    const OpenUmask open;
    {
        StudyStore store = create();
        const Participant participant = *store.enrol("P1");
        const auto plan = planSessions(store.head().protocol, store.head().seed, 0).front();
        const SessionRecord session = *store.beginSession(participant, 0, plan, kNow);
        ASSERT_TRUE(store.keepTrial(session, answered(), kNow));
        ASSERT_TRUE(store.keepNote(session, "a note", kNow));
        for (const ExportFormat format : {ExportFormat::psychds, ExportFormat::bids, ExportFormat::excel})
            ASSERT_TRUE(exportStudy(store, format));
        ASSERT_TRUE(std::filesystem::exists(folder() + "/study.sqlite-wal"));
        const auto claim = store.claim(participant);
        ASSERT_TRUE(claim);
        using std::filesystem::perms;
        EXPECT_EQ(permissionsOf(folder()), perms::owner_all);
        int files = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder())) {
            const std::string path = entry.path().string();
            if (path.ends_with(".lock"))
                continue; // says who runs whom, and nothing else
            EXPECT_EQ(permissionsOf(path),
                      entry.is_directory() ? perms::owner_all : perms::owner_read | perms::owner_write)
                << path;
            files += entry.is_directory() ? 0 : 1;
        }
        EXPECT_GT(files, 10);
    }
    EXPECT_EQ(permissionsOf(folder() + "/study.sqlite"),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(StudyTrustTest, aFolderThatWasThereKeepsItsPermissions) {
    std::filesystem::create_directory(folder());
    std::filesystem::permissions(folder(), std::filesystem::perms(0750));
    (void)create();
    EXPECT_EQ(permissionsOf(folder()), std::filesystem::perms(0750));
}

TEST_F(StudyTrustTest, refusesASchemaThatRunsCode) {
    { const StudyStore store = create(); }
    // A reader of this view would never come back.
    for (const char* made :
         {"CREATE VIEW answer AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS "
          "key FROM n",
          "CREATE TRIGGER busy BEFORE INSERT ON participant BEGIN DELETE FROM study; END"}) {
        const bool isView = std::string_view(made).starts_with("CREATE VIEW");
        if (isView)
            runSql(QStringLiteral("ALTER TABLE answer RENAME TO answer_before"));
        runSql(QString::fromLatin1(made));
        for (const auto open : {&StudyStore::open, &StudyStore::openForReading}) {
            const auto store = open(folder());
            ASSERT_FALSE(store) << made;
            EXPECT_EQ(store.error().kind, core::ErrorKind::badInput) << core::describe(store.error());
            EXPECT_NE(store.error().message.find(isView ? "view, \"answer\"" : "trigger, \"busy\""),
                      std::string::npos)
                << store.error().message;
        }
        runSql(isView ? QStringLiteral("DROP VIEW answer") : QStringLiteral("DROP TRIGGER busy"));
        if (isView)
            runSql(QStringLiteral("ALTER TABLE answer_before RENAME TO answer"));
    }
    EXPECT_TRUE(StudyStore::open(folder()));
}

TEST_F(StudyTrustTest, isNoPipe) {
    std::filesystem::create_directory(folder());
    ASSERT_EQ(::mkfifo((folder() + "/study.sqlite").c_str(), 0600), 0);
    for (const auto open : {&StudyStore::open, &StudyStore::openForReading})
        EXPECT_EQ(open(folder()).error().kind, core::ErrorKind::badInput);
}

} // namespace

} // namespace teleta::study
