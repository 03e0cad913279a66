// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <thread>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

const std::string kScenes = TELETA_SOURCE_DIR "/resources/scenes/";

ordered_json withoutComputingTimes(ordered_json summary) {
    summary.erase("wall_s");
    for (ordered_json& effect : summary["effects"])
        effect.erase("time_s");
    summary.erase("parts");
    return summary;
}

class SimulateCommand : public testing::Test {
protected:
    ordered_json simulate(const std::string& scene, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {"simulate", kScenes + scene, "--json"});
        const ProgramResult result = run(options);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return ordered_json::parse(result.out, nullptr, false);
    }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(SimulateCommand, knowsTheScenesOfTheProgramByName) {
    const ProgramResult list = run({"simulate", "--list", "--json"});
    ASSERT_EQ(list.exitCode, 0) << list.err;
    EXPECT_TRUE(std::ranges::any_of(ordered_json::parse(list.out), [](const ordered_json& scene) {
        return scene["id"] == "tactile-indenter";
    }));
    EXPECT_EQ(run({"simulate"}).exitCode, 2);
    const ProgramResult byName = run({"simulate", "tactile-indenter", "--duration", "0.1", "--json"});
    ASSERT_EQ(byName.exitCode, 0) << byName.err;
    EXPECT_EQ(ordered_json::parse(byName.out)["measures"],
              simulate("tactile-indenter.toml", {"--duration", "0.1"})["measures"]);
    EXPECT_EQ(ordered_json::parse(byName.out)["scene"], "tactile-indenter");
}

TEST_F(SimulateCommand, findsASceneByItsNameBesideTheFolderOfItsResults) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(m_folder.path(""));
    const std::vector<std::string> once{"simulate", "tactile-indenter", "--duration", "0.1",
                                        "--out",    "tactile-indenter"};
    const int first = run(once).exitCode;
    const ProgramResult second = run(once);
    std::filesystem::current_path(before);
    EXPECT_EQ(first, 0);
    EXPECT_EQ(second.exitCode, 0) << second.err;
}

TEST_F(SimulateCommand, leavesOutOneEffectAtATimeAndTellsWhatMoves) {
    const ordered_json rows =
        simulate("tactile-indenter.toml", {"--ablate", "--seeds", "2", "--duration", "3"});
    ASSERT_TRUE(rows.is_array());
    for (const char* effect : {"crosstalk", "noise"})
        EXPECT_TRUE(std::ranges::any_of(rows, [&](const ordered_json& row) {
            return row["effect"] == effect && row["measure"] == "contact_error_mean_m";
        })) << effect;
    for (const ordered_json& row : rows) {
        EXPECT_NE(row["measure"], "frames") << "what no effect changes is left out";
        EXPECT_TRUE(row["moves"] == "yes" || row["moves"] == "no") << "two seeds have no significant spread";
        EXPECT_GT(row["run_s"].get<double>(), 0.0);
    }

    const std::string file = m_folder.path("ablation.csv");
    const ProgramResult written = run({"simulate", kScenes + "tactile-indenter.toml", "--ablate", "--seeds",
                                       "2", "--duration", "0.5", "--out", file});
    ASSERT_EQ(written.exitCode, 0) << written.err;
    EXPECT_EQ(readAll(file).substr(0, 30), "effect,measure,mean,spread_wit");
    EXPECT_EQ(run({"simulate", kScenes + "tactile-indenter.toml", "--seeds", "3"}).exitCode, 2);
    EXPECT_EQ(run({"simulate", kScenes + "tactile-indenter.toml", "--ablate", "--seeds", "1"}).exitCode, 2);
}

TEST_F(SimulateCommand, drawsServoRunsInOneChart) {
    const std::string first = m_folder.path("first");
    const std::string second = m_folder.path("second");
    simulate("servo-point.toml", {"--duration", "3", "--out", first});
    simulate("servo-point.toml",
             {"--duration", "3", "--seed", "2", "--out", second, "--figures", "svg,png", "--compare", first});
    const std::string svg = readAll(second + "/servo.svg");
    EXPECT_NE(svg.find(">first<"), std::string::npos);
    EXPECT_NE(svg.find(">second<"), std::string::npos);
    EXPECT_EQ(readAll(second + "/servo.png").substr(1, 3), "PNG");
    EXPECT_EQ(run({"simulate", kScenes + "tactile-indenter.toml", "--duration", "0.1", "--out", second,
                   "--figures", "svg"})
                  .exitCode,
              2);
    EXPECT_EQ(run({"simulate", kScenes + "servo-point.toml", "--figures", "svg"}).exitCode, 2)
        << "there is no folder for it";
    // An option of a list does not take the scene for one more of it.
    EXPECT_EQ(
        run({"simulate", "--duration", "3", "--out", second, "--figures", "svg", "servo-point"}).exitCode, 0);
    const std::vector<std::string> ablation{"simulate", "servo-point", "--ablate", "--out",
                                            second,     "--figures",   "svg"};
    EXPECT_EQ(run(ablation).exitCode, 2);
}

