// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/trial_source.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <map>

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

} // namespace teleta::study
