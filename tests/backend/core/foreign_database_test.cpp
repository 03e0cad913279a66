// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/sqlite/foreign_database.h"
#include "tests/backend/core/temporary_folder.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QStringList>

#include <gtest/gtest.h>

#include <array>

using namespace teleta::core;
using teleta::test::TemporaryFolder;

namespace {

/// Qt finds its database drivers through the application.
const struct Application {
    int argc = 1;
    std::array<char, 5> name{"test"};
    std::array<char*, 2> argv{name.data(), nullptr};
    QCoreApplication application{argc, argv.data()};
} kApplication;

/// A connection of its own to the file of the test.
class Connection {
public:
    explicit Connection(const std::string& path) {
        m_database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("foreign"));
        m_database.setDatabaseName(QString::fromStdString(path));
        EXPECT_TRUE(m_database.open());
    }
    ~Connection() {
        m_database = {};
        QSqlDatabase::removeDatabase(QStringLiteral("foreign"));
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    bool run(const QString& statement) { return QSqlQuery(m_database).exec(statement); }
    Expected<void> distrust() { return distrustSchema(m_database, "f.sqlite"); }

private:
    QSqlDatabase m_database;
};

const QStringList kPlain{
    QStringLiteral("CREATE TABLE t (key INTEGER PRIMARY KEY AUTOINCREMENT, text TEXT UNIQUE)"),
    QStringLiteral("CREATE TABLE w (a INTEGER, b INTEGER, PRIMARY KEY (a, b)) WITHOUT ROWID"),
    QStringLiteral("CREATE INDEX i ON t (text) WHERE text <> ''"),
    QStringLiteral("INSERT INTO t (text) VALUES ('a')")};

} // namespace

TEST(ForeignDatabase, withPlainTablesAndIndicesIsUsable) {
    const TemporaryFolder folder;
    Connection connection(folder.path("f.sqlite"));
    EXPECT_TRUE(connection.distrust()) << "an empty one, too";
    for (const QString& statement : kPlain)
        ASSERT_TRUE(connection.run(statement)) << statement.toStdString();
    EXPECT_TRUE(connection.distrust());
    EXPECT_TRUE(connection.run(QStringLiteral("ALTER TABLE t ADD COLUMN more TEXT")));
    EXPECT_TRUE(connection.run(QStringLiteral("PRAGMA journal_mode = WAL")));
    EXPECT_TRUE(connection.run(QStringLiteral("PRAGMA user_version = 3")));
}

TEST(ForeignDatabase, withAnythingThatRunsIsRefusedAndNamed) {
    for (const auto& [made, named] : std::initializer_list<std::pair<const char*, const char*>>{
             {"CREATE VIEW v AS SELECT 1", "view, \"v\""},
             {"CREATE TRIGGER r AFTER INSERT ON t BEGIN SELECT 1; END", "trigger, \"r\""},
             {"CREATE VIRTUAL TABLE f USING fts5(x)", "table, \"f\""}}) {
        const TemporaryFolder folder;
        Connection connection(folder.path("f.sqlite"));
        for (const QString& statement : kPlain)
            ASSERT_TRUE(connection.run(statement));
        ASSERT_TRUE(connection.run(QString::fromLatin1(made))) << made;
        const auto refused = connection.distrust();
        ASSERT_FALSE(refused) << made;
        EXPECT_EQ(refused.error().kind, ErrorKind::badInput);
        EXPECT_EQ(refused.error().where.file, "f.sqlite");
        EXPECT_NE(refused.error().message.find(named), std::string::npos) << refused.error().message;
    }
}

TEST(ForeignDatabase, doesNotRunWhatIsAddedAfterTheLook) {
    const TemporaryFolder folder;
    Connection connection(folder.path("f.sqlite"));
    for (const QString& statement : kPlain)
        ASSERT_TRUE(connection.run(statement));
    ASSERT_TRUE(connection.distrust());
    ASSERT_TRUE(connection.run(QStringLiteral("CREATE VIEW v AS SELECT text FROM t")));
    EXPECT_FALSE(connection.run(QStringLiteral("SELECT * FROM v")));
    ASSERT_TRUE(connection.run(
        QStringLiteral("CREATE TRIGGER r BEFORE INSERT ON t BEGIN SELECT RAISE(ABORT, 'ran'); END")));
    EXPECT_TRUE(connection.run(QStringLiteral("INSERT INTO t (text) VALUES ('b')")));
    // Defensive: the schema cannot be written around SQLite.
    EXPECT_TRUE(connection.run(QStringLiteral("PRAGMA writable_schema = ON")));
    EXPECT_FALSE(connection.run(QStringLiteral("UPDATE sqlite_master SET sql = '' WHERE name = 'v'")));
}
