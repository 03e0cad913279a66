// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>

using teleta::test::ProgramResult;
using teleta::test::run;
using teleta::test::TemporaryFolder;

namespace {

/// A wrong file of two taxels, and what the message must say behind the file's name.
struct WrongFile {
    const char* name;
    const char* content;
    const char* message;
};

class InputErrors : public testing::TestWithParam<WrongFile> {
protected:
    TemporaryFolder m_folder;
};

} // namespace

TEST_P(InputErrors, endWith3AndNameFileLineColumnAndWhatWasExpected) {
    const std::string path = m_folder.write("frames.csv", GetParam().content);
    for (const std::string command : {"features", "contacts"}) {
        const ProgramResult result = run({command, path, "--rows", "1", "--columns", "2"});
        EXPECT_EQ(result.exitCode, 3);
        EXPECT_EQ(result.err, "teleta: " + path + GetParam().message + "\n");
    }
}

INSTANTIATE_TEST_SUITE_P(
    Frames, InputErrors,
    testing::Values(
        WrongFile{"empty", "",
                  ":1:1: the file is empty (expected a header line with the names of the columns)"},
        WrongFile{"headerOnly", "time_s,t0,t1\n",
                  ":2:1: the recording has no frames (expected at least one row after the header)"},
        WrongFile{
            "noTime", "seconds,t0,t1\n0,1,2\n",
            ":1:1: missing columns: time_s; the file has: seconds, t0, t1 (expected the columns time_s; "
            "of a table of another program, which columns are times and taxels (--columns 2..3 "
            "--time-column seconds --time-unit s))"},
        WrongFile{
            "missingTaxel", "time_s,t0,t2\n0,1,2\n",
            ":1:11: column 3 is \"t2\" (expected t1; of a table of another program, which columns are times "
            "and taxels (--columns 2..3 --time-column time_s --time-unit s))"},
        WrongFile{"otherLayout", "time_s,t0,t1,t2\n0,1,2,3\n",
                  ":1:14: the file has 3 taxel columns (expected 2 = 1 rows x 2 columns)"},
        WrongFile{"shortRow", "time_s,t0,t1\n0,1,2\n0.1,1\n",
                  ":3:6: the row is too short: 2 of 3 values (expected one value per column: 3)"},
        WrongFile{"longRow", "time_s,t0,t1\n0,1,2,3\n",
                  ":2:7: the row is too long: more than 3 values (expected one value per column: 3)"},
        WrongFile{"text", "time_s,t0,t1\n0,1,2\n0.1,1,off\n",
                  ":3:7: \"off\" is not a number (expected a number, nan, inf or NA)"},
        WrongFile{"timeIsNan", "time_s,t0,t1\n0,1,2\nnan,1,2\n",
                  ":3:1: the time is nan (expected a finite time in s)"},
        WrongFile{"timeGoesBack", "time_s,t0,t1\n1,1,2\n0.5,1,2\n",
                  ":3:1: the time goes back from 1 to 0.5 (expected times that do not decrease)"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(InputFiles, thatAreMissingEndWith3) {
    const TemporaryFolder folder;
    const ProgramResult result = run({"features", folder.path("missing.csv")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "teleta: " + folder.path("missing.csv") +
                              ": cannot open the file: No such file or directory\n");
    EXPECT_EQ(run({"contacts", folder.path("")}).exitCode, 3) << "a folder";
}

TEST(InputFiles, theTareIsCheckedLikeTheFrames) {
    const TemporaryFolder folder;
    const std::string frames = folder.write("frames.csv", "time_s,t0,t1\n0,1,2\n");
    const std::vector<std::string> arguments{"features", frames, "--rows", "1", "--columns", "2", "--tare"};
    for (const char* content : {"", "time_s,t0,t1\n", "time_s,t0\n0,1\n", "time_s,t0,t1\n0,1,x\n"}) {
        std::vector<std::string> all = arguments;
        all.push_back(folder.write("tare.csv", content));
        const ProgramResult result = run(all);
        EXPECT_EQ(result.exitCode, 3) << content;
        EXPECT_NE(result.err.find("tare.csv"), std::string::npos) << result.err;
    }
}

TEST(InputFiles, rowsBeforeTheWrongOneAreStillPrinted) {
    const TemporaryFolder folder;
    const std::string path = folder.write("frames.csv", "time_s,t0,t1\n0,1,0\n1,1,0\n2,x,0\n");
    const ProgramResult result = run({"contacts", path, "--rows", "1", "--columns", "2"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_EQ(teleta::test::splitCsv(result.out).size(), 3U);
}
