// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

class Usage : public testing::TestWithParam<std::vector<std::string>> {};

} // namespace

TEST_P(Usage, thatIsWrongEndsWith2AndAMessage) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = GetParam();
    for (std::string& argument : arguments) {
        if (argument == "FILE")
            argument = folder.write("frames.csv", "time_s,t0\n0,1\n");
    }
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("teleta: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("--help"), std::string::npos) << result.err;
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, Usage,
    testing::Values(
        std::vector<std::string>{}, std::vector<std::string>{"dance"}, std::vector<std::string>{"features"},
        std::vector<std::string>{"features", "FILE", "--unknown"},
        std::vector<std::string>{"features", "FILE", "FILE"},
        std::vector<std::string>{"features", "FILE", "--rows"},
        std::vector<std::string>{"features", "FILE", "--rows", "0"},
        std::vector<std::string>{"features", "FILE", "--rows", "1025"},
        std::vector<std::string>{"features", "FILE", "--columns", "2.5"},
        std::vector<std::string>{"features", "FILE", "--columns", "x"},
        std::vector<std::string>{"features", "FILE", "--pitch-mm", "0"},
        std::vector<std::string>{"features", "FILE", "--pitch-mm", "inf"},
        std::vector<std::string>{"features", "FILE", "--threshold", "-0.2"},
        std::vector<std::string>{"features", "FILE", "--threshold", "0,2"},
        std::vector<std::string>{"features", "FILE", "--gain", "0"},
        std::vector<std::string>{"features", "FILE", "--gain", "nan"},
        std::vector<std::string>{"contacts", "FILE", "--noise-height", "1.5"},
        std::vector<std::string>{"contacts", "FILE", "--min-taxels", "0"},
        std::vector<std::string>{"features", "FILE", "--rows", "1", "--columns", "1", "--dead", "1"},
        std::vector<std::string>{"features", "FILE", "--rows", "1", "--columns", "1", "--dead", "-1"},
        std::vector<std::string>{"features", "FILE", "--rows", "1", "--columns", "1", "--out", "FILE"}));

TEST(CommandLine, helpIsNoErrorAndHasAnExampleForEachCommand) {
    const ProgramResult program = run({"--help"});
    EXPECT_EQ(program.exitCode, 0);
    for (const std::string command : {"features", "contacts"}) {
        EXPECT_NE(program.out.find(command), std::string::npos);
        const ProgramResult help = run({command, "--help"});
        EXPECT_EQ(help.exitCode, 0);
        EXPECT_NE(help.out.find("teleta " + command + " run/frames.csv"), std::string::npos);
        EXPECT_NE(help.out.find("--pitch-mm"), std::string::npos);
        EXPECT_EQ(help.err, "");
    }
}

TEST(CommandLine, aCommandThatNobodyKnowsIsNamedWithThoseThatThereAre) {
    const ProgramResult outer = run({"frobnicate", "FILE"});
    EXPECT_EQ(outer.exitCode, 2);
    EXPECT_NE(outer.err.find("no command 'frobnicate'; expected one of features, contacts, "),
              std::string::npos)
        << outer.err;
    EXPECT_NE(outer.err.find("\nRun teleta --help"), std::string::npos) << outer.err;
    const ProgramResult inner = run({"pattern", "frobnicate"});
    EXPECT_EQ(inner.exitCode, 2);
    EXPECT_NE(inner.err.find("no command 'frobnicate'; expected one of list, show, "), std::string::npos)
        << inner.err;
    EXPECT_NE(inner.err.find("\nRun teleta pattern --help"), std::string::npos) << inner.err;
    // What a part of a command takes is told by its own help.
    EXPECT_NE(run({"pattern", "render"}).err.find("\nRun teleta pattern render --help"), std::string::npos);
}

TEST(CommandLine, theVersionIsPrinted) {
    const ProgramResult result = run({"--version"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out.find("teleta "), 0U);
    EXPECT_EQ(result.out.find('+'), std::string::npos) << "the commit is for programs";
}

TEST(CommandLine, versionAndCommitAreToldToPrograms) {
    const ProgramResult result = run({"--version", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto document = nlohmann::json::parse(result.out);
    EXPECT_EQ("teleta " + document["version"].get<std::string>() + "\n", run({"--version"}).out);
    EXPECT_EQ(document["name"], "teleta");
    EXPECT_TRUE(document["modified"].is_boolean());
    if (!document["commit"].is_null()) {
        const auto commit = document["commit"].get<std::string>();
        EXPECT_EQ(commit.size(), 12U);
        EXPECT_EQ(commit.find_first_not_of("0123456789abcdef"), std::string::npos) << commit;
    }
    EXPECT_EQ(run({"--json"}).exitCode, 2) << "of nothing";
    EXPECT_EQ(run({}).exitCode, 2);
}

TEST(CommandLine, theCitationIsAnEntryOfBibTeXWithTheDataOfTheCitationFile) {
    const ProgramResult result = run({"--citation"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out.find("@software{teleta_console,\n"), 0U) << result.out;
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '{'),
              std::count(result.out.begin(), result.out.end(), '}'));
    const std::string cff = readAll(std::string(TELETA_SOURCE_DIR) + "/CITATION.cff");
    const auto ofFile = [&cff](const std::string& key) {
        const std::size_t at = cff.find("\n" + key + ": ") + key.size() + 3;
        std::string value = cff.substr(at, cff.find('\n', at) - at);
        std::erase(value, '"');
        return value;
    };
    for (const char* key : {"title", "version", "license"})
        EXPECT_NE(result.out.find("{" + ofFile(key) + "}"), std::string::npos) << key << "\n" << result.out;
    EXPECT_NE(result.out.find("date    = {" + ofFile("date-released") + "}"), std::string::npos)
        << result.out;
    EXPECT_NE(cff.find("name: The TeleTA Console authors"), std::string::npos);
    EXPECT_NE(result.out.find("{The TeleTA Console authors}"), std::string::npos);
}

TEST(CommandLine, anOutputThatIsTheInputIsRefusedAndLeavesItAlone) {
    const TemporaryFolder folder;
    const std::string path = folder.write("frames.csv", "time_s,t0\n0,1\n");
    EXPECT_EQ(run({"features", path, "--rows", "1", "--columns", "1", "--out", path}).exitCode, 2);
    EXPECT_EQ(readAll(path), "time_s,t0\n0,1\n");
}

TEST(CommandLine, aListOfDeadTaxelsDoesNotSwallowTheFileName) {
    const TemporaryFolder folder;
    const std::string path = folder.write("frames.csv", "time_s,t0,t1\n0,1,1\n");
    EXPECT_EQ(run({"features", "--rows", "1", "--columns", "2", "--dead", "0,1", path}).exitCode, 0);
}
