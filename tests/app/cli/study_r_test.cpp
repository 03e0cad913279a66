// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

using Table = std::map<std::string, std::map<std::string, std::string>>;

/// Rows by the values of their first columns, as columns by name.
Table tableOf(const std::string& path, std::size_t keys) {
    Table table;
    const auto rows = splitCsv(readAll(path));
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].size() != rows[0].size())
            continue;
        std::string key;
        for (std::size_t j = 0; j < keys; ++j)
            key += rows[i][j] + '|';
        for (std::size_t j = keys; j < rows[i].size(); ++j)
            table[key][rows[0][j]] = rows[i][j];
    }
    return table;
}

/// Numbers of both tables in these columns agree to a part of their size.
void expectSame(const Table& ours, const Table& theirs, const std::vector<std::string>& columns,
                double tolerance = 1e-6) {
    ASSERT_FALSE(theirs.empty());
    for (const auto& [key, row] : theirs) {
        const auto found = ours.find(key);
        ASSERT_NE(found, ours.end()) << key;
        for (const std::string& column : columns) {
            const double expected = std::strtod(row.at(column).c_str(), nullptr);
            const double value = std::strtod(found->second.at(column).c_str(), nullptr);
            EXPECT_NEAR(value, expected, tolerance * std::max(1e-3, std::abs(expected)))
                << key << ' ' << column;
        }
    }
}

} // namespace

