// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

class ExportCommand : public testing::Test {
protected:
    std::string simulated(const std::string& scene, const std::string& duration_s) {
        const ProgramResult result =
            run({"simulate", scene, "--duration", duration_s, "--out", m_folder.path("run")});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return m_folder.path("run/recording.teleta");
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(ExportCommand, aSimulatedArraysRecordingIsExportedAsTheSceneWroteItsFrames) {
    const std::string recording = simulated("tactile-indenter", "2");
    const ProgramResult result = run({"export", recording, "--csv", m_folder.path("csv"), "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string frames = readAll(m_folder.path("csv/frames.csv"));
    EXPECT_FALSE(frames.empty());
    EXPECT_EQ(frames, readAll(m_folder.path("run/frames.csv")));
    const ordered_json document = ordered_json::parse(result.out);
    EXPECT_EQ(document["scene"], "tactile-indenter");
    EXPECT_EQ(document["complete"], true);
    EXPECT_EQ(document["files"][0]["rows"], splitCsv(frames).size() - 1);
    EXPECT_EQ(document["files"][0]["damaged_blocks"], 0);
}

TEST_F(ExportCommand, aSimulatedArmsJointsAreReadAsAStiffnessLogAsTheyAre) {
    const std::string recording = simulated("teleta-touch", "7");
    ASSERT_EQ(run({"export", recording, "--csv", m_folder.path("csv")}).exitCode, 0);
    const auto frames = splitCsv(readAll(m_folder.path("csv/frames.csv")));
    const auto written = splitCsv(readAll(m_folder.path("run/frames.csv")));
    ASSERT_EQ(frames.size(), written.size());
    for (std::size_t i = 1; i < frames.size(); ++i) {
        ASSERT_NEAR(std::stod(frames[i][0]), std::stod(written[i][0]), 1e-9); // the clock's nanoseconds
        ASSERT_TRUE(std::equal(frames[i].begin() + 1, frames[i].end(), written[i].begin() + 1))
            << "row " << i;
    }
    // The sponge of the scene: 282 N/m.
    const ProgramResult result =
        run({"stiffness", m_folder.path("csv/joints.csv"), "--contact-distance", "0.17", "--link-stiffness",
             std::to_string(3468.6 * 0.175 * 0.175 / (0.17 * 0.17)), "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NEAR(ordered_json::parse(result.out)["object_stiffness_n_per_m"].get<double>(), 282.0,
                0.05 * 282.0);
    const auto touches = splitCsv(readAll(m_folder.path("csv/touches.csv")));
    ASSERT_EQ(touches.size(), 2U);
    const auto estimated = splitCsv(readAll(m_folder.path("run/touches.csv")));
    EXPECT_EQ(touches[1][3], estimated[1][3]) << "contact_distance_m";
    EXPECT_EQ(touches[1][11], estimated[1][17]) << "object_stiffness_n_per_m";
}

TEST_F(ExportCommand, theFilesOfASceneAreNotWrittenOverByThoseOfItsRecording) {
    const std::string recording = simulated("tactile-indenter", "0.1");
    const std::string frames = readAll(m_folder.path("run/frames.csv"));
    const ProgramResult refused = run({"export", recording, "--csv", m_folder.path("run")});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.err.find("frames.csv"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("run/events.csv")));
    EXPECT_EQ(run({"export", recording, "--csv", m_folder.path("run"), "--force"}).exitCode, 0);
}

TEST_F(ExportCommand, whatIsNoRecordingIsABadInput) {
    const std::string text = m_folder.write("frames.csv", "time_s,t0\n0,1\n");
    const ProgramResult result = run({"export", text, "--csv", m_folder.path("csv")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("not a recording"), std::string::npos) << result.err;
    EXPECT_EQ(run({"export", m_folder.path("none.teleta"), "--csv", m_folder.path("csv")}).exitCode, 3);
    EXPECT_EQ(run({"export", text}).exitCode, 2);
}

TEST_F(ExportCommand, aFolderThatCannotBeMadeIsAFailure) {
    const std::string recording = simulated("tactile-indenter", "0.1");
    m_folder.write("csv", "a file stands in the way");
    EXPECT_EQ(run({"export", recording, "--csv", m_folder.path("csv")}).exitCode, 1);
}

TEST_F(ExportCommand, framesOfAFileBecomeARecordingThatReplaysAsTheFeaturesOfTheFile) {
    simulated("tactile-indenter", "2");
    const std::string frames = m_folder.path("run/frames.csv");
    const std::string made = m_folder.path("made.teleta");
    const std::vector<std::string> options{"--tare", "median", "--threshold", "0.3"};
    std::vector<std::string> arguments{"import", frames, "--out", made, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json report = ordered_json::parse(result.out);
    EXPECT_EQ(report["frames"], splitCsv(readAll(frames)).size() - 1);
    EXPECT_EQ(report["recording"], made);

    std::vector<std::string> features{"features", frames, "--out", m_folder.path("features.csv")};
    features.insert(features.end(), options.begin(), options.end());
    ASSERT_EQ(run(features).exitCode, 0);
    ASSERT_EQ(run({"replay", made, "--out", m_folder.path("replay.csv")}).exitCode, 0);
    const auto expected = splitCsv(readAll(m_folder.path("features.csv")));
    const auto replayed = splitCsv(readAll(m_folder.path("replay.csv")));
    ASSERT_EQ(replayed.size(), expected.size());
    ASSERT_EQ(replayed[0], expected[0]);
    for (std::size_t row = 1; row < expected.size(); ++row)
        for (std::size_t column = 1; column < expected[row].size(); ++column)
            ASSERT_EQ(replayed[row][column], expected[row][column]) << row << " " << expected[0][column];
}

TEST_F(ExportCommand, whatAFileOfFramesLeavesOpenIsAskedFor) {
    std::ofstream(m_folder.path("bare.csv")) << "a,b,c\n1,2,3\n4,5,6\n";
    const std::vector<std::string> bare{"import", m_folder.path("bare.csv"), "--out",
                                        m_folder.path("made.teleta")};
    const ProgramResult without = run(bare);
    EXPECT_NE(without.exitCode, 0);
    EXPECT_NE(without.err.find("--columns"), std::string::npos) << without.err;
    std::vector<std::string> with = bare;
    for (const char* option : {"--columns", "1..3", "--rows", "1", "--rate", "50", "--json"})
        with.emplace_back(option);
    const ProgramResult result = run(with);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NEAR(ordered_json::parse(result.out)["rate_hz"].get<double>(), 50.0, 1e-9);
    std::vector<std::string> topic = bare;
    topic.insert(topic.end(), {"--topic", "/skin=array"});
    const ProgramResult refused = run(topic);
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_NE(refused.err.find("--topic"), std::string::npos) << refused.err;
}

TEST_F(ExportCommand, optionsForFramesAreRefusedForMessages) {
    const std::string recording = simulated("tactile-indenter", "1");
    ASSERT_EQ(run({"export", recording, "--mcap", m_folder.path("run.mcap")}).exitCode, 0);
    const ProgramResult refused =
        run({"import", m_folder.path("run.mcap"), "--rate", "50", "--out", m_folder.path("made.teleta")});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_NE(refused.err.find("--rate"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("made.teleta")));
}
