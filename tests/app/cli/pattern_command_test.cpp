// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

using nlohmann::ordered_json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

TEST(PatternCommand, listsThe22StimuliWithTheKeysOfTheFormat) {
    const ProgramResult result = run({"pattern", "list", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json all = ordered_json::parse(result.out, nullptr, false);
    ASSERT_EQ(all.size(), 22U);
    std::set<std::string> ids;
    for (const ordered_json& entry : all) {
        std::vector<std::string> keys;
        for (const auto& [key, value] : entry.items())
            keys.push_back(key);
        EXPECT_EQ(keys, (std::vector<std::string>{"id", "name", "task", "condition", "duration_s"}));
        ids.insert(entry["id"]);
    }
    EXPECT_EQ(ids.size(), 22U);
    EXPECT_TRUE(ids.contains("stiffness.E.dynamic"));
    const ProgramResult table = run({"pattern", "list"});
    EXPECT_EQ(table.exitCode, 0);
    for (const std::string& id : ids)
        EXPECT_NE(table.out.find(id), std::string::npos);
}

TEST(PatternCommand, rendersTheRampOfThePointShape) {
    const ProgramResult result = run({"pattern", "render", "shape.F.dynamic", "--rate", "4"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out,
              "time_s,t1,t2,t3,t4,t5,t6\n0,0,0,0,0,0,0\n0.25,0.125,0,0,0,0,0\n0.5,0.25,0,0,0,0,0\n"
              "0.75,0.375,0,0,0,0,0\n1,0.5,0,0,0,0,0\n1.25,0.625,0,0,0,0,0\n1.5,0.75,0,0,0,0,0\n"
              "1.75,0.875,0,0,0,0,0\n");
}

TEST(PatternCommand, rendersIntoAFileAndConvertsToTheSameRows) {
    const TemporaryFolder folder;
    const std::string rendered = folder.path("a.csv");
    const std::string converted = folder.path("b.csv");
    ASSERT_EQ(run({"pattern", "render", "shape.A.dynamic", "--rate", "200", "--csv", rendered}).exitCode, 0);
    ASSERT_EQ(run({"pattern", "convert", "shape.A.dynamic", converted}).exitCode, 0);
    EXPECT_EQ(readAll(rendered), readAll(converted));
    EXPECT_EQ(splitCsv(readAll(rendered)).size(), 401U);
}

TEST(PatternCommand, tellsWhatItConvertedAsJson) {
    const TemporaryFolder folder;
    const std::string out = folder.path("b.hjif");
    const ProgramResult result = run({"pattern", "convert", "shape.A.static", out, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(ordered_json::parse(result.out, nullptr, false),
              ordered_json({{"id", "shape.A.static"},
                            {"out", out},
                            {"lost_at_reading", ordered_json::array()},
                            {"lost_at_writing", ordered_json::array()}}));
}

TEST(PatternCommand, convertsWithARateAndWithWhatTheMotorsWillDo) {
    const TemporaryFolder folder;
    const std::string rendered = folder.path("a.csv");
    const std::string converted = folder.path("b.csv");
    const std::string wav = folder.path("c.wav");
    ASSERT_EQ(run({"pattern", "render", "shape.F.static", "--rate", "50", "--predicted", "--csv", rendered})
                  .exitCode,
              0);
    ASSERT_EQ(
        run({"pattern", "convert", "shape.F.static", converted, "--rate", "50", "--predicted"}).exitCode, 0);
    EXPECT_EQ(readAll(rendered), readAll(converted));
    ASSERT_EQ(run({"pattern", "convert", "shape.F.static", wav, "--rate", "1000"}).exitCode, 0);
    EXPECT_EQ(readAll(wav).size(), 68U + 2000U * 12U);
    EXPECT_EQ(run({"pattern", "convert", "shape.F.static", wav, "--rate", "0.5"}).exitCode, 1);
    const ProgramResult noSamples =
        run({"pattern", "convert", "shape.F.static", folder.path("d.json"), "--rate", "50"});
    EXPECT_EQ(noSamples.exitCode, 2);
    EXPECT_NE(noSamples.err.find("--rate"), std::string::npos);
}

TEST(PatternCommand, saysWhatAFileOfAnotherProgramLoses) {
    const TemporaryFolder folder;
    const std::string ahap = folder.write("tap.ahap", R"({"Version": 1.0, "Pattern": [{"Event": {"Time": 0.5,
        "EventType": "HapticTransient", "EventParameters": [
        {"ParameterID": "HapticSharpness", "ParameterValue": 1.0}]}}]})");
    const std::string out = folder.path("tap.tact");
    const ProgramResult plain = run({"pattern", "convert", ahap, folder.path("tap.json")});
    ASSERT_EQ(plain.exitCode, 0) << plain.err;
    EXPECT_NE(plain.err.find("tap.ahap: Short pulses"), std::string::npos) << plain.err;
    const ProgramResult json = run({"pattern", "convert", ahap, out, "--tactors", "2,5", "--json"});
    ASSERT_EQ(json.exitCode, 0) << json.err;
    const ordered_json lost = ordered_json::parse(json.out, nullptr, false)["lost_at_reading"];
    ASSERT_EQ(lost.size(), 3U) << json.out;
    EXPECT_EQ(lost[0]["kind"], "frequency");
    EXPECT_EQ(lost[1]["kind"], "burst");
    EXPECT_EQ(lost[1]["first_s"], 0.5);
    EXPECT_EQ(lost[2]["kind"], "one-signal");
    const auto rows = splitCsv(run({"pattern", "render", out, "--rate", "100"}).out);
    ASSERT_EQ(rows.size(), 56U);
    EXPECT_EQ(rows[53], (std::vector<std::string>{"0.52", "0", "1", "0", "0", "1", "0"}));
    EXPECT_EQ(run({"pattern", "convert", ahap, out, "--tactors", "7"}).exitCode, 2);
    EXPECT_EQ(run({"pattern", "show", "shape.A.static", "--tactors", "1"}).exitCode, 2);
}

TEST(PatternCommand, aWavSaysWhetherItHoldsVibrations) {
    const TemporaryFolder folder;
    const std::string wav = folder.path("a.wav");
    const ProgramResult bare = run({"pattern", "convert", "shape.F.static", wav});
    EXPECT_EQ(bare.exitCode, 0);
    EXPECT_NE(bare.err.find("bare intensities"), std::string::npos) << bare.err;
    const ProgramResult carried = run({"pattern", "convert", "shape.F.static", wav, "--carrier"});
    EXPECT_EQ(carried.exitCode, 0) << carried.err;
    EXPECT_NE(carried.err.find("250 Hz"), std::string::npos) << carried.err;
    EXPECT_EQ(run({"pattern", "convert", "shape.F.static", wav, "--carrier", "5000"}).exitCode, 1);
    EXPECT_EQ(run({"pattern", "convert", "shape.F.static", folder.path("a.csv"), "--carrier"}).exitCode, 2);
}

TEST(PatternCommand, showPrintsAFileThatCanBeReadAgain) {
    const ProgramResult shown = run({"pattern", "show", "shape.B.static", "--json"});
    ASSERT_EQ(shown.exitCode, 0) << shown.err;
    EXPECT_EQ(ordered_json::parse(shown.out, nullptr, false)["id"], "shape.B.static");
    const TemporaryFolder folder;
    const std::string path = folder.write("again.json", shown.out);
    EXPECT_EQ(run({"pattern", "show", path, "--json"}).out, shown.out);
    const ProgramResult table = run({"pattern", "show", path});
    EXPECT_EQ(table.exitCode, 0);
    EXPECT_NE(table.out.find("shape.B.static"), std::string::npos);
}

TEST(PatternCommand, refusesABadFileWithThePlaceAndAWrongCommandLine) {
    const TemporaryFolder folder;
    const std::string path = folder.write("bad.json", "{\n\"format\": \"other\"}");
    const ProgramResult bad = run({"pattern", "show", path});
    EXPECT_EQ(bad.exitCode, 3);
    EXPECT_EQ(bad.out, "");
    EXPECT_NE(bad.err.find("bad.json:2:11: "), std::string::npos) << bad.err;
    EXPECT_EQ(run({"pattern", "render", "nothing"}).exitCode, 3);
    EXPECT_EQ(run({"pattern"}).exitCode, 2);
    EXPECT_EQ(run({"pattern", "dance"}).exitCode, 2);
    EXPECT_EQ(run({"pattern", "render", "shape.A.static", "--rate", "0"}).exitCode, 2);
    EXPECT_EQ(run({"pattern", "convert", "shape.A.static", folder.path("p.txt")}).exitCode, 2);
    EXPECT_EQ(run({"pattern", "convert", "shape.A.static", folder.path("no/p.json")}).exitCode, 1);
}

TEST(PatternCommand, checkNamesTheLawThatARingBreaksAndThePlace) {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("fast.json", R"({"format": "teleta-pattern", "version": 1, "id": "fast", "duration_s": 2,
        "tracks": [[], [], [], [], [], []],
        "objects": [{"type": "ring", "start_s": 0, "duration_s": 2, "turns": 8, "first_tactor": 1}]})");
    const ProgramResult json = run({"pattern", "check", path, "--json"});
    ASSERT_EQ(json.exitCode, 0) << json.err;
    const ordered_json answer = ordered_json::parse(json.out, nullptr, false);
    ASSERT_EQ(answer["findings"].size(), 1U);
    EXPECT_EQ(answer["findings"][0]["law"], "ring-too-fast");
    EXPECT_EQ(answer["findings"][0]["object"], 1);
    EXPECT_EQ(answer["findings"][0]["fixable"], true);
    EXPECT_NE(run({"pattern", "check", path}).out.find("250 ms"), std::string::npos);
    EXPECT_EQ(run({"pattern", "check", "shape.A.dynamic"}).exitCode, 0);
}

