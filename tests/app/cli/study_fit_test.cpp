// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

class StudyFit : public testing::Test {
protected:
    /// Six levels of 40 trials each.
    [[nodiscard]] static std::string rows(const std::string& participant, const std::vector<int>& correct) {
        const char* levels[] = {"0.02", "0.04", "0.06", "0.08", "0.12", "0.16"};
        std::string text;
        for (std::size_t i = 0; i < correct.size(); ++i) {
            for (int trial = 0; trial < 40; ++trial)
                text += participant + ",detect,rest,test,t1," + levels[i] +
                        (trial < correct[i] ? ",1\n" : ",0\n");
        }
        return text;
    }
    [[nodiscard]] std::string table(const std::string& text) const {
        return m_folder.write("trials.csv",
                              "participant_id,task,condition,phase,track,level,correct\n" + text);
    }

    TemporaryFolder m_folder;
};

const std::vector<int> kP1{22, 25, 29, 33, 38, 39};

} // namespace

// Values of R optim and of Python.
TEST_F(StudyFit, fitsAHandMadeTable) {
    const ProgramResult result = run({"study", "fit", table(rows("P01", kP1)), "--guess", "0.5", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json line = ordered_json::parse(result.out)["thresholds"][0];
    EXPECT_EQ(line["function"], "weibull");
    EXPECT_NEAR(line["threshold"].get<double>(), .06182085, 1e-7);
    EXPECT_NEAR(line["threshold_interval"][0].get<double>(), .0448439, 1e-6);
    EXPECT_NEAR(line["spread"].get<double>(), 1.991325, 1e-5);
    EXPECT_NEAR(line["deviance"].get<double>(), .0777117, 1e-6);
    EXPECT_NEAR(line["p_deviance"].get<double>(), .995, .01);
    EXPECT_TRUE(line["note"].is_null());
}

TEST_F(StudyFit, takesFunctionLapseRateAndInterval) {
    const std::string path = table(rows("P01", kP1));
    const auto fitOf = [&](std::vector<std::string> options) {
        std::vector<std::string> words{"study", "fit", path, "--guess", "0.5", "--json"};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramResult result = run(words);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return ordered_json::parse(result.out)["thresholds"][0];
    };
    EXPECT_NEAR(fitOf({"--lapse", "0.02"})["threshold"].get<double>(), .06172666, 1e-7);
    EXPECT_NEAR(fitOf({"--function", "gauss"})["threshold"].get<double>(), .06292438, 1e-7);
    const ordered_json logistic = fitOf({"--function", "logistic", "--lapse", "0.02:0.02"});
    EXPECT_NEAR(logistic["spread"].get<double>(), .02133562, 1e-7);
    const ordered_json bootstrap = fitOf({"--interval", "bootstrap"});
    EXPECT_NEAR(bootstrap["threshold_interval"][1].get<double>(), .0799457, .01);
}

TEST_F(StudyFit, writesTablesFiguresAndTheScript) {
    const std::string out = m_folder.path("fits");
    const ProgramResult result =
        run({"study", "fit", table(rows("P01", kP1) + rows("P02", {40, 40, 40, 40, 40, 40})), "--guess",
             "0.5", "--out", out});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("threshold 0.0618 (0.0448 to 0.0799)"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("below 0.02, the lowest level"), std::string::npos) << result.out;
    const auto lines = splitCsv(readAll(out + "/thresholds.csv"));
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[2].back(), "belowRange (below 0.02)");
    EXPECT_EQ(lines[3][0], "GROUP");
    for (const char* file : {"/levels.csv", "/analysis.R", "/figures/curve_detect_rest_t1_P01.svg",
                             "/figures/track_detect_rest_t1_P02.svg", "/figures/thresholds_detect.svg"})
        EXPECT_TRUE(std::filesystem::exists(out + file)) << file;
    EXPECT_FALSE(std::filesystem::exists(out + "/sdt.csv"));
}

TEST_F(StudyFit, refusesWhatItCannotFit) {
    const ProgramResult noGuess = run({"study", "fit", table(rows("P01", kP1))});
    EXPECT_EQ(noGuess.exitCode, 3);
    EXPECT_NE(noGuess.err.find("--guess"), std::string::npos) << noGuess.err;
    const std::string none = m_folder.write(
        "shape.csv", "participant_id,task,condition,phase,stimulus,response\nP01,shape,static,test,A,A\n");
    const ProgramResult noLevels = run({"study", "fit", none});
    EXPECT_EQ(noLevels.exitCode, 3);
    EXPECT_NE(noLevels.err.find("level"), std::string::npos) << noLevels.err;
    for (const char* lapse : {"much", "0.5:0.6", "0.06:0.02", "-0.1"}) {
        const ProgramResult bad =
            run({"study", "fit", table(rows("P01", kP1)), "--guess", "0.5", "--lapse", lapse});
        EXPECT_NE(bad.exitCode, 0) << lapse;
        EXPECT_NE(bad.err.find("--lapse"), std::string::npos) << bad.err;
    }
    EXPECT_NE(run({"study", "fit", m_folder.path("nothing.csv")}).exitCode, 0);
    const ProgramResult broken = run({"study", "fit", table("P01,detect,rest,test,t1,high,1\n")});
    EXPECT_EQ(broken.exitCode, 3);
    EXPECT_NE(broken.err.find("trials.csv:2:"), std::string::npos) << broken.err;
}

// Rules of the command line reach fits and d', and what they leave out is not counted there.
TEST_F(StudyFit, analyzeLeavesOutWhatARuleExcludes) {
    std::string rows = "participant_id,task,condition,phase,level,stimulus,response,response_time_s,design,"
                       "n_alternatives,session_id\n";
    const char* levels[] = {"0.02", "0.04", "0.06", "0.08", "0.12", "0.16"};
    for (int i = 0; i < 6; ++i) {
        for (int trial = 0; trial < 40; ++trial)
            rows += std::string("P01,detect,rest,test,") + levels[i] + ",1," +
                    (trial < kP1[static_cast<std::size_t>(i)] ? "1" : "2") + ",0.9,interval,2,s1\n";
        for (int hasty = 0; hasty < 10; ++hasty)
            rows += std::string("P01,detect,rest,test,") + levels[i] + ",1,2,0.05,interval,2,s1\n";
    }
    const std::string out = m_folder.path("results");
    const std::string path = m_folder.write("hasty.csv", rows);
    const ProgramResult result =
        run({"study", "analyze", path, "--exclude", "response_time_below_s=0.2", "--out", out});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto lines = splitCsv(readAll(out + "/thresholds.csv"));
    ASSERT_GE(lines.size(), 2U);
    EXPECT_EQ(lines[1][6], "240") << "n";
    EXPECT_NEAR(std::stod(lines[1][7]), .06182085, 1e-7);
    EXPECT_EQ(splitCsv(readAll(out + "/sdt.csv"))[1][5], "240");
    EXPECT_NE(readAll(out + "/report.html").find("Thresholds: detect"), std::string::npos);
    const ProgramResult refused = run({"study", "analyze", table("P01,d,r,test,t,0.1,1\n"), "--exclude",
                                       "response_time_below_s=0.2", "--out", out});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.err.find("--exclude"), std::string::npos) << refused.err;
}

// A table with levels alone has no patterns to tell apart.
TEST_F(StudyFit, analyzeWritesThresholdsOfSuchATable) {
    const std::string out = m_folder.path("results");
    const std::string path = m_folder.write(
        "trials.csv", "participant_id,task,condition,phase,level,correct,design,n_alternatives\n"
                      "P01,detect,rest,test,0.1,1,interval,2\n"
                      "P01,detect,rest,test,0.1,0,interval,2\n");
    const ProgramResult result = run({"study", "analyze", path, "--out", out});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto lines = splitCsv(readAll(out + "/thresholds.csv"));
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1].back(), "tooFewLevels");
    EXPECT_EQ(splitCsv(readAll(out + "/sdt.csv"))[1].back(), "2 intervals");
}
