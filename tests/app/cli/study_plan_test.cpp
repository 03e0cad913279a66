// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

constexpr const char* kProtocol = R"(name = "two"
stimulus_s = 1.0
response_limit_s = 5.0
response_window = "from_onset"
order = "full_random"
[practice]
repetitions = 0
[test]
repetitions = 10
[masking_noise]
colour = "none"
[[task]]
id = "shape"
condition = [{ id = "static" }, { id = "dynamic" }]
pattern = [{ letter = "A" }, { letter = "B" }]
)";

constexpr const char* kTruth = R"([[task]]
id = "shape"
participant_sd = 0.3
participant_condition_sd = 0.1
condition = [{ id = "static", correct = 0.6 }, { id = "dynamic", correct = 0.85 }]
)";

class StudyPlanCommand : public testing::Test {
protected:
    void SetUp() override {
        m_protocol = m_folder.write("p.toml", kProtocol);
        m_truth = m_folder.write("truth.toml", kTruth);
    }

    [[nodiscard]] ProgramResult plan(std::vector<std::string> more) const {
        std::vector<std::string> all{"study", "plan", m_protocol, "--truth", m_truth, "--studies", "400"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    }

    TemporaryFolder m_folder;
    std::string m_protocol;
    std::string m_truth;
};

/// Trials of one participant with these response times, all right.
std::string rowsOf(const std::string& id, const std::vector<std::string>& times_s) {
    std::string rows;
    for (std::size_t i = 0; i < times_s.size(); ++i)
        rows += id + ",shape," + (i % 2 == 0 ? "static" : "dynamic") + ",test,A,A," + times_s[i] + '\n';
    return rows;
}

constexpr const char* kHeader = "participant_id,task,condition,phase,stimulus,response,response_time_s\n";

} // namespace