TEST(PatternCommand, predictedRowsLagBehindTheCommandedOnes) {
    const auto rows =
        splitCsv(run({"pattern", "render", "shape.F.static", "--rate", "100", "--predicted"}).out);
    ASSERT_EQ(rows.size(), 201U);
    EXPECT_EQ(rows[1][1], "0");
    EXPECT_LT(std::stod(rows[4][1]), 0.9);
    EXPECT_GT(std::stod(rows[100][1]), 0.999);
    EXPECT_EQ(rows[100][2], "0");
}

TEST(PatternCommand, overdriveHelpsTheMotorsUpOnlyWhenItIsAskedFor) {
    const auto rendered = [](const std::vector<std::string>& more) {
        std::vector<std::string> words{"pattern", "render", "stiffness.A.static", "--rate", "100"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramResult result = run(words);
        EXPECT_EQ(result.exitCode, 0) << result.err;
        return splitCsv(result.out);
    };
    const auto plain = rendered({});
    const auto helped = rendered({"--overdrive"});
    ASSERT_EQ(plain.size(), helped.size());
    EXPECT_NE(plain[1][1], "1");
    EXPECT_EQ(helped[1][1], "1");
    EXPECT_NEAR(std::stod(helped[100][1]), std::stod(plain[100][1]), 1e-3);
    // 20 ms after the onset the motors are predicted to be further.
    EXPECT_GT(std::stod(rendered({"--overdrive", "--predicted"})[3][1]),
              std::stod(rendered({"--predicted"})[3][1]) + 0.05);
}

TEST(PatternCommand, convertsBetweenAllFormatsByTheEnding) {
    const TemporaryFolder folder;
    const std::string original = run({"pattern", "render", "shape.E.dynamic", "--rate", "50"}).out;
    for (const std::string name : {"a.json", "a.hjif", "a.haptic.zip"}) {
        const std::string path = folder.path(name);
        const ProgramResult converted = run({"pattern", "convert", "shape.E.dynamic", path});
        EXPECT_EQ(converted.exitCode, 0) << converted.err;
        EXPECT_EQ(run({"pattern", "render", path, "--rate", "50"}).out, original) << name;
    }
    for (const std::string name : {"a.tact", "a.ahap.zip", "a.wav"})
        EXPECT_EQ(run({"pattern", "convert", folder.path("a.json"), folder.path(name)}).exitCode, 0) << name;
    EXPECT_EQ(readAll(folder.path("a.wav")).substr(0, 4), "RIFF");
    EXPECT_EQ(readAll(folder.path("a.ahap.zip")).substr(0, 2), "PK");
    const ProgramResult oneTactor = run({"pattern", "convert", "shape.E.dynamic", folder.path("a.haptic")});
    EXPECT_EQ(oneTactor.exitCode, 1);
    EXPECT_NE(oneTactor.err.find(".haptic.zip"), std::string::npos) << oneTactor.err;
    EXPECT_EQ(run({"pattern", "show", folder.path("a.wav")}).exitCode, 3);
}

namespace {

/// Six motors that follow within 50 ms (first motor: within 200 ms) and start at a fifth of the drive.
std::string motorsFile(const TemporaryFolder& folder, const std::string& bracelet = "simulated") {
    std::string text = "format = \"teleta-motors\"\nversion = 1\nbracelet = \"" + bracelet + "\"\n";
    for (int i = 0; i < 6; ++i)
        text +=
            "[[motor]]\nstart_from = \"recording\"\nlag_from = \"recording\"\nstart_drive = 0.2\nrise_s = " +
            std::string(i == 0 ? "0.2" : "0.05") +
            "\nfall_s = 0.05\ncurve = [{ drive = 0.2, speed_Hz = 50 }, { drive = 1, speed_Hz = 250 }]\n";
    return folder.write("motors.toml", text);
}

} // namespace

// After the rise time a motor has 90 % of its speed: 225 of 250 Hz, that is the intensity (225 - 50) / (250 -
// 50).
TEST(PatternCommand, predictsAndChecksWithTheMotorsOfAFile) {
    const TemporaryFolder folder;
    const std::string motors = motorsFile(folder);
    const ProgramResult result =
        run({"pattern", "render", "stiffness.E.static", "--rate", "20", "--predicted", "--motors", motors});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto rows = splitCsv(result.out);
    ASSERT_GT(rows.size(), 6U);
    EXPECT_EQ(rows[5][0], "0.2");
    EXPECT_NEAR(std::stod(rows[5][1]), 0.875, 1e-6);
    EXPECT_NEAR(std::stod(rows[2][2]), 0.875, 1e-6) << "at 50 ms";

    const auto findings = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"pattern", "check", "shape.A.dynamic", "--json"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramResult checked = run(words);
        EXPECT_EQ(checked.exitCode, 0) << checked.err;
        return ordered_json::parse(checked.out, nullptr, false)["findings"].size();
    };
    EXPECT_LE(findings({}), findings({"--motors", motors})) << "a slower motor breaks no fewer laws";

    const ProgramResult wrong =
        run({"pattern", "check", "shape.A.dynamic", "--motors", folder.write("bad.toml", "format = 3\n")});
    EXPECT_EQ(wrong.exitCode, 3);
    EXPECT_NE(wrong.err.find("bad.toml:1:10"), std::string::npos) << wrong.err;
}