TEST(StudyR, theScriptThatComesWithAStudyGivesTheSameNumbersInR) {
    if (std::system("Rscript --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "Rscript is not installed, so there is nothing to compare with";
    const TemporaryFolder folder;
    const std::string study = folder.path("study");
    const std::string results = folder.path("results");
    ASSERT_EQ(run({"study", "rehearse", "--out", study, "--seed", "9", "--lapses", "0.05"}).exitCode, 0);
    ASSERT_EQ(run({"study", "analyze", study, "--out", results}).exitCode, 0);
    const auto inR = [](const std::string& at) {
        return std::system(("Rscript --vanilla '" + at + "/analysis.R' '" + at + "' > /dev/null").c_str());
    };
    ASSERT_EQ(inR(study), 0) << "from the exported trials";
    ASSERT_EQ(inR(results), 0) << "from the confusion matrices";
    const std::vector<std::string> anova = {
        "df1",    "df2",  "ss",           "ss_error",         "f", "p", "eps_gg", "p_gg",
        "eps_hf", "p_hf", "partial_eta2", "generalized_eta2", "n"};
    const std::vector<std::string> summary = {"n",         "n_correct", "n_timeout",    "accuracy",
                                              "wilson_lo", "wilson_hi", "cp_lo",        "cp_hi",
                                              "p_chance",  "it_bits",   "it_bias_bits", "it_corrected_bits"};
    const std::vector<std::string> group = {
        "participants", "accuracy_mean", "accuracy_sd",       "t_lo",          "t_hi",  "n",
        "it_bits",      "it_bias_bits",  "it_corrected_bits", "it_few_trials", "it_lo", "it_hi"};
    for (const std::string& from : {study, results}) {
        expectSame(tableOf(results + "/anova.csv", 3), tableOf(from + "/anova_r.csv", 3), anova);
        expectSame(tableOf(results + "/summary.csv", 3), tableOf(from + "/summary_r.csv", 3), summary);
        expectSame(tableOf(results + "/group.csv", 2), tableOf(from + "/group_r.csv", 2), group);
    }
    const Table pairs = tableOf(results + "/comparisons.csv", 5);
    const Table ranks = tableOf(results + "/ranks.csv", 6);
    for (const std::string& from : {study, results}) {
        expectSame(pairs, tableOf(from + "/comparisons_r.csv", 5),
                   {"n", "difference", "lo", "hi", "t", "df", "p", "p_holm", "dz", "dz_lo", "dz_hi", "dav",
                    "hedges_j", "gz"});
        expectSame(pairs, tableOf(from + "/partial_eta2_r.csv", 5),
                   {"partial_eta2", "partial_eta2_lo", "partial_eta2_hi"});
        expectSame(ranks, tableOf(from + "/ranks_r.csv", 6),
                   {"n", "zeros", "w_plus", "w_minus", "p", "p_holm", "exact", "rank_biserial"});
        expectSame(ranks, tableOf(from + "/friedman_r.csv", 6), {"n", "chi2", "df", "p", "kendall_w"});
        expectSame(
            tableOf(results + "/binomial_model.csv", 4), tableOf(from + "/binomial_model_r.csv", 4),
            {"estimate", "se", "lo", "hi", "sd_participants", "log_likelihood", "lr_chi2", "lr_df", "lr_p"},
            1e-4);
    }
    // Two conditions and six (five) patterns: 1 + 15 + 6 (1 + 10 + 5) pairs.
    EXPECT_LE(tableOf(results + "/comparisons_r.csv", 5).size(), 22U + 16U);
    EXPECT_GE(tableOf(results + "/comparisons_r.csv", 5).size(), 30U);
    expectSame(tableOf(results + "/response_times.csv", 4), tableOf(study + "/response_times_r.csv", 4),
               {"n", "geometric_mean_s", "median_s"});
    expectSame(tableOf(results + "/response_times.csv", 4), tableOf(study + "/response_time_ratios_r.csv", 4),
               {"n", "ratio", "lo", "hi", "t", "df", "p", "p_holm"});
    expectSame(tableOf(results + "/summary.csv", 3), tableOf(study + "/summary_r.csv", 3),
               {"rt_median_s", "rt_n"});
    EXPECT_EQ(tableOf(study + "/summary_r.csv", 3).size(), 24U);
    EXPECT_EQ(tableOf(study + "/group_r.csv", 2).size(), 4U);
    EXPECT_EQ(tableOf(study + "/anova_r.csv", 3).size(), tableOf(results + "/anova.csv", 3).size());
}

TEST(StudyR, anIdWithACommaOrAQuoteIsOneFieldAndPatternsThatNobodyFeltCount) {
    if (std::system("Rscript --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "Rscript is not installed, so there is nothing to compare with";
    const TemporaryFolder folder;
    const std::string results = folder.path("results");
    const std::string odd = "\"O'Neil, \"\"B\"\"\"";
    std::string table = "participant_id,task,condition,phase,stimulus,response,outcome,response_time_s,"
                        "n_alternatives\n";
    const auto add = [&](const std::string& id, const std::string& answers) {
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const char stimulus = i < answers.size() / 2 ? 'A' : 'B';
            table += id + ",shape,static,test," + stimulus + ',' + answers[i] +
                     (answers[i] == stimulus ? ",correct,1.5,6\n" : ",incorrect,2.5,6\n");
        }
    };
    add("P1", "ABBB");
    add("P2", "AAAB");
    add(odd, "BBBA");
    const std::string data = "study/data/subject-1_task-shape_data.csv";
    std::filesystem::create_directories(folder.path("study/data"));
    const std::string trials = folder.write(data, table);
    ASSERT_EQ(run({"study", "analyze", trials, "--out", results}).exitCode, 0);
    const auto inR = [&](const std::string& from, const std::string& out) {
        return std::system(
            ("Rscript --vanilla '" + results + "/analysis.R' '" + from + "' '" + out + "' > /dev/null")
                .c_str());
    };
    ASSERT_EQ(inR(folder.path("study"), folder.path("of_trials")), 0);
    ASSERT_EQ(inR(results, folder.path("of_results")), 0);
    for (const char* file : {"results/summary.csv", "of_trials/summary_r.csv", "of_results/summary_r.csv"}) {
        const std::string text = readAll(folder.path(file));
        EXPECT_NE(text.find('\n' + odd + ",shape,static,4,1,0,"), std::string::npos) << file << '\n' << text;
        EXPECT_NE(text.find("\nP1,shape,static,4,3,0,"), std::string::npos) << file << '\n' << text;
    }
    // The row of the odd id has a comma more than the others and is left out here.
    const Table theirs = tableOf(folder.path("of_trials/summary_r.csv"), 3);
    EXPECT_EQ(theirs.size(), 2U);
    expectSame(tableOf(results + "/summary.csv", 3), theirs,
               {"accuracy", "p_chance", "it_bits", "rt_median_s", "rt_n"});
    expectSame(
        tableOf(results + "/group.csv", 2), tableOf(folder.path("of_trials/group_r.csv"), 2),
        {"participants", "accuracy_mean", "it_bits", "it_corrected_bits", "it_few_trials", "it_at_most"});
    expectSame(tableOf(results + "/anova.csv", 3), tableOf(folder.path("of_trials/anova_r.csv"), 3),
               {"f", "p", "n"});
}

// Thresholds and signal detection: from the trials, and from the counts in the results of an analysis.
TEST(StudyR, fitsTheSameThresholdsInR) {
    if (std::system("Rscript --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "Rscript is not installed, so there is nothing to compare with";
    const TemporaryFolder folder;
    const std::string results = folder.path("results");
    std::string table =
        "participant_id,task,condition,phase,track,level,stimulus,response,outcome,response_time_s,"
        "design,n_alternatives,level_unit,reference,procedure\n";
    const auto add = [&](const std::string& who, const std::string& track, const std::string& level,
                         int right, int trials, const std::string& stimulus, const std::string& other,
                         const std::string& rest) {
        for (int i = 0; i < trials; ++i) {
            const bool isRight = i < right;
            table += who + ",t_" + rest.substr(0, rest.find(',')) + ",rest,test," + track + ',' + level +
                     ',' + stimulus + ',' + (isRight ? stimulus : other) +
                     (isRight ? ",correct" : ",incorrect") + ",1.5," + rest + '\n';
        }
    };
    const std::vector<std::string> levels{"0.02", "0.04", "0.06", "0.08", "0.12", "0.16"};
    const std::map<std::string, std::vector<int>> answers{
        {"P1", {22, 25, 29, 33, 38, 39}}, {"P2", {22, 25, 36, 28, 38, 32}}, {"P3", {40, 40, 40, 40, 40, 40}},
        {"P4", {39, 38, 33, 29, 25, 22}}, {"P5", {20, 20, 20, 40, 40, 40}}, {"P6", {21, 24, 30, 36, 39, 40}}};
    for (const auto& [who, right] : answers) {
        for (std::size_t i = 0; i < levels.size(); ++i) {
            add(who, "a", levels[i], right[i] / 2, 20, "1", "2", "interval,2,drive,0,constant");
            add(who, "a", levels[i], right[i] - right[i] / 2, 20, "2", "1", "interval,2,drive,0,constant");
        }
    }
    for (std::size_t i = 0; i < levels.size(); ++i)
        add("P1", "a", levels[i], answers.at("P6")[i] - 18, 22, "yes", "no", "yes_no,2,drive,0,constant");
    add("P1", "a", "0", 25, 28, "no", "yes", "yes_no,2,drive,0,constant");
    const std::vector<int> more{0, 2, 5, 9, 15, 19, 20};
    for (int i = 0; i < 7; ++i) {
        const std::string level = "0." + std::to_string(i + 2);
        add("P1", "a", level,
            i < 3 ? 20 - more[static_cast<std::size_t>(i)] : more[static_cast<std::size_t>(i)], 20, "1", "2",
            "compare,2,drive,0.5,constant");
    }
    const std::string data = "study/data/subject-1_task-t_data.csv";
    std::filesystem::create_directories(folder.path("study/data"));
    const std::string trials = folder.write(data, table);
    const auto analysed = run({"study", "analyze", trials, "--out", results});
    ASSERT_EQ(analysed.exitCode, 0) << analysed.err;
    // Design and function tell the mean of a group from the fit of all.
    const Table ours = tableOf(results + "/thresholds.csv", 6);
    const Table detection = tableOf(results + "/sdt.csv", 4);
    EXPECT_EQ(ours.size(), 8U + 3U + 1U);
    for (const std::string& from : {folder.path("study"), results}) {
        const std::string out = folder.path("out");
        ASSERT_EQ(std::system(("Rscript --vanilla '" + results + "/analysis.R' '" + from + "' '" + out +
                               "' > /dev/null")
                                  .c_str()),
                  0);
        const Table theirs = tableOf(out + "/thresholds_r.csv", 6);
        EXPECT_EQ(theirs.size(), ours.size());
        for (const auto& [key, row] : theirs) {
            ASSERT_TRUE(ours.contains(key)) << key;
            for (const char* column : {"n", "interval", "unit"})
                EXPECT_EQ(ours.at(key).at(column), row.at(column)) << key << ' ' << column;
            const std::string note = ours.at(key).at("note");
            const std::string hierarchical = "hierarchical; sd of participants ";
            if (note.starts_with(hierarchical)) {
                ASSERT_TRUE(row.at("note").starts_with(hierarchical)) << row.at("note");
                const double sd = std::stod(row.at("note").substr(hierarchical.size()));
                EXPECT_NEAR(std::stod(note.substr(hierarchical.size())), sd, 1e-3 * sd);
            } else {
                EXPECT_EQ(note, row.at("note")) << key;
            }
            for (const char* column :
                 {"threshold", "lo", "hi", "spread", "guess", "lapse", "deviance", "jnd", "weber", "pse"}) {
                const std::string& value = ours.at(key).at(column);
                ASSERT_EQ(value == "NA", row.at(column) == "NA") << key << ' ' << column;
                const double expected = std::strtod(row.at(column).c_str(), nullptr);
                EXPECT_NEAR(std::strtod(value.c_str(), nullptr), expected,
                            1e-4 * std::max(1e-2, std::abs(expected)))
                    << key << ' ' << column;
            }
        }
        const Table detected = tableOf(out + "/sdt_r.csv", 4);
        EXPECT_EQ(detected.size(), detection.size());
        expectSame(detection, detected, {"dprime", "lo", "hi", "c"});
    }
}