TEST_F(SimulateCommand, endsWithExitCodeOneWhenAServoDoesNotDoItsTask) {
    // It has not come down yet.
    const std::string folder = m_folder.path("short");
    const ProgramResult result = run({"simulate", "servo-point", "--duration", "0.3", "--out", folder});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.out.find("not completed: never in contact, in the phase free_motion"), std::string::npos)
        << result.out;
    EXPECT_NE(result.err.find("expect = \"not_completed\""), std::string::npos) << result.err;
    const ordered_json verdict = ordered_json::parse(readAll(folder + "/summary.json"))["verdict"];
    EXPECT_EQ(verdict, (ordered_json{{"result", "not_completed"},
                                     {"phase", "free_motion"},
                                     {"reason", "never_in_contact"},
                                     {"expected", false}}));
    std::string text = readAll(kScenes + "servo-point.toml");
    const std::string task = "[task]\n";
    text.insert(text.find(task) + task.size(), "expect = \"not_completed\"\n");
    const std::string scene = m_folder.write("scene.toml", text);
    EXPECT_EQ(run({"simulate", scene, "--duration", "0.3"}).exitCode, 0);
    const ProgramResult completed = run({"simulate", scene, "--duration", "3", "--json"});
    EXPECT_EQ(completed.exitCode, 0) << completed.err;
    EXPECT_EQ(ordered_json::parse(completed.out)["verdict"], (ordered_json{{"result", "completed"}}));
}

TEST_F(SimulateCommand, looksAtTheRunsToCompareBeforeItRuns) {
    const ProgramResult result = run({"simulate", "servo-point", "--out", m_folder.path("run"), "--figures",
                                      "svg", "--compare", m_folder.path("none")});
    EXPECT_EQ(result.exitCode, 3) << result.err;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("run/servo.csv")));
}

TEST_F(SimulateCommand, keepsTheEarlierRecordingUntilTheNewOneIsComplete) {
    const std::string recording = m_folder.path("run/recording.teleta");
    simulate("tactile-indenter.toml", {"--duration", "1", "--out", m_folder.path("run")});
    const std::string earlier = readAll(recording);
    RunningProgram program(
        {"simulate", "tactile-indenter", "--duration", "100000", "--out", m_folder.path("run")});
    // Some frames of it are safe on the disk when the log has grown.
    constexpr std::uintmax_t kSome = 200'000;
    std::error_code none;
    const auto logSize = [&] { return std::filesystem::file_size(recording + ".part-wal", none); };
    while ((logSize() < kSome || none) && !program.ended())
        std::this_thread::yield();
    ASSERT_FALSE(program.ended()) << program.wait().err;
    EXPECT_TRUE(readAll(recording) == earlier);
    program.send(SIGINT);
    EXPECT_EQ(program.wait().exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(recording + ".part"));
    EXPECT_FALSE(readAll(recording) == earlier);
    EXPECT_EQ(run({"replay", recording, "--out", m_folder.path("f.csv")}).exitCode, 0);
}

TEST_F(SimulateCommand, runsAStudyAsASceneAndLeavesOutItsEffects) {
    const ordered_json list = ordered_json::parse(run({"simulate", "--list", "--json"}).out);
    EXPECT_TRUE(std::ranges::any_of(
        list, [](const ordered_json& scene) { return scene["id"] == "study-rehearsal"; }));
    const ProgramResult byName = run({"simulate", "study-rehearsal", "--duration", "60", "--json"});
    ASSERT_EQ(byName.exitCode, 0) << byName.err;
    const ordered_json summary = ordered_json::parse(byName.out);
    EXPECT_EQ(summary["scene"], "study-rehearsal");
    EXPECT_GE(summary["simulated_s"].get<double>(), 60.0);
    EXPECT_GT(summary["measures"]["patterns_sent"].get<int>(), 0);

    const ordered_json rows =
        simulate("study-rehearsal.toml", {"--ablate", "--seeds", "2", "--duration", "60"});
    ASSERT_TRUE(rows.is_array());
    EXPECT_TRUE(std::ranges::any_of(rows, [](const ordered_json& row) {
        return row["effect"] == "motor_lag" && row["measure"] == "felt_onset_p50_s" && row["moves"] == "yes";
    }));
}

