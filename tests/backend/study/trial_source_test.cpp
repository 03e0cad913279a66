// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"
#include "backend/study/analysis/trials/trial_source.h"
#include "backend/study/report/exports/study_export.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/small_protocol.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

namespace teleta::study {

namespace {

const std::string kHead = "participant_id,task,condition,phase,stimulus,response";

class TrialSourceTest : public testing::Test {
protected:
    core::Expected<void> read(const std::string& text, std::optional<Mode> wanted = {}) {
        m_tally = {};
        m_modes = {wanted, {}};
        return tallyCsv(m_folder.write("t.csv", text), m_modes, m_tally, [](std::uint64_t) { return true; });
    }

    void expectWrong(const std::string& text, long long line, long long column) {
        const auto done = read(text);
        ASSERT_FALSE(done) << text;
        EXPECT_EQ(done.error().kind, core::ErrorKind::badInput);
        EXPECT_EQ(done.error().where.line, line) << core::describe(done.error());
        EXPECT_EQ(done.error().where.column, column) << core::describe(done.error());
        EXPECT_NE(done.error().expected, "");
    }

    [[nodiscard]] std::int64_t trials() const {
        std::int64_t sum = 0;
        for (const auto& [key, cell] : m_tally.cells()) {
            for (const auto& [answer, count] : cell.counts)
                sum += count;
        }
        return sum;
    }

