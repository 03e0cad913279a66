// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

/// A 2 x 3 array whose responses are 1, 2, 3, 2, 1, 3 (mean 2), tared at 100 counts.
class GainsCommand : public testing::Test {
protected:
    GainsCommand() {
        std::string press = "time_s,t0,t1,t2,t3,t4,t5\n";
        for (int frame = 0; frame < 40; ++frame) {
            const int load = 10 + frame % 5;
            press.append(std::to_string(frame))
                .append(",")
                .append(row({1, 2, 3, 2, 1, 3}, load))
                .append("\n");
        }
        m_press = m_folder.write("press.csv", press);
        m_empty = m_folder.write("empty.csv", "time_s,t0,t1,t2,t3,t4,t5\n0,100,100,100,100,100,100\n");
    }

    static std::string row(const std::vector<int>& responses, int load) {
        std::string text;
        for (const int response : responses) {
            if (!text.empty())
                text += ',';
            text += std::to_string(100 + response * load);
        }
        return text;
    }

    [[nodiscard]] std::vector<std::string> arguments(std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"gains", m_press, "--rows", "2", "--columns", "3", "--tare", m_empty};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    TemporaryFolder m_folder;
    std::string m_press;
    std::string m_empty;
};

} // namespace

TEST_F(GainsCommand, printsARowATaxel) {
    const ProgramResult result = run(arguments());
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const auto rows = splitCsv(result.out);
    ASSERT_EQ(rows.size(), 7U);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"taxel", "row", "column", "gain", "gain_se", "state"}));
    const double expected[]{2.0, 1.0, 2.0 / 3.0, 1.0, 2.0, 2.0 / 3.0};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(rows[i + 1][0], std::to_string(i));
        EXPECT_EQ(rows[i + 1][1], std::to_string(i / 3));
        EXPECT_EQ(rows[i + 1][2], std::to_string(i % 3));
        EXPECT_NEAR(std::stod(rows[i + 1][3]), expected[i], 1e-12);
        EXPECT_EQ(rows[i + 1][5], "good");
    }
}

TEST_F(GainsCommand, writesAFileThatTheOtherCommandsUse) {
    const std::string gains = m_folder.path("gains.csv");
    const ProgramResult made = run(arguments({"--out", gains}));
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_NE(made.out.find("6 of 6"), std::string::npos) << made.out;
    EXPECT_EQ(readAll(gains), run(arguments()).out);

    const ProgramResult features = run({"features", m_press, "--rows", "2", "--columns", "3", "--pitch-mm",
                                        "10", "--tare", m_empty, "--gains", gains});
    ASSERT_EQ(features.exitCode, 0) << features.err;
    const auto rows = splitCsv(features.out);
    // An even load of 10 x 2 a taxel: its force as before, its centre in the middle.
    EXPECT_NEAR(std::stod(rows[1][2]), 120.0, 1e-4);
    EXPECT_NEAR(std::stod(rows[1][3]), 0.0, 1e-9);
    EXPECT_NEAR(std::stod(rows[1][4]), 0.0, 1e-9);
    const ProgramResult raw =
        run({"features", m_press, "--rows", "2", "--columns", "3", "--pitch-mm", "10", "--tare", m_empty});
    EXPECT_GT(std::abs(std::stod(splitCsv(raw.out)[1][3])), 1e-3);
}

TEST_F(GainsCommand, printsOneDocumentAsJson) {
    const ProgramResult result = run(arguments({"--json", "--out", m_folder.path("gains.csv")}));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json document = ordered_json::parse(result.out);
    EXPECT_EQ(document["presses"], 1);
    EXPECT_EQ(document["frames"], 40);
    EXPECT_EQ(document["good"], 6);
    EXPECT_NEAR(document["level"].get<double>(), 24.0, 1e-9);
    EXPECT_NEAR(document["greatest_gain"].get<double>(), 2.0, 1e-9);
    EXPECT_EQ(document["taxels"].size(), 6U);
    EXPECT_EQ(document["taxels"][4]["column"], 1);
    EXPECT_FALSE(readAll(m_folder.path("gains.csv")).empty());
}

TEST_F(GainsCommand, namesTheTaxelsThatAreNotUsed) {
    const ProgramResult result = run(arguments({"--dead", "2"}));
    ASSERT_EQ(result.exitCode, 0);
    EXPECT_NE(result.err.find("2 (dead)"), std::string::npos) << result.err;
    EXPECT_EQ(splitCsv(result.out)[3][3], "NA");
}

TEST_F(GainsCommand, takesSeveralPresses) {
    const ProgramResult result =
        run({"gains", m_press, m_press, "--rows", "2", "--columns", "3", "--tare", m_empty, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(ordered_json::parse(result.out)["presses"], 2);
}

TEST_F(GainsCommand, refusesWhatIsNoPress) {
    const ProgramResult unloaded =
        run({"gains", m_empty, "--rows", "2", "--columns", "3", "--tare", m_empty});
    EXPECT_EQ(unloaded.exitCode, 1);
    EXPECT_NE(unloaded.err.find("at least 20"), std::string::npos) << unloaded.err;
    EXPECT_EQ(run({"gains", m_press}).exitCode, 3) << "84 taxels";
    EXPECT_EQ(run(arguments({"--out", m_press})).exitCode, 2) << "it would be replaced";
    EXPECT_EQ(run(arguments({"--dead", "6"})).exitCode, 2);
    EXPECT_EQ(run({"gains"}).exitCode, 2);
}

TEST_F(GainsCommand, aBadGainFileIsShownWithItsPlace) {
    const std::string gains = m_folder.write("gains.csv", "taxel,row,column,gain\n0,0,0,1\n1,0,1,high\n");
    for (const std::string command : {"features", "contacts"}) {
        const ProgramResult result =
            run({command, m_press, "--rows", "2", "--columns", "3", "--gains", gains});
        EXPECT_EQ(result.exitCode, 3);
        EXPECT_NE(result.err.find("gains.csv:3:7"), std::string::npos) << result.err;
    }
}

TEST(EvenLoad, theGainsOfTheShippedSceneAreFoundFromItsRecording) {
    const TemporaryFolder folder;
    const std::string out = folder.path("run");
    const ProgramResult simulated = run({"simulate", "tactile-even-load", "--out", out, "--json"});
    ASSERT_EQ(simulated.exitCode, 0) << simulated.err;
    const ordered_json measures = ordered_json::parse(simulated.out)["measures"];
    // Some 1000 frames with a noise of 2 % of the load.
    EXPECT_LT(measures["taxel_gain_error_rms"].get<double>(), 0.002);
    const ProgramResult gains = run({"gains", out + "/frames.csv", "--json"});
    ASSERT_EQ(gains.exitCode, 0) << gains.err;
    const ordered_json document = ordered_json::parse(gains.out);
    EXPECT_EQ(document["good"], 84);
    EXPECT_FALSE(document["tilted"].get<bool>());
}
