// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/study_results.h"
#include "backend/study/session/simulated_participant.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace teleta::study {

namespace {

const std::vector<std::string> kDataSetA = {"552555443555", "242141533232", "443221542142", "443351554443",
                                            "432242542352", "442423543552", "554534554545", "543332453544"};

void addCell(TrialTally& tally, const std::string& participant, const std::string& condition, char pattern,
             int correct, int trials = 5) {
    const std::string stimulus(1, pattern);
    const std::string other(1, pattern == 'A' ? 'B' : 'A');
    for (int trial = 0; trial < trials; ++trial)
        EXPECT_TRUE(tally.add({participant, "shape", condition, Phase::test, stimulus,
                               trial < correct ? stimulus : other, 1.0 + trial}));
}

/// Data set A as trials: of each five, the given number is correct, the others are wrong.
TrialTally dataSetA() {
    TrialTally tally;
    for (std::size_t i = 0; i < kDataSetA.size(); ++i) {
        for (std::size_t j = 0; j < 12; ++j)
            addCell(tally, std::string(1, static_cast<char>('1' + static_cast<char>(i))),
                    j < 6 ? "static" : "dynamic", static_cast<char>('A' + static_cast<char>(j % 6)),
                    kDataSetA[i][j] - '0');
    }
    return tally;
}

const AnovaLine* lineOf(const TaskResults& task, const std::string& effect,
                        const std::string& stimulus = "") {
    const auto found = std::find_if(task.anova.begin(), task.anova.end(), [&](const AnovaLine& line) {
        return line.effect == effect && line.stimulus == stimulus;
    });
    return found == task.anova.end() ? nullptr : &*found;
}

} // namespace

// F: R 4.2.2 for data set A.
TEST(StudyResults, anovaOfTrialsIsThatOfTheirCounts) {
    const auto results = studyResults(dataSetA());
    ASSERT_EQ(results.size(), 1U);
    const AnovaLine* condition = lineOf(results[0], "condition");
    const AnovaLine* pattern = lineOf(results[0], "pattern");
    const AnovaLine* both = lineOf(results[0], "condition:pattern");
    ASSERT_TRUE(condition && pattern && both && condition->row && pattern->row && both->row);
    EXPECT_NEAR(condition->row->f, 18.77777778, 0.6e-8);
    EXPECT_NEAR(pattern->row->f, 7.85446, 0.6e-5);
    EXPECT_NEAR(both->row->f, 0.40039, 0.6e-5);
    EXPECT_EQ(condition->participants, 8U);
    EXPECT_TRUE(condition->dropped.empty());
}

// Pattern C, static 2,2,3,3,2,2,4,3 against dynamic 3,3,2,4,2,3,4,3: differences 1,1,-1,1,0,1,0,0, sum 3,
// squares 5: t^2 = 8 (3/8)^2 / ((5 - 9/8)/7) = 63/31.
TEST(StudyResults, comparesConditionsWithinEachPattern) {
    const auto results = studyResults(dataSetA());
    const AnovaLine* line = lineOf(results[0], "condition", "C");
    ASSERT_TRUE(line && line->row);
    EXPECT_NEAR(line->row->f, 63.0 / 31.0, 1e-10);
    EXPECT_EQ(line->row->df2, 7.0);
}

TEST(StudyResults, namesWhoWasDroppedForAMissingCell) {
    TrialTally tally = dataSetA();
    addCell(tally, "half", "static", 'A', 3);
    const auto results = studyResults(tally);
    const AnovaLine* line = lineOf(results[0], "condition");
    ASSERT_TRUE(line && line->row);
    EXPECT_EQ(line->dropped, std::vector<std::string>{"half"});
    EXPECT_EQ(line->participants, 8U);
    EXPECT_NEAR(line->row->f, 18.77777778, 0.6e-8);
}