    test::TemporaryFolder m_folder;
    TrialTally m_tally;
    ModeFilter m_modes;
};

} // namespace

TEST_F(TrialSourceTest, readsHandMadeFilesWithTheNeededColumnsInAnyOrder) {
    ASSERT_TRUE(read("response,stimulus,phase,condition,task,participant_id\nA,A,test,static,shape,P1\n"
                     "B,A,test,static,shape,P1\nNA,A,test,static,shape,P1\n"));
    ASSERT_EQ(m_tally.cells().size(), 1U);
    const auto& [key, cell] = *m_tally.cells().begin();
    EXPECT_EQ(key.participant, "P1");
    EXPECT_EQ(key.task, "shape");
    EXPECT_EQ(cell.counts.size(), 3U);
    EXPECT_EQ(cell.counts[2].first.second, TrialTally::kNone);
}

TEST_F(TrialSourceTest, readsNamesWithQuotesCommasLineBreaksAndOtherLetters) {
    ASSERT_TRUE(read(kHead +
                     "\n\"a,b\",t,c,test,A,A\n\"two\nlines\",t,c,test,A,A\n\"\"\"q\"\"\",t,c,test,A,A\n"
                     "参加者,t,c,test,A,A\n"));
    std::vector<std::string> names;
    for (const auto& [key, cell] : m_tally.cells())
        names.push_back(key.participant);
    EXPECT_EQ(names, (std::vector<std::string>{"\"q\"", "a,b", "two\nlines", "参加者"}));
}

TEST_F(TrialSourceTest, countsCompletedTrialsOnlyAndKeepsTimesOfCorrectTestTrials) {
    ASSERT_TRUE(read(kHead +
                     ",outcome,response_time_s\n"
                     "P,t,c,test,A,A,correct,1.5\nP,t,c,test,A,B,incorrect,2.5\nP,t,c,test,A,NA,timeout,NA\n"
                     "P,t,c,test,A,NA,device_error,NA\nP,t,c,test,A,NA,aborted,NA\n"
                     "P,t,c,practice,A,A,correct,9\n"));
    EXPECT_EQ(trials(), 4);
    for (const auto& [key, cell] : m_tally.cells())
        EXPECT_EQ(cell.correctTimes_s,
                  key.phase == Phase::test ? std::vector<double>{1.5} : std::vector<double>{});
}

TEST_F(TrialSourceTest, namesTheSeparatorOfAFileThatIsNotCommaSeparated) {
    const auto excel = read("participant_id;task;condition;phase;stimulus;response\nP;t;c;test;A;A\n");
    ASSERT_FALSE(excel);
    EXPECT_EQ(excel.error().kind, core::ErrorKind::badInput);
    EXPECT_NE(excel.error().message.find("semicolons"), std::string::npos) << core::describe(excel.error());
    EXPECT_NE(excel.error().expected.find("commas"), std::string::npos);
    const auto bids = read("participant_id\ttask\tcondition\tphase\tstimulus\tresponse\n");
    ASSERT_FALSE(bids);
    EXPECT_NE(bids.error().message.find("tabs"), std::string::npos) << core::describe(bids.error());
}

TEST_F(TrialSourceTest, refusesNamesInAnotherEncoding) {
    expectWrong(kHead + "\nP,t,c,test,A,A\n\xDCnal,t,c,test,A,A\n", 3, 1);
}

TEST_F(TrialSourceTest, knowsAnswersInOtherCaseAndFilesThatOnlyPractise) {
    ASSERT_TRUE(read(kHead + "\nP,t,c,practice,A,a\nP,t,c,practice,B,B\nP,t,c,practice,b2,B\n"));
    EXPECT_EQ(m_tally.answersInOtherCase(), (std::set<std::pair<std::string, std::string>>{{"a", "A"}}));
    EXPECT_FALSE(m_tally.hasTestTrials());
    // Letters of another case may be patterns of their own.
    ASSERT_TRUE(read(kHead + "\nP,t,c,test,A,a\nP,t,c,test,a,A\n"));
    EXPECT_TRUE(m_tally.answersInOtherCase().empty());
    EXPECT_TRUE(m_tally.hasTestTrials());
}

TEST_F(TrialSourceTest, damagedRowsAreErrorsWithLineAndColumn) {
    expectWrong(kHead + "\nP,t,c,test,A,A\nP,t,c,final,A,A\n", 3, 7);
    expectWrong(kHead + "\n,t,c,test,A,A\n", 2, 1);
    expectWrong(kHead + "\nP,t,c,test,NA,A\n", 2, 12);
    expectWrong(kHead + "\nP,t,c,test,A\n", 2, 13);
    expectWrong(kHead + ",outcome\nP,t,c,test,A,A,right\n", 2, 16);
    expectWrong(kHead + ",outcome\nP,t,c,test,A,B,correct\n", 2, 16);
    expectWrong(kHead + ",response_time_s\nP,t,c,test,A,A,1,5\n", 2, 18);
    expectWrong(kHead + ",response_time_s\nP,t,c,test,A,A,fast\n", 2, 16);
    expectWrong("participant_id,task,condition,phase,stimulus\nP,t,c,test,A\n", 1, 1);
}

TEST_F(TrialSourceTest, keepsHowManyPatternsTheTrialsSayThatATaskHas) {
    const std::string head = kHead + ",n_alternatives\n";
    ASSERT_TRUE(read(head + "P,t,c,test,A,A,5\nP,t,c,test,A,A,6\nP,t,c,test,A,A,NA\nP,u,c,test,A,A,NA\n"));
    ASSERT_NE(m_tally.alternatives("t"), nullptr);
    EXPECT_EQ(m_tally.alternatives("t")->count, 6U);
    EXPECT_EQ(m_tally.alternatives("u"), nullptr);
    ASSERT_TRUE(read(kHead + "\nP,t,c,test,A,A\n"));
    EXPECT_EQ(m_tally.alternatives("t"), nullptr);
    for (const char* wrong : {"six", "0", "-6", "1001", "6.0"})
        expectWrong(head + "P,t,c,test,A,A," + wrong + "\n", 2, 16);
}

TEST_F(TrialSourceTest, aStudyHasThePatternsOfItsProtocolAlsoThoseThatNobodyFelt) {
    StudyHead head;
    head.protocol = smallProtocol();
    head.mode = Mode::pilot;
    head.created = QDateTime(QDate(2026, 11, 3), QTime(9, 0), Qt::UTC);
    StudyStore store = std::move(StudyStore::create(m_folder.path("study"), head).value());
    const Participant participant = store.enrol("P01").value();
    const PlannedSession plan = planSessions(head.protocol, head.seed, 0).front();
    const SessionRecord session = store.beginSession(participant, 0, plan, head.created).value();
    TrialResult result;
    result.planned = {Phase::test, 1, 1, 1, 1};
    result.outcome = Outcome::aborted;
    const auto kept = store.keepTrial(session, result, head.created);
    ASSERT_TRUE(kept) << describe(kept.error());
    ASSERT_TRUE(tallyStore(store, m_modes, m_tally));
    EXPECT_TRUE(studyResults(m_tally).empty()) << "nothing was completed";
    result.planned.attempt = result.trialInBlock = 2;
    result.outcome = Outcome::correct;
    result.response = 1;
    const auto again = store.keepTrial(session, result, head.created);
    ASSERT_TRUE(again) << describe(again.error());
    m_tally = {};
    m_modes = {};
    ASSERT_TRUE(tallyStore(store, m_modes, m_tally));
    const std::vector<TaskResults> results = studyResults(m_tally);
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(results[0].patterns, (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_EQ(results[0].alternatives(), 3U);
}

TEST_F(TrialSourceTest, doesNotMergeModesUnlessOneIsChosen) {
    const std::string mixed = kHead + ",mode\nP,t,c,test,A,A,run\nP,t,c,test,A,A,pilot\nP,t,c,test,A,B,run\n";
    const auto merged = read(mixed);
    ASSERT_FALSE(merged);
    EXPECT_EQ(merged.error().kind, core::ErrorKind::refused);
    EXPECT_EQ(merged.error().where.line, 3);
    ASSERT_TRUE(read(mixed, Mode::run));
    EXPECT_EQ(trials(), 2);
    ASSERT_TRUE(read(mixed, Mode::simulated));
    EXPECT_EQ(trials(), 0);
}

TEST_F(TrialSourceTest, stopsWhenAsked) {
    const std::string path = m_folder.write("t.csv", kHead + "\nP,t,c,test,A,A\n");
    const auto done = tallyCsv(path, m_modes, m_tally, [](std::uint64_t) { return false; });
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, core::ErrorKind::cancelled);
}

TEST_F(TrialSourceTest, refusesATableOfMoreNamesThanPatternsCanHave) {
    std::string text = kHead + "\n";
    for (int i = 0; i <= 1000; ++i)
        text += "P,t,c,test,A,answer" + std::to_string(i) + "\n";
    const auto done = read(text);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(done.error().where.line, 1001);
}

TEST_F(TrialSourceTest, refusesATrialThatIsThereTwice) {
    const std::string head = kHead + ",session_id,trial,attempt\n";
    const std::string row = "P1,shape,static,test,A,A,20261103T142233,";
    // The same number in another phase, session or attempt, or of another participant, is another trial.
    const std::string others = "P1,shape,static,practice,A,A,20261103T142233,1,1\n"
                               "P1,shape,static,test,A,A,20261103T142234,1,1\n"
                               "P2,shape,static,test,A,A,20261103T142233,1,1\n";
    ASSERT_TRUE(read(head + row + "1,1\n" + row + "2,1\n" + row + "1,2\n" + others));
    EXPECT_EQ(trials(), 6);
    for (const char* again : {"1,1", "2,1", "1,2"}) {
        const auto done = read(head + row + "1,1\n" + row + "2,1\n" + row + "1,2\n" + others + row + again);
        ASSERT_FALSE(done) << again;
        EXPECT_EQ(done.error().kind, core::ErrorKind::refused);
        EXPECT_EQ(done.error().where.line, 8);
        EXPECT_EQ(done.error().where.column, 42);
        EXPECT_NE(done.error().message.find("20261103T142233"), std::string::npos) << done.error().message;
    }
    // Other programs write rows without trial numbers.
    EXPECT_TRUE(read(head + row + "NA,NA\n" + row + "NA,NA\n"));
    EXPECT_TRUE(read(kHead + "\nP1,shape,static,test,A,A\nP1,shape,static,test,A,A\n"));
    expectWrong(head + row + "one,1\n", 2, 42);
    expectWrong(head + row + "1,0\n", 2, 44);
    expectWrong(head + row + "18446744073709551616,1\n", 2, 42);
    // Numbers above those kept as bits.
    ASSERT_TRUE(read(head + row + "18446744073709551615,1\n"));
    EXPECT_FALSE(read(head + row + "18446744073709551615,1\n" + row + "18446744073709551615,1\n"));
}

TEST_F(TrialSourceTest, aFileThatIsReadAgainUnderAnotherNameIsRefused) {
    const std::string text = kHead + ",session_id,trial,attempt\nP1,shape,static,test,A,A,s,1,1\n";
    ASSERT_TRUE(read(text));
    const std::string copy = m_folder.write("copy.csv", text);
    const auto done = tallyCsv(copy, m_modes, m_tally, [](std::uint64_t) { return true; });
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().where.file, copy);
    EXPECT_EQ(done.error().where.line, 2);
}

TEST_F(TrialSourceTest, peopleOfOneNameInTwoStudiesAreNotOne) {
    const auto study = [&](const std::string& name, const std::string& person) {
        StudyHead head;
        head.protocol = smallProtocol();
        head.mode = Mode::pilot;
        head.created = QDateTime(QDate(2026, 11, 3), QTime(9, 0), Qt::UTC);
        StudyStore store = std::move(StudyStore::create(m_folder.path(name), head).value());
        const Participant participant = store.enrol(person).value();
        const PlannedSession plan = planSessions(head.protocol, head.seed, 0).front();
        const SessionRecord session = store.beginSession(participant, 0, plan, head.created).value();
        TrialResult result;
        result.planned = {Phase::test, 1, 1, 1, plan.test.front()};
        result.outcome = Outcome::timeout;
        EXPECT_TRUE(store.keepTrial(session, result, head.created));
        EXPECT_TRUE(exportSession(store, participant, session));
        return store;
    };
    const StudyStore one = study("one", "P01");
    const StudyStore other = study("other", "P01");
    const StudyStore third = study("third", "P02");
    ASSERT_TRUE(tallyStore(one, m_modes, m_tally));
    ASSERT_TRUE(tallyStore(third, m_modes, m_tally));
    EXPECT_EQ(trials(), 2);
    const auto merged = tallyStore(other, m_modes, m_tally);
    ASSERT_FALSE(merged);
    EXPECT_EQ(merged.error().kind, core::ErrorKind::refused);
    const std::string text = core::describe(merged.error());
    EXPECT_NE(text.find("P01"), std::string::npos) << text;
    EXPECT_NE(text.find(one.shownName()), std::string::npos) << text;
    EXPECT_NE(text.find(other.shownName()), std::string::npos) << text;

    // A study and its export, in both orders.
    std::string exported;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.path("third")))
        if (entry.path().string().ends_with("_data.csv"))
            exported = entry.path().string();
    const auto goOn = [](std::uint64_t) { return true; };
    const auto twice = tallyCsv(exported, m_modes, m_tally, goOn);
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().where.file, exported);
    EXPECT_EQ(twice.error().where.line, 2);
    EXPECT_NE(twice.error().message.find(third.shownName()), std::string::npos) << twice.error().message;
    m_tally = {};
    ASSERT_TRUE(tallyCsv(exported, m_modes, m_tally, goOn));
    const auto after = tallyStore(third, m_modes, m_tally);
    ASSERT_FALSE(after);
    EXPECT_NE(after.error().message.find(exported), std::string::npos) << after.error().message;
}

} // namespace teleta::study