TEST_F(SimulateCommand, sharesTheTimeOfAServoBetweenItsParts) {
    const ordered_json parts = simulate("servo-point.toml", {"--duration", "3"})["parts"];
    ASSERT_EQ(parts.size(), 5U);
    const char* names[]{"contact", "kinematics", "features", "control", "dynamics"};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(parts[i]["name"], names[i]);
        EXPECT_GT(parts[i]["time_s"].get<double>(), 0.0) << names[i];
    }
}

TEST_F(SimulateCommand, writesTheSummaryThatItPrintsAndTheFrames) {
    const std::string folder = m_folder.path("runs/first");
    const ordered_json printed = simulate("tactile-indenter.toml", {"--duration", "2", "--out", folder});
    EXPECT_EQ(ordered_json::parse(readAll(folder + "/summary.json")), printed);
    EXPECT_EQ(printed["scene"], "tactile-indenter");
    EXPECT_EQ(printed["simulated_s"], 2.0);
    EXPECT_EQ(printed["seed"], 1);
    EXPECT_EQ(printed["measures"]["frames"], 400);
    EXPECT_EQ(printed["measures"]["frames_lost"], 0);

    const auto rows = splitCsv(readAll(folder + "/frames.csv"));
    ASSERT_EQ(rows.size(), 401U);
    EXPECT_EQ(rows[0].size(), 85U);
    EXPECT_EQ(rows[0][84], "t83");
    EXPECT_EQ(rows[400][0], "2");
}

TEST_F(SimulateCommand, findsTheContactsOfTheIndentersWithinAFractionOfATaxel) {
    // Taxels of 3.4 mm; the ball touches at the scene's keyframe of depth 0 at 0.8 s.
    const ordered_json measures = simulate("tactile-indenter.toml")["measures"];
    EXPECT_LT(measures["contact_error_mean_m"].get<double>(), 0.0005);
    EXPECT_LE(measures["contact_error_mean_m"], measures["contact_error_p95_m"]);
    EXPECT_GT(measures["first_contact_s"].get<double>(), 0.8);
    EXPECT_LT(measures["first_contact_s"].get<double>(), 1.0);
}

TEST_F(SimulateCommand, listsTheEffectsThatTheSceneLists) {
    const ordered_json summary = simulate("tactile-two-contacts.toml", {"--duration", "0.1"});
    std::vector<std::string> names;
    for (const ordered_json& effect : summary["effects"])
        names.push_back(effect["name"]);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"crosstalk", "dead_taxels", "noise"}));
}

TEST_F(SimulateCommand, givesTheSameBytesForTheSameSeedAndOthersForAnother) {
    const auto frames = [&](const std::string& seed, const std::string& name) {
        const ordered_json summary = simulate(
            "tactile-two-contacts.toml", {"--duration", "2", "--seed", seed, "--out", m_folder.path(name)});
        return std::pair(withoutComputingTimes(summary), readAll(m_folder.path(name + "/frames.csv")));
    };
    const auto first = frames("7", "a");
    EXPECT_EQ(frames("7", "b"), first);
    EXPECT_NE(frames("8", "c").second, first.second);
}

