// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

/// However busy this machine is.
ProgramResult measure(std::vector<std::string> arguments) {
    arguments.emplace_back("--largest-spread");
    arguments.emplace_back("1e9");
    return run(arguments);
}

class TradeoffCommand : public testing::Test {
protected:
    TemporaryFolder m_folder;
};

} // namespace

TEST_F(TradeoffCommand, printsTheAgreedColumnsAndMarksAFront) {
    const ProgramResult result = measure({"tradeoff", "stiffness"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto rows = splitCsv(result.out);
    ASSERT_GT(rows.size(), 2U);
    EXPECT_EQ(
        result.out.substr(0, result.out.find('\n')),
        "ladder,rung,parameter,error_mean,error_p95,error_max,error_unit,time_median_s,time_p99_s,samples,"
        "pareto");
    bool front = false;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_EQ(rows[i].size(), rows[0].size());
        EXPECT_EQ(rows[i][0], "stiffness");
        EXPECT_GT(std::strtod(rows[i][7].c_str(), nullptr), 0.0);
        EXPECT_LE(std::strtod(rows[i][7].c_str(), nullptr), std::strtod(rows[i][8].c_str(), nullptr));
        EXPECT_GE(std::stoi(rows[i][9]), 30);
        front = front || rows[i][10] == "yes";
    }
    EXPECT_TRUE(front);
}

TEST_F(TradeoffCommand, writesItsFilesAndPrintsATableWithTheSpread) {
    const std::string folder = m_folder.path("cost");
    const ProgramResult result = measure({"tradeoff", "tactile-features", "--out", folder});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(splitCsv(readAll(folder + "/tradeoff.csv")).size(), 5U)
        << "the header, three rungs and the limit";
    EXPECT_EQ(readAll(folder + "/tactile-features.svg").substr(0, 4), "<svg");
    for (const char* word :
         {"tactile-features", "sub-taxel", "spread", "%", "times the limit (each taxel read once"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word;
}

TEST_F(TradeoffCommand, printsOneDocument) {
    const ProgramResult result = measure({"tradeoff", "tactile-features", "stiffness", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json document = ordered_json::parse(result.out);
    ASSERT_EQ(document["ladders"].size(), 2U);
    for (const ordered_json& ladder : document["ladders"])
        for (const ordered_json& rung : ladder["rungs"]) {
            EXPECT_GT(rung["time_median_s"].get<double>(), 0.0);
            EXPECT_GE(rung["spread"].get<double>(), 0.0);
            EXPECT_TRUE(rung["pareto"].is_boolean());
        }
    const ordered_json& limit = document["ladders"][1]["ladder"] == "tactile-features"
                                    ? document["ladders"][1]["limit"]
                                    : document["ladders"][0]["limit"];
    EXPECT_EQ(limit["fastest"], "binarised");
    EXPECT_GT(limit["fastest_over_limit"].get<double>(), 1.0);
}

TEST_F(TradeoffCommand, listsItsLadders) {
    const ProgramResult list = run({"tradeoff", "--list", "--json"});
    ASSERT_EQ(list.exitCode, 0) << list.err;
    EXPECT_EQ(ordered_json::parse(list.out).size(), 13U);
    for (const char* name :
         {"contact-flow", "camera-calibration", "undistortion", "contour", "stiffness", "tactile-features",
          "taxel-gains", "simulation-step", "scene-effects", "statistics"})
        EXPECT_TRUE(std::ranges::any_of(ordered_json::parse(list.out), [&](const ordered_json& ladder) {
            return ladder["ladder"] == name && !ladder["truth"].get<std::string>().empty();
        })) << name;
}

TEST_F(TradeoffCommand, refusesWhatItDoesNotKnowBeforeItMeasures) {
    const ProgramResult unknown = run({"tradeoff", "speed"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("stiffness"), std::string::npos)
        << "it names those that there are: " << unknown.err;
    EXPECT_EQ(run({"tradeoff", "--largest-spread", "0"}).exitCode, 2);
    EXPECT_EQ(run({"tradeoff", "stiffness", "--out", "/proc/no/such/folder"}).exitCode, 1);
}

TEST_F(TradeoffCommand, aNoisyMachineIsToldAndItsTimesAreNotShown) {
    const std::string folder = m_folder.path("cost");
    // No machine runs so evenly.
    const ProgramResult result =
        run({"tradeoff", "tactile-features", "--out", folder, "--largest-spread", "1e-9"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("too busy"), std::string::npos) << result.err;
    EXPECT_NE(result.out.find("refused"), std::string::npos);
    const auto rows = splitCsv(readAll(folder + "/tradeoff.csv"));
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[1][7], "NA");
    EXPECT_EQ(rows[1][8], "NA");
    EXPECT_EQ(rows[1][10], "no");
    EXPECT_GT(std::strtod(rows[1][3].c_str(), nullptr), 0.0) << "errors do not depend on the machine";
}
