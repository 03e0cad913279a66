// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/trial_journal.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>

namespace teleta::study {

namespace {

PendingTrial pending(std::size_t number) {
    PendingTrial trial;
    trial.sessionKey = 7;
    trial.sessionId = "20261103T142233";
    trial.result.planned = {Phase::test, number, 2, 1, 1};
    trial.result.response = 2;
    trial.result.outcome = Outcome::incorrect;
    trial.result.responseTime_s = 0.1 + 0.2;
    trial.time = QDateTime(QDate(2026, 11, 3), QTime(14, 22, 33, 250), Qt::UTC);
    return trial;
}

} // namespace

// A limit on the file size simulates a full disk.
TEST(TrialJournal, aLineThatDidNotFitOnTheDiskSpoilsNoOther) {
    const test::TemporaryFolder folder;
    const TrialJournal journal(folder.path(""), 7);
    ASSERT_TRUE(journal.append(pending(1)));
    const auto size_B = std::filesystem::file_size(journal.path());

    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit full = before;
    full.rlim_cur = size_B + 20;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    const auto kept = journal.append(pending(2));
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, ignored);

    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().kind, core::ErrorKind::ioFailed);
    EXPECT_EQ(std::filesystem::file_size(journal.path()), size_B);
    ASSERT_TRUE(journal.append(pending(3)));
    const auto trials = journal.read();
    ASSERT_TRUE(trials) << core::describe(trials.error());
    ASSERT_EQ(trials->size(), 2U);
    EXPECT_EQ(trials->back().result.planned.trial, 3U);
    EXPECT_EQ(trials->back().result.responseTime_s, 0.1 + 0.2);
}

TEST(TrialJournal, readsLinesOfProgramsThatKnewNoLevels) {
    const test::TemporaryFolder folder;
    const TrialJournal journal(folder.path(""), 7);
    std::ofstream(journal.path())
        << R"({"session_key":7,"session_id":"20261103T142233","phase":"test","trial":1,"repetition":2,)"
           R"("attempt":1,"stimulus":1,"trial_in_block":1,"response":2,"outcome":"incorrect",)"
           R"("response_time_s":0.25,"response_time_offset_s":null,"response_device":"","response_key":"",)"
           R"("n_replays":0,"early_presses":0,"onset_s":0.0,"duration_s":0.0,"device_latency_ms":null,)"
           R"("device_faults":0,"frame_write_ms":null,"frames_missed":null,)"
           R"("time_utc":"2026-11-03T14:22:33.250Z"})"
        << '\n';
    const auto trials = journal.read();
    ASSERT_TRUE(trials) << core::describe(trials.error());
    ASSERT_EQ(trials->size(), 1U);
    EXPECT_EQ(trials->front().result.response, 2U);
    EXPECT_FALSE(trials->front().result.planned.level);
    EXPECT_EQ(trials->front().result.planned.track, "");
}

TEST(TrialJournal, leavesOutALastLineThatACrashCutOffAndReportsAnyOtherDamage) {
    const test::TemporaryFolder folder;
    const TrialJournal journal(folder.path(""), 7);
    ASSERT_TRUE(journal.append(pending(1)));
    std::ofstream(journal.path(), std::ios::app) << "{\"session_key\": 7, \"sess";
    ASSERT_EQ(journal.read()->size(), 1U);
    std::ofstream(journal.path(), std::ios::app) << "\n";
    const auto damaged = journal.read();
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(damaged.error().where.line, 2);
}

} // namespace teleta::study