TEST(PatternCommand, playsOnASimulatedBraceletAndTellsHowPunctualItWas) {
    const TemporaryFolder folder;
    const auto play = [motors = motorsFile(folder)] {
        return run({"pattern", "play", "shape.A.static", "--device", "simulated", "--motors", motors,
                    "--measure", "0.3", "--json"});
    };
    ProgramResult result = play();
    // A machine that pauses for a tenth of a second ends it, as it should.
    for (int more = 0; more < 20 && result.err.find("A frame was so late") != std::string::npos; ++more)
        result = play();
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const ordered_json document = ordered_json::parse(result.out, nullptr, false);
    EXPECT_EQ(document["simulated"], true);
    EXPECT_EQ(document["rate_hz"], 200.0);
    EXPECT_GT(document["frames"], 1);
    EXPECT_TRUE(document["deadline_misses"].is_number_unsigned());
    EXPECT_GT(document["write"]["longest_s"], 0.0);
    EXPECT_LE(document["lateness"]["median_s"], document["lateness"]["longest_s"]);
    EXPECT_GT(document["live"]["setpoints"], 0);
    EXPECT_GT(document["live"]["snapshot_to_frame"]["median_s"], 0.0);
}

TEST(PatternCommand, playsWithOverdriveOnASimulatedBracelet) {
    ProgramResult result;
    // As above: a machine that pauses ends it.
    for (int tries = 0;
         tries == 0 || (tries < 20 && result.err.find("A frame was so late") != std::string::npos); ++tries)
        result = run({"pattern", "play", "stiffness.A.static", "--device", "simulated", "--overdrive",
                      "--measure", "0.3", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_GT(ordered_json::parse(result.out, nullptr, false)["frames"], 1);
}

TEST(PatternCommand, doesNotPlayWithTheMotorsOfAnotherBraceletOrOnNone) {
    const TemporaryFolder folder;
    const ProgramResult other = run({"pattern", "play", "shape.A.static", "--device", "simulated", "--motors",
                                     motorsFile(folder, "TB-0042")});
    EXPECT_EQ(other.exitCode, 3);
    EXPECT_NE(other.err.find("TB-0042"), std::string::npos) << other.err;
    const ProgramResult none =
        run({"pattern", "play", "shape.A.static", "--device", folder.path("no-such-driver.toml")});
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_NE(none.err.find("no-such-driver.toml"), std::string::npos) << none.err;
}