TEST(StudyResults, namesWhoWasDroppedAlsoWhereTooFewAreLeft) {
    TrialTally tally;
    for (const char pattern : {'A', 'B'}) {
        for (const char* condition : {"dynamic", "static"})
            addCell(tally, "whole", condition, pattern, 3);
        addCell(tally, "half", "static", pattern, 2);
    }
    const auto results = studyResults(tally);
    for (const AnovaLine* line : {lineOf(results[0], "condition"), lineOf(results[0], "condition:pattern"),
                                  lineOf(results[0], "condition", "A")}) {
        ASSERT_TRUE(line);
        EXPECT_FALSE(line->row);
        EXPECT_EQ(line->note, "fewer than two complete participants");
        EXPECT_EQ(line->participants, 1U);
        EXPECT_EQ(line->dropped, std::vector<std::string>{"half"});
    }
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeResults(results, folder.path("out")));
    EXPECT_NE(
        test::readAll(folder.path("out/anova.csv")).find(",1,half,fewer than two complete participants\n"),
        std::string::npos);
}

TEST(StudyResults, saysWhyOneParticipantAndPerfectOnesHaveNoAnova) {
    TrialTally one;
    TrialTally perfect;
    for (const char* condition : {"dynamic", "static"}) {
        for (const char pattern : {'A', 'B'}) {
            addCell(one, "P1", condition, pattern, 3);
            addCell(perfect, "P1", condition, pattern, 5);
            addCell(perfect, "P2", condition, pattern, 5);
        }
    }
    const auto single = studyResults(one);
    const auto all = studyResults(perfect);
    for (const AnovaLine& line : single[0].anova) {
        EXPECT_FALSE(line.row);
        EXPECT_EQ(line.note, "fewer than two complete participants");
    }
    for (const AnovaLine& line : all[0].anova) {
        EXPECT_FALSE(line.row);
        EXPECT_EQ(line.note, "no variance");
    }
    EXPECT_FALSE(single[0].groups[0].accuracy->interval);
    EXPECT_EQ(all[0].groups[0].accuracy->mean, 1.0);
}

TEST(StudyResults, aSingleConditionHasAnAnovaOfPatternsOnly) {
    TrialTally tally;
    for (int i = 0; i < 4; ++i) {
        addCell(tally, std::string(1, static_cast<char>('a' + i)), "static", 'A', 1 + i % 2);
        addCell(tally, std::string(1, static_cast<char>('a' + i)), "static", 'B', 3 + i / 2);
    }
    const auto results = studyResults(tally);
    ASSERT_EQ(results[0].anova.size(), 1U);
    EXPECT_EQ(results[0].anova[0].effect, "pattern");
    EXPECT_TRUE(results[0].anova[0].row);
}

TEST(StudyResults, groupIsTheMeanOfParticipantsNotThePooledShare) {
    TrialTally tally;
    addCell(tally, "P1", "static", 'A', 10, 10);
    addCell(tally, "P2", "static", 'A', 0, 30);
    const auto results = studyResults(tally);
    ASSERT_EQ(results[0].groups.size(), 1U);
    EXPECT_EQ(results[0].groups[0].accuracy->mean, 0.5);
    EXPECT_EQ(results[0].groups[0].matrix.total(), 40);
}

TEST(StudyResults, medianTimesAreOfCorrectAnswersInTheTest) {
    TrialTally tally;
    addCell(tally, "P1", "static", 'A', 3); // correct after 1, 2, 3 s
    ASSERT_TRUE(tally.add({"P1", "shape", "static", Phase::practice, "A", "A", 100.0}));
    const auto results = studyResults(tally);
    EXPECT_EQ(results[0].participants[0].medianTime_s, 2.0);
    EXPECT_EQ(results[0].participants[0].times_s.size(), 3U);
}