TEST_F(StudyPlanCommand, givesThePowerAtEachNumberOfParticipants) {
    const std::string csv = m_folder.path("plan.csv");
    const ProgramResult result =
        plan({"--participants", "4:8:2", "--test", "shape:condition", "--out", csv, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json answer = ordered_json::parse(result.out);
    ASSERT_EQ(answer["points"].size(), 3U);
    double before = 0.0;
    for (const ordered_json& point : answer["points"]) {
        const double power = point["power"];
        EXPECT_GT(power, before) << "more participants, more power";
        EXPECT_LE(point["interval_95"][0], power);
        EXPECT_GE(point["interval_95"][1], power);
        before = power;
    }
    const auto rows = splitCsv(readAll(csv));
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[1][0], "shape:condition");
    EXPECT_EQ(rows[3][1], "8");
    const ProgramResult again = plan({"--participants", "4:8:2", "--test", "shape:condition", "--json"});
    EXPECT_EQ(again.out, result.out) << "the same seed, the same numbers";
    const ProgramResult table = plan({"--participants", "4:8:2", "--test", "shape:condition"});
    EXPECT_NE(table.out.find("4 participants"), std::string::npos) << table.out;
}

TEST_F(StudyPlanCommand, aPilotStandsInForTheTruth) {
    const std::string pilot = m_folder.path("pilot");
    ASSERT_EQ(run({"study", "rehearse", m_protocol, "--participants", "6", "--out", pilot}).exitCode, 0);
    const ProgramResult result = run({"study", "plan", m_protocol, "--truth", pilot, "--participants", "6",
                                      "--studies", "200", "--test", "shape:pattern", "--json"});
    // Simulated participants with one matrix: no difference to find, and power near 5 %.
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_TRUE(ordered_json::parse(result.out)["participants"].is_null());
    const std::string small = m_folder.path("small");
    ASSERT_EQ(run({"study", "rehearse", m_protocol, "--participants", "3", "--out", small}).exitCode, 0);
    const ProgramResult few =
        run({"study", "plan", m_protocol, "--truth", small, "--test", "shape:condition"});
    EXPECT_EQ(few.exitCode, 1);
    EXPECT_NE(few.err.find("5 participants"), std::string::npos) << few.err;
}

TEST_F(StudyPlanCommand, plansTheIntervalOfAThreshold) {
    const std::string truth = m_folder.write(
        "detect.toml", "[[task]]\nid = \"detection\"\nthreshold = { t = 0.1, slope = 3.5, sd = 0.15 }\n");
    const auto planOf = [&](const std::string& width) {
        const ProgramResult result = run({"study", "plan", "tactor-detection", "--truth", truth, "--test",
                                          "detection:threshold", "--participants", "4:12:8", "--studies",
                                          "100", "--trials", "20", "--width", width, "--json"});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return ordered_json::parse(result.out);
    };
    const ordered_json wide = planOf("0.2");
    EXPECT_GT(wide["points"][1]["power"], wide["points"][0]["power"]);
    EXPECT_EQ(wide["points"][1]["studies"], 100);
    EXPECT_LT(planOf("0.05")["points"][1]["power"], wide["points"][1]["power"]);
    const ProgramResult none =
        run({"study", "plan", "tactor-detection", "--truth", m_truth, "--test", "detection:threshold"});
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_NE(none.err.find("threshold"), std::string::npos) << none.err;
}

TEST_F(StudyPlanCommand, mistakesAreTold) {
    EXPECT_EQ(plan({"--test", "shape:luck"}).exitCode, 3);
    EXPECT_NE(plan({"--test", "form:condition"}).err.find("shape"), std::string::npos);
    for (const char* numbers : {"", "0:4", "8:4", "4:8:0", "a", "1:2:3:4", "5000"})
        EXPECT_EQ(plan({"--test", "shape:condition", "--participants", numbers}).exitCode, 2) << numbers;
    EXPECT_EQ(plan({}).exitCode, 2) << "no test";
    const std::string truth = m_folder.write("bad.toml", "[[task]]\nid = \"shape\"\nluck = 1\n");
    const ProgramResult bad =
        run({"study", "plan", m_protocol, "--truth", truth, "--test", "shape:condition"});
    EXPECT_EQ(bad.exitCode, 3);
    EXPECT_NE(bad.err.find("bad.toml:"), std::string::npos) << bad.err;
}

TEST_F(StudyPlanCommand, rulesOfTheCommandLineAreMarkedAsMadeAfterTheData) {
    const std::string csv = m_folder.write("t.csv", kHeader + rowsOf("P1", {"0.1", "1.0", "1.2", "1.1"}) +
                                                        rowsOf("P2", {"1.0", "1.4", "1.2", "1.3"}));
    const std::string out = m_folder.path("r");
    const ProgramResult result =
        run({"study", "analyze", csv, "--exclude", "response_time_below_s=0.2", "--out", out, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json rules = ordered_json::parse(result.out)["exclusions"];
    ASSERT_EQ(rules.size(), 1U);
    EXPECT_EQ(rules[0]["trials"], 1);
    EXPECT_EQ(rules[0]["after_the_data"], true);
    const auto rows = splitCsv(readAll(out + "/exclusions.csv"));
    ASSERT_EQ(rows.size(), 3U) << "the rule, and the participant who lost a trial";
    EXPECT_EQ(rows[1][4], "after the data");
    EXPECT_EQ(rows[2][5], "P1");
    EXPECT_NE(readAll(out + "/report.html").find("made after the data"), std::string::npos);
    // 3 of 4 trials of P1 are left.
    EXPECT_EQ(splitCsv(readAll(out + "/summary.csv"))[2][3], "1");
    EXPECT_EQ(run({"study", "analyze", csv, "--exclude", "luck=1", "--out", out}).exitCode, 3);
    const ProgramResult nothing =
        run({"study", "analyze", csv, "--exclude", "response_time_below_s=100", "--out", m_folder.path("n")});
    EXPECT_EQ(nothing.exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("n")));
}

TEST_F(StudyPlanCommand, rulesOfTheProtocolMarkTheExportedTrials) {
    const std::string protocol = m_folder.write(
        "rules.toml", std::string(kProtocol) + "[[exclude]]\nid = \"slow\"\nof = \"trial\"\n"
                                               "rule = \"response_time_above_s\"\nvalue = 3.0\n");
    const std::string study = m_folder.path("study");
    ASSERT_EQ(run({"study", "rehearse", protocol, "--participants", "2", "--out", study}).exitCode, 0);
    std::size_t marked = 0;
    std::size_t slow = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(study + "/data")) {
        if (entry.path().extension() != ".csv")
            continue;
        const auto rows = splitCsv(readAll(entry.path().string()));
        const auto column = [&](const char* name) {
            return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) -
                                            rows[0].begin());
        };
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const std::string& time_s = rows[i].at(column("response_time_s"));
            slow += time_s != "NA" && std::stod(time_s) > 3.0 ? 1 : 0;
            const std::string& rule = rows[i].at(column("excluded"));
            EXPECT_TRUE(rule == "NA" || rule == "slow");
            marked += rule == "slow" ? 1 : 0;
        }
    }
    EXPECT_GT(marked, 0U);
    EXPECT_EQ(marked, slow);
    // The store and its exported rows give the same results and counts.
    const ProgramResult ofStore = run({"study", "analyze", study, "--out", m_folder.path("a"), "--json"});
    ASSERT_EQ(ofStore.exitCode, 0) << ofStore.err;
    EXPECT_EQ(ordered_json::parse(ofStore.out)["exclusions"][0]["trials"], marked);
    std::vector<std::string> files{"study", "analyze"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(study + "/data")) {
        if (entry.path().extension() == ".csv")
            files.push_back(entry.path().string());
    }
    files.insert(files.end(), {"--out", m_folder.path("b")});
    ASSERT_EQ(run(files).exitCode, 0);
    for (const char* table : {"/summary.csv", "/anova.csv", "/comparisons.csv", "/response_times.csv"})
        EXPECT_EQ(readAll(m_folder.path("a") + table), readAll(m_folder.path("b") + table)) << table;
}
