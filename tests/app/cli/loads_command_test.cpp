// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

/// force_n = 2 (a - 10), shear_x_n = 0.5 b.
constexpr const char* kPresses = "time_s,a,b,force_n,shear_x_n\n"
                                 "0,10,0,0,0\n1,11,2,2,1\n2,12,-4,4,-2\n3,13,6,6,3\n4,14,0,8,0\n5,11,8,2,4\n";

} // namespace

TEST(LoadsCommand, fitsAMatrixAndAppliesIt) {
    const TemporaryFolder folder;
    const std::string presses = folder.write("presses.csv", kPresses);
    const std::string file = folder.path("newtons.csv");
    const ProgramResult made = run({"loads", "fit", presses, "--signals", "a,b", "--out", file, "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const auto document = nlohmann::ordered_json::parse(made.out);
    EXPECT_EQ(document["rows"], 6);
    EXPECT_EQ(document["loads"][0]["load"], "force_n");
    EXPECT_NEAR(document["loads"][0]["gains"]["a"]["gain"].get<double>(), 2.0, 1e-12);
    EXPECT_NEAR(document["loads"][1]["gains"]["b"]["gain"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(document["loads"][1]["gains"]["b"]["gain_se"].get<double>(), 0.0, 1e-12);
    EXPECT_EQ(run({"loads", "fit", presses, "--signals", "a,b"}).out, readAll(file));

    const std::string table = folder.write("table.csv", "b,time_s,a\n4,0.5,12\n4,0.6,15\nNA,0.7,12\n");
    const ProgramResult applied = run({"loads", "apply", file, table});
    ASSERT_EQ(applied.exitCode, 0) << applied.err;
    const auto rows = splitCsv(applied.out);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"time_s", "force_n", "force_n_se", "shear_x_n",
                                                 "shear_x_n_se", "extrapolated"}));
    EXPECT_EQ(rows[1][0], "0.5");
    EXPECT_NEAR(std::stod(rows[1][1]), 4.0, 1e-12);
    EXPECT_NEAR(std::stod(rows[1][2]), 0.0, 1e-12) << "the presses have no noise";
    EXPECT_NEAR(std::stod(rows[1][3]), 2.0, 1e-12);
    EXPECT_EQ(rows[1][5], "0");
    EXPECT_NEAR(std::stod(rows[2][1]), 10.0, 1e-12);
    EXPECT_EQ(rows[2][5], "1");
    EXPECT_EQ(rows[3][1], "NA");
    EXPECT_EQ(rows[3][2], "NA");
}

TEST(LoadsCommand, refusesWhatItCannotTell) {
    const TemporaryFolder folder;
    const std::string presses = folder.write("presses.csv", kPresses);
    const ProgramResult few = run({"loads", "fit", presses, "--signals", "a,b,time_s"});
    EXPECT_EQ(few.exitCode, 1);
    EXPECT_NE(few.err.find("5 presses under load are too few for 3 signals"), std::string::npos) << few.err;
    const ProgramResult missing = run({"loads", "fit", presses, "--signals", "a,c"});
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.err.find("presses.csv:1"), std::string::npos) << missing.err;
    EXPECT_EQ(run({"loads", "fit", presses, "--signals", "a,a"}).exitCode, 2);
    EXPECT_EQ(run({"loads", "fit", presses, "--signals", "force_n"}).exitCode, 2);
    EXPECT_EQ(run({"loads", "fit", presses}).exitCode, 2);
    EXPECT_EQ(run({"loads", "fit", presses, "--signals", "a,b", "--out", presses}).exitCode, 2);
    const ProgramResult noLoad =
        run({"loads", "fit", folder.write("free.csv", "a,b\n1,2\n"), "--signals", "a,b"});
    EXPECT_EQ(noLoad.exitCode, 3);
    EXPECT_NE(noLoad.err.find("one of force_n, shear_x_n, shear_y_n, moment_nm"), std::string::npos)
        << noLoad.err;
    EXPECT_EQ(run({"loads", "apply", presses, presses}).exitCode, 3);
}