TEST(StudyResults, doNotDependOnTheOrderOfTrials) {
    TrialTally forward;
    TrialTally backward;
    std::vector<TalliedTrial> trials;
    for (const char* person : {"a", "b", "c"}) {
        for (const char* condition : {"x", "y"}) {
            for (const char* pattern : {"A", "B", "C"})
                trials.push_back(
                    {person, "t", condition, Phase::test, pattern, *person == 'a' ? "A" : pattern, 1.0});
        }
    }
    for (std::size_t i = 0; i < trials.size(); ++i) {
        ASSERT_TRUE(forward.add(trials[i]));
        ASSERT_TRUE(backward.add(trials[trials.size() - 1 - i]));
    }
    const auto one = studyResults(forward);
    const auto other = studyResults(backward);
    EXPECT_EQ(one[0].patterns, (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_EQ(other[0].patterns, one[0].patterns);
    ASSERT_EQ(one[0].matrices.size(), other[0].matrices.size());
    for (std::size_t i = 0; i < one[0].matrices.size(); ++i)
        EXPECT_EQ(one[0].matrices[i].matrix, other[0].matrices[i].matrix);
}

// Two of two are right by chance with 1/4 among two patterns, with 1/9 among three and 1/36 among six.
TEST(StudyResults, chanceIsThatOfAllPatternsOfTheTaskAndNotOfThoseThatWereSeen) {
    const auto chance = [](const TrialTally& tally) {
        const test::TemporaryFolder folder;
        EXPECT_TRUE(writeResults(studyResults(tally), folder.path("out")));
        std::istringstream row(test::readAll(folder.path("out/summary.csv")));
        std::string field;
        std::getline(row, field);
        for (int column = 0; column < 12; ++column)
            std::getline(row, field, ',');
        return std::stod(field);
    };
    TrialTally tally;
    for (const char* pattern : {"A", "B"})
        ASSERT_TRUE(tally.add({"P1", "shape", "static", Phase::test, pattern, pattern, 1.0}));
    EXPECT_NEAR(chance(tally), 1.0 / 4.0, 1e-12);
    tally.expectPattern("shape", "C");
    tally.expectPattern("shape", "A");
    tally.expectPattern("stiffness", "F");
    const auto results = studyResults(tally);
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(results[0].patterns, (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_EQ(results[0].groups[0].matrix.patterns(), 3U);
    EXPECT_NEAR(chance(tally), 1.0 / 9.0, 1e-12);
    tally.expectCount("shape", 2);
    EXPECT_EQ(studyResults(tally)[0].alternatives(), 3U);
    tally.expectCount("shape", 6);
    tally.expectCount("shape", 5);
    EXPECT_EQ(studyResults(tally)[0].alternatives(), 6U);
    EXPECT_NEAR(chance(tally), 1.0 / 36.0, 1e-12);
}

TEST(StudyResults, thereAreNoneOfAnEmptyTally) {
    EXPECT_TRUE(studyResults(TrialTally()).empty());
}

TEST(WriteResults, hasTheColumnsOfTheFormatAndNoEmptyCell) {
    TrialTally tally = dataSetA();
    ASSERT_TRUE(tally.add({"half", "shape", "static", Phase::test, "A", "", std::nullopt}));
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeResults(studyResults(tally), folder.path("out")));
    const auto text = [&](const std::string& name) { return test::readAll(folder.path("out/" + name)); };
    const auto starts = [&](const std::string& name, const std::string& head) {
        EXPECT_EQ(text(name).substr(0, head.size() + 1), head + "\n");
    };
    starts("confusion_long.csv", "participant_id,task,condition,phase,stimulus,response,count,row_total");
    starts("summary.csv",
           "participant_id,task,condition,n,n_correct,n_timeout,accuracy,wilson_lo,wilson_hi,cp_lo,cp_hi,"
           "p_chance,it_bits,it_bias_bits,it_corrected_bits,rt_median_s,rt_n");
    starts("anova.csv", "task,effect,stimulus,df1,df2,ss,ss_error,f,p,eps_gg,p_gg,eps_hf,p_hf,partial_eta2,"
                        "generalized_eta2,n,dropped,note");
    for (const char* name : {"confusion_long.csv", "summary.csv", "group.csv", "anova.csv"}) {
        EXPECT_EQ(text(name).find(",,"), std::string::npos) << name;
        EXPECT_EQ(text(name).find(",\n"), std::string::npos) << name;
        EXPECT_EQ(text(name).find("inf"), std::string::npos) << name;
    }
    EXPECT_NE(text("confusion_long.csv").find("\nhalf,shape,static,test,A,NONE,1,1\n"), std::string::npos);
    EXPECT_NE(text("confusion_long.csv").find("\nGROUP,shape,static,test,A,NONE,1,41\n"), std::string::npos);
    EXPECT_NE(text("anova.csv").find(",half,NA\n"), std::string::npos);
}

TEST(WriteResults, aFolderThatCannotBeMadeIsAnError) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("file", "");
    EXPECT_FALSE(writeResults(studyResults(dataSetA()), file + "/out"));
}

} // namespace teleta::study