TEST_F(SimulateCommand, makesFramesThatTheOtherCommandsRead) {
    const std::string folder = m_folder.path("run");
    simulate("tactile-indenter.toml", {"--duration", "1.7", "--out", folder});
    const ProgramResult result = run({"features", folder + "/frames.csv"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto rows = splitCsv(result.out);
    ASSERT_EQ(rows.size(), 341U);
    EXPECT_EQ(rows[1][1], "none");
    EXPECT_EQ(rows[340][1], "point");
}

TEST_F(SimulateCommand, printsATableForPeople) {
    const ProgramResult result = run({"simulate", kScenes + "tactile-indenter.toml", "--duration", "0.5"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("Simulated"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("frames"), std::string::npos);
    EXPECT_NE(result.out.find("NA"), std::string::npos) << "no contact yet: errors are not defined";
}

TEST_F(SimulateCommand, completesItsFilesWhenItIsInterrupted) {
    teleta::test::RunningProgram program({"simulate", kScenes + "tactile-indenter.toml", "--duration", "1e6",
                                          "--json", "--out", m_folder.path("run")});
    while (!program.hasWritten("time_s,t0") && !program.ended()) {
    }
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1) << result.err;
    const ordered_json summary = ordered_json::parse(readAll(m_folder.path("run/summary.json")));
    const auto rows = splitCsv(readAll(m_folder.path("run/frames.csv")));
    EXPECT_EQ(rows.size() - 1, summary["measures"]["frames"].get<std::size_t>());
    EXPECT_LT(summary["simulated_s"].get<double>(), 1e6);
}

TEST_F(SimulateCommand, refusesAMissingSceneAWrongOneAndAFolderThatCannotBeMade) {
    const ProgramResult unknown = run({"simulate", "no-such-scene"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_NE(unknown.err.find("teleta simulate --list"), std::string::npos) << unknown.err;
    EXPECT_EQ(run({"simulate", m_folder.path("none.toml")}).exitCode, 3);

    const std::string wrong = m_folder.write("wrong.toml", "name = \"x\"\nduration_s = -1\n");
    const ProgramResult refused = run({"simulate", wrong});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.err.find("wrong.toml:2:"), std::string::npos) << refused.err;

    const std::string file = m_folder.write("file", "");
    const ProgramResult blocked =
        run({"simulate", kScenes + "tactile-indenter.toml", "--duration", "0.1", "--out", file + "/run"});
    EXPECT_EQ(blocked.exitCode, 1);
    EXPECT_NE(blocked.err.find("file/run"), std::string::npos) << blocked.err;

    EXPECT_EQ(run({"simulate", kScenes + "tactile-indenter.toml", "--duration", "0"}).exitCode, 2);
    for (const std::string seed : {"-1", "18446744073709551616", "1e3", "x"}) {
        const ProgramResult result = run({"simulate", kScenes + "tactile-indenter.toml", "--seed", seed});
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_NE(result.err.find(seed + " is given, a whole number from 0 to 18446744073709551615"),
                  std::string::npos)
            << result.err;
    }
}

TEST_F(SimulateCommand, measuresTheFiveMaterialsOfTheTouchScene) {
    // The stiffness of the paper's objects (Table 2), within 5 % up to rubber and 10 % for wood.
    const std::string folder = m_folder.path("touch");
    const ordered_json measures = simulate("teleta-touch.toml", {"--out", folder})["measures"];
    EXPECT_EQ(measures["material"].dump(), R"(["sponge","rubber_sponge","rubber","wood","metal"])");
    const ordered_json& estimated = measures["estimated_stiffness_n_per_m"];
    ASSERT_EQ(estimated.size(), 5U);
    EXPECT_NEAR(estimated[0].get<double>(), 282.0, 0.05 * 282.0);
    EXPECT_NEAR(estimated[1].get<double>(), 1325.9, 0.05 * 1325.9);
    EXPECT_NEAR(estimated[2].get<double>(), 7223.9, 0.05 * 7223.9);
    EXPECT_NEAR(estimated[3].get<double>(), 8562.9, 0.10 * 8562.9);
    EXPECT_TRUE(estimated[4].is_null()) << "rigid: only a bound";
    EXPECT_LT(measures["contact_error_p95_m"].get<double>(), 0.0034) << "the resolution of the paper's skin";

    EXPECT_EQ(splitCsv(readAll(folder + "/joints.csv")).size(), 40'001U);
    EXPECT_EQ(splitCsv(readAll(folder + "/touches.csv")).size(), 6U);
    EXPECT_EQ(splitCsv(readAll(folder + "/contour.csv")).size(), 6U);
}

TEST_F(SimulateCommand, writesJointsThatTheStiffnessCommandReads) {
    // The elbow's columns of the first touch under the names of `teleta stiffness`, cut before the second
    // one.
    const std::string folder = m_folder.path("touch");
    simulate("teleta-touch.toml", {"--duration", "7", "--out", folder});
    std::string log = "time_s,joint_angle_rad,joint_torque_nm\n";
    const auto rows = splitCsv(readAll(folder + "/joints.csv"));
    for (std::size_t i = 1; i < rows.size(); ++i)
        log += rows[i][0] + "," + rows[i][4] + "," + rows[i][8] + "\n";
    const ProgramResult result =
        run({"stiffness", m_folder.write("log.csv", log), "--contact-distance", "0.17", "--link-stiffness",
             std::to_string(3468.6 * 0.175 * 0.175 / (0.17 * 0.17)), "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NEAR(ordered_json::parse(result.out)["object_stiffness_n_per_m"].get<double>(), 282.0,
                0.05 * 282.0);
}
