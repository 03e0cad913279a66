// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"
#include "tests/support/postgres_server.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using nlohmann::ordered_json;
using teleta::test::PostgresServer;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::TemporaryFolder;

TEST(StudyServer, aStudyIsRehearsedResumedExportedAndAnalyzedOnAServer) {
    if (PostgresServer::programs().empty())
        GTEST_SKIP() << "PostgreSQL is not installed, so there is no server to talk to";
    const TemporaryFolder folder;
    PostgresServer server;
    const std::string url = server.url("paper");
    const std::string here = folder.path("here");
    const ProgramResult rehearsed = run(
        {"study", "rehearse", "--participants", "2", "--seed", "4", "--out", here, "--store", url, "--json"});
    ASSERT_EQ(rehearsed.exitCode, 0) << rehearsed.err;
    EXPECT_EQ(ordered_json::parse(rehearsed.out)["trials"], 352);
    EXPECT_EQ(rehearsed.out.find("cret"), std::string::npos) << "the password is shown";
    const ProgramResult resumed = run({"study", "resume", here, "--store", url, "--json"});
    ASSERT_EQ(resumed.exitCode, 0) << resumed.err;
    EXPECT_EQ(ordered_json::parse(resumed.out)["trials_before"], 352);

    const std::string there = folder.path("there");
    ASSERT_EQ(run({"study", "export", there, "--store", url}).exitCode, 0);
    const std::string local = folder.path("local");
    ASSERT_EQ(run({"study", "rehearse", "--participants", "2", "--seed", "4", "--out", local}).exitCode, 0);
    for (const auto& [name, input] : {std::pair("server", std::string()), std::pair("file", local)}) {
        std::vector<std::string> arguments{"study", "analyze", "--out", folder.path(name)};
        if (input.empty())
            arguments.insert(arguments.end(), {"--store", url});
        else
            arguments.push_back(input);
        const ProgramResult analyzed = run(arguments);
        ASSERT_EQ(analyzed.exitCode, 0) << analyzed.err;
    }
    for (const char* file : {"summary.csv", "anova.csv", "confusion_long.csv", "group.csv"})
        EXPECT_EQ(readAll(folder.path("server/") + file), readAll(folder.path("file/") + file)) << file;
    EXPECT_EQ(readAll(folder.path("server/report.html")).find("cret"), std::string::npos);

    server.kill();
    const ProgramResult away = run({"study", "resume", here, "--store", url});
    EXPECT_EQ(away.exitCode, 1);
    EXPECT_EQ(away.err.find("cret"), std::string::npos) << away.err;
}
