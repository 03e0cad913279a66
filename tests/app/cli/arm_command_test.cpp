// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

const std::string kGripper = TELETA_SOURCE_DIR "/tests/data/urdf/gripper.urdf";

} // namespace

TEST(ArmCommand, showsChainLimitsAndMass) {
    const auto result = run({"arm", "show", kGripper});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.out.find("2 joints from base_link to tool0"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("-3 .. 3 rad"), std::string::npos);
    EXPECT_NE(result.out.find("3 rad/s"), std::string::npos);
    EXPECT_NE(result.out.find("shown, not moved"), std::string::npos);
    EXPECT_NE(result.out.find("follows left"), std::string::npos);
    EXPECT_NE(result.out.find("3.2 kg"), std::string::npos);
}

TEST(ArmCommand, writesTheSameAsJson) {
    const auto result = run({"arm", "show", kGripper, "--tip", "finger_right", "--base", "tool0", "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const nlohmann::json document = nlohmann::json::parse(result.out);
    EXPECT_EQ(document["tip"], "finger_right");
    ASSERT_EQ(document["joints"].size(), 1U);
    EXPECT_EQ(document["joints"][0]["name"], "left");
    EXPECT_EQ(document["joints"][0]["unit"], "m");
    EXPECT_EQ(document["joints"][0]["highest"], 0.05);
    EXPECT_EQ(document["mimics"][0]["follows"], "left");
    EXPECT_DOUBLE_EQ(document["moved_mass_kg"].get<double>(), 0.2);
}

TEST(ArmCommand, knowsTheArmsThatComeWithTheProgram) {
    for (const auto& [name, joints] : {std::pair{"four-joints", 4U}, std::pair{"seven-joints", 7U}}) {
        const auto result = run({"arm", "show", name, "--json"});
        EXPECT_EQ(result.exitCode, 0) << result.err;
        const nlohmann::json document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["joints"].size(), joints);
        EXPECT_EQ(document["tip"], "tool0");
        EXPECT_FALSE(document["moved_mass_kg"].is_null());
    }
}

TEST(ArmCommand, namesThePlaceOfWhatIsWrong) {
    const TemporaryFolder folder;
    std::ofstream(folder.path("bad.urdf")) << "<robot name='r'>\n<link name='a'>\n</robot>\n";
    const auto result = run({"arm", "show", folder.path("bad.urdf")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_NE(result.err.find("bad.urdf:3:"), std::string::npos) << result.err;
    const auto missing = run({"arm", "show", kGripper, "--tip", "tool1"});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.err.find("tool0"), std::string::npos) << missing.err;
    EXPECT_EQ(run({"arm", "show", "no-such-arm"}).exitCode, 3);
}

TEST(ArmCommand, movesNothingWithoutAFileThatIsUnderstoodAndAWord) {
    const TemporaryFolder folder;
    const std::string arm = "kind = \"ros_arm\"\nname = \"Arm\"\nbase_frame = \"base_link\"\n"
                            "tip_frame = \"tool0\"\ncontroller = \"/arm_controller\"\n";
    const auto jog = [](const std::string& file, const char* rate, const char* seconds) {
        return run({"arm", "jog", file, "--joint", "joint_1", "--rate", rate, "--seconds", seconds});
    };
    const std::string bad = folder.write("bad.toml", arm + "speed_scale = 2\n");
    for (const auto& result : {jog(bad, "0.1", "1"), run({"ros", "check", bad})}) {
        EXPECT_EQ(result.exitCode, 3);
        EXPECT_NE(result.err.find("bad.toml:6:1: unknown key"), std::string::npos) << result.err;
    }
    EXPECT_EQ(jog(folder.path("none.toml"), "0.1", "1").exitCode, 3);
    const std::string good = folder.write("good.toml", arm);
    const auto unasked = jog(good, "0.1", "1");
    EXPECT_EQ(unasked.exitCode, 2);
    EXPECT_NE(unasked.err.find("--yes"), std::string::npos) << unasked.err;
    for (const auto& [rate, seconds] : {std::pair{"0", "1"}, {"nan", "1"}, {"0.1", "0"}, {"0.1", "2.01"}})
        EXPECT_EQ(jog(good, rate, seconds).exitCode, 2) << rate << ' ' << seconds;
}
