// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

using nlohmann::json;
using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::TemporaryFolder;

namespace {

json reportOf(const std::string& name) {
    std::ifstream file(name + ".json");
    return json::parse(file, nullptr, false);
}

} // namespace

// The bound is long: how punctual this machine is stands in the report, not in a test.
TEST(CertifyCommand, afterEachKindOfFaultTheMotorsAreOffAndNothingIsLost) {
    TemporaryFolder folder;
    const std::string name = folder.path("report");
    std::vector<std::string> kinds{"kill",  "terminate", "interrupt",    "hang_up",
                                   "sleep", "unplug",    "late_answers", "lost_requests",
                                   "lies",  "stop",      "disk_full"};
#ifndef __SANITIZE_ADDRESS__
    kinds.emplace_back("memory_refused"); // the sanitizer reserves more memory than there is
#endif
    std::string list;
    for (const std::string& kind : kinds)
        list += (list.empty() ? "" : ",") + kind;
    const ProgramResult result = run({"certify", "--faults", std::to_string(kinds.size()), "--kinds", list,
                                      "--bound", "2", "--out", name, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err << result.out;
    const json report = json::parse(result.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << result.out;
    EXPECT_EQ(report["passes"], true);
    EXPECT_EQ(report["system"]["simulated"], true);
    EXPECT_EQ(report["total"]["faults"], kinds.size());
    EXPECT_EQ(report["total"]["restarted"], 0);
    EXPECT_EQ(report["total"]["frames_lost"], 0);
    EXPECT_EQ(report["total"]["files_damaged"], 0);
    std::set<std::string> seen;
    for (const json& fault : report["faults"]) {
        seen.insert(fault["kind"]);
        EXPECT_GT(fault["zero_s"], 0.0) << fault;
    }
    EXPECT_EQ(seen, std::set(kinds.begin(), kinds.end()));
    EXPECT_EQ(reportOf(name), report) << "the file says the same";
    EXPECT_GT(std::filesystem::file_size(name + ".html"), 1000U);
}

TEST(CertifyCommand, aBoundThatIsNotKeptIsNotPassed) {
    TemporaryFolder folder;
    const std::string name = folder.path("report");
    const ProgramResult result =
        run({"certify", "--faults", "1", "--kinds", "kill", "--bound", "0.000001", "--out", name});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("The certificate was not passed"), std::string::npos) << result.err;
    EXPECT_EQ(reportOf(name)["passes"], false);
    EXPECT_EQ(reportOf(name)["total"]["over_bound"], 1);
}

TEST(CertifyCommand, interruptedItReportsWhatItHasDone) {
    TemporaryFolder folder;
    const std::string name = folder.path("report");
    RunningProgram program(
        {"certify", "--faults", "1000000", "--kinds", "stop", "--bound", "0.05", "--out", name});
    std::this_thread::sleep_for(std::chrono::seconds(3));
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1);
    const json report = reportOf(name);
    ASSERT_TRUE(report.is_object()) << result.err;
    EXPECT_LT(report["total"]["faults"], 1000000);
    EXPECT_NE(report["remarks"].dump().find("Ended early"), std::string::npos) << report["remarks"];
}

TEST(CertifyCommand, motorsOfOthersNeedAWord) {
    TemporaryFolder folder;
    const std::string file = folder.write("d.toml", "kind = 'modbus'\n");
    const ProgramResult result = run({"certify", "--bracelet", file});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("add --yes"), std::string::npos) << result.err;
}

TEST(CertifyCommand, tellsWhichDriversItCanCertify) {
    TemporaryFolder folder;
    const std::string begin = "kind = 'modbus'\nname = 'd'\n[link]\nkind = 'rtu'\npath = '/dev/null'\n";
    const std::string joints = folder.write(
        "joints.toml", begin + "[[input]]\nname = 'a'\naddress = 0\ntype = 'uint16'\nunit = 'V'\n");
    const ProgramResult none = run({"certify", "--bracelet", joints, "--yes"});
    EXPECT_EQ(none.exitCode, 3);
    EXPECT_NE(none.err.find("the device has no motors"), std::string::npos) << none.err;
    const std::string serial = folder.write(
        "serial.toml",
        begin + "[tactors]\naddress = 0\ntype = 'uint16'\nunit = '1'\nfull = 1\n[watchdog]\naddress = 6\n");
    const ProgramResult line = run({"certify", "--bracelet", serial, "--yes"});
    EXPECT_EQ(line.exitCode, 3);
    EXPECT_NE(line.err.find("over TCP"), std::string::npos) << line.err;
    EXPECT_EQ(run({"certify", "--kinds", "flood"}).exitCode, 2);
    EXPECT_EQ(run({"certify", "--faults", "0"}).exitCode, 2);
}

TEST(CertifyCommand, anArmNeedsAJointAndAWord) {
    TemporaryFolder folder;
    const std::string arm =
        folder.write("arm.toml", "kind = 'ros_arm'\nname = 'Robot'\nbase_frame = 'base'\ntip_frame = 'tip'\n"
                                 "controller = '/c'\n[ros]\ndomain = 0\ninterface = 'lo'\n");
    const ProgramResult joint = run({"certify", "--arm", arm, "--yes"});
    EXPECT_EQ(joint.exitCode, 2);
    EXPECT_NE(joint.err.find("--joint is needed"), std::string::npos) << joint.err;
    const ProgramResult word = run({"certify", "--arm", arm, "--joint", "j"});
    EXPECT_EQ(word.exitCode, 2) << word.err;
    EXPECT_NE(word.err.find("add --yes"), std::string::npos) << word.err;
    const ProgramResult kind = run({"certify", "--arm", arm, "--joint", "j", "--yes", "--kinds", "unplug"});
    EXPECT_EQ(kind.exitCode, 2);
    EXPECT_NE(kind.err.find("unplug is no fault of an arm's chain"), std::string::npos) << kind.err;
    EXPECT_EQ(run({"certify", "--arm", arm, "--site", arm, "--joint", "j", "--yes"}).exitCode, 2);
    EXPECT_EQ(run({"certify", "--device", "a"}).exitCode, 2);
    EXPECT_EQ(run({"certify", "--arm", arm, "--joint", "j", "--rate", "9", "--yes"}).exitCode, 2);
    const std::string broken = folder.write("broken.toml", "kind = 'ros_arm'\n");
    EXPECT_EQ(run({"certify", "--arm", broken, "--joint", "j", "--yes"}).exitCode, 3);
}
