// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/report/exports/study_export.h"
#include "tests/backend/core/temporary_folder.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlQuery>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

QCoreApplication& oldApplication() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    static QCoreApplication* application = QCoreApplication::instance() != nullptr
                                               ? QCoreApplication::instance()
                                               : new QCoreApplication(argc, argv);
    return *application;
}

/// What version 0.1.0 left: protocol, store (schema 5) as statements, and its exported trials.
std::string kept(const std::string& file) {
    const std::string path = std::string(TELETA_SOURCE_DIR "/tests/backend/study/old_study/") + file;
    std::ifstream stream(path);
    EXPECT_TRUE(stream) << path;
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

class OldStudy : public testing::Test {
protected:
    OldStudy() {
        (void)oldApplication();
        std::filesystem::create_directories(folder());
        {
            QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", "old");
            database.setDatabaseName(QString::fromStdString(folder() + "/study.sqlite"));
            EXPECT_TRUE(database.open());
            QSqlQuery query(database);
            std::istringstream statements(kept("study.sql"));
            std::string statement;
            // The protocol has line ends, but none after a semicolon.
            std::string line;
            while (std::getline(statements, line)) {
                statement += line + '\n';
                if (!line.ends_with(';'))
                    continue;
                EXPECT_TRUE(query.exec(QString::fromStdString(statement))) << statement;
                statement.clear();
            }
        }
        QSqlDatabase::removeDatabase("old");
    }

    [[nodiscard]] std::string folder() const { return m_folder.path("study"); }

    static void expectItsResults(const TrialTally& tally) {
        const std::vector<TaskResults> results = studyResults(tally);
        ASSERT_EQ(results.size(), 1U);
        EXPECT_EQ(results[0].patterns, (std::vector<std::string>{"A", "B", "C"}));
        const ConfusionMatrix& matrix = results[0].groups.at(0).matrix;
        // Counted by hand.
        const std::vector<std::vector<std::int64_t>> counts{{4, 1, 0, 0}, {0, 3, 1, 1}, {1, 0, 4, 0}};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j)
                EXPECT_EQ(matrix.count(i, j), counts[i][j]) << i << ' ' << j;
        }
        EXPECT_NEAR(results[0].groups.at(0).accuracy->mean, 11.0 / 15.0, 1e-12);
    }

    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(OldStudy, hasTheSameResultsFromItsStore) {
    const auto store = StudyStore::open(folder());
    ASSERT_TRUE(store) << core::describe(store.error());
    EXPECT_EQ(store->head().protocol.tasks[0].design, Design::identification);
    EXPECT_EQ(store->head().observer, "");
    ModeFilter modes;
    TrialTally tally;
    ASSERT_TRUE(tallyStore(*store, modes, tally));
    expectItsResults(tally);
    const auto trials = store->trials(store->sessions(store->participants()->front())->front());
    ASSERT_EQ(trials->size(), 15U);
    for (const StoredTrial& trial : *trials) {
        EXPECT_EQ(trial.result.planned.track, "");
        EXPECT_FALSE(trial.result.planned.level);
        EXPECT_FALSE(trial.result.planned.target);
        EXPECT_FALSE(trial.result.trigger_ms);
        EXPECT_FALSE(trial.result.latencySpread_ms);
    }
}

TEST_F(OldStudy, hasTheSameResultsFromItsTable) {
    const std::string path = m_folder.write("trials.csv", kept("trials.csv"));
    ModeFilter modes;
    TrialTally tally;
    ASSERT_TRUE(tallyCsv(path, modes, tally, [](std::uint64_t) { return true; }));
    expectItsResults(tally);
}

TEST_F(OldStudy, hasTheSameProtocol) {
    const auto read = parseProtocol(kept("protocol.toml"), "protocol.toml");
    ASSERT_TRUE(read) << core::describe(read.error());
    EXPECT_EQ(protocolText(*read), protocolText(*parseProtocol(protocolText(*read), "again.toml")));
    const std::vector<PlannedSession> plan = planSessions(*read, 1, 0);
    ASSERT_EQ(plan.size(), 1U);
    EXPECT_EQ(plan[0].test,
              trialOrder(OrderMethod::fullRandom, 3, 5, derivedSeed(plan[0].seed, kSeedOfTest)));
    EXPECT_EQ(plan[0].testTrials, 15U);
}

// Only the number of the schema differs, and there are more columns at the end.
TEST_F(OldStudy, isExportedAsBeforeWithMoreColumns) {
    const auto store = StudyStore::open(folder());
    ASSERT_TRUE(store);
    ASSERT_TRUE(exportStudy(*store, ExportFormat::psychds));
    std::istringstream now(test::readAll(
        folder() + "/data/subject-P01/subject-P01_session-20260301T080000_task-shape_data.csv"));
    std::istringstream before(kept("trials.csv"));
    const std::string seed = std::to_string(planSessions(store->head().protocol, 1, 0)[0].seed);
    std::string newLine;
    std::string oldLine;
    std::size_t lines = 0;
    while (std::getline(before, oldLine)) {
        ASSERT_TRUE(std::getline(now, newLine));
        if (const auto at = oldLine.find("SEED"); at != std::string::npos)
            oldLine.replace(at, 4, seed);
        if (lines++ == 0) {
            oldLine += ",design,track,level,level_unit,reference,procedure,excluded,trigger_ms,recording,"
                       "recording_s,device_latency_spread_ms";
        } else {
            oldLine[0] = '3';
            oldLine += ",identification,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA";
        }
        EXPECT_EQ(newLine, oldLine);
    }
    EXPECT_EQ(lines, 16U);
    EXPECT_FALSE(std::getline(now, newLine));
}

} // namespace teleta::study
