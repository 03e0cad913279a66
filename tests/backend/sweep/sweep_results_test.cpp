// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_parts.h"
#include "backend/sweep/sweep_results.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/sweep/swept_numbers.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace teleta;
using test::TemporaryFolder;

TEST(CellMeasure, hasTheStatisticsOfR) {
    // x <- c(3.1, 2.7, 4.4, 3.9, 2.2): mean, sd, median, quantile(x, c(.05, .95)), t.test(x)$conf.int of
    // R 4.2.
    const sweep::CellMeasure measure = sweep::cellMeasure({3.1, 2.7, 4.4, 3.9, 2.2}, false);
    EXPECT_EQ(measure.n, 5U);
    EXPECT_NEAR(*measure.mean, 3.26, 1e-12);
    EXPECT_NEAR(*measure.sd, 0.8905054744, 1e-9);
    EXPECT_EQ(*measure.median, 3.1);
    EXPECT_NEAR(*measure.p05, 2.3, 1e-12);
    EXPECT_NEAR(*measure.p95, 4.3, 1e-12);
    EXPECT_NEAR(*measure.low95, 2.1542914, 1e-6);
    EXPECT_NEAR(*measure.high95, 4.3657086, 1e-6);
}

TEST(CellMeasure, ofASharehasWilsonsInterval) {
    // 9 of 10: prop.test(9, 10, correct = FALSE)$conf.int of R 4.2.
    std::vector<double> values(10, 1.0);
    values[3] = 0.0;
    const sweep::CellMeasure measure = sweep::cellMeasure(values, true);
    EXPECT_NEAR(*measure.low95, 0.5958500, 1e-6);
    EXPECT_NEAR(*measure.high95, 0.9821238, 1e-6);
    // All agree: the interval is not a point.
    EXPECT_LT(*sweep::cellMeasure(std::vector<double>(10, 1.0), true).low95, 0.75);
}

TEST(CellMeasure, ofNothingIsNotAvailable) {
    const sweep::CellMeasure none = sweep::cellMeasure({}, false);
    EXPECT_EQ(none.n, 0U);
    EXPECT_FALSE(none.mean || none.sd || none.median || none.low95);
    const sweep::CellMeasure one = sweep::cellMeasure({2.0}, false);
    EXPECT_EQ(*one.mean, 2.0);
    EXPECT_FALSE(one.sd || one.low95);
}

TEST(CellMeasure, isAShareByItsValuesAndName) {
    for (const char* share : {"completed", "significant", "refused", "stopped_without_bump", "force_share"})
        EXPECT_TRUE(sweep::isShare(share, {0.0, 1.0, 1.0})) << share;
    // A time that is 0 in every run is no share of 0.
    EXPECT_FALSE(sweep::isShare("contact_lost_s", {0.0, 0.0, 0.0}));
    EXPECT_FALSE(sweep::isShare("contacts_missed", {0.0, 1.0}));
    EXPECT_TRUE(sweep::isShare("stiffness_covered", {0.8, 1.0}));
    EXPECT_FALSE(sweep::isShare("error_m", {0.8, 1.0}));
    EXPECT_FALSE(sweep::isShare("stiffness_covered", {1.2}));
    EXPECT_FALSE(sweep::isShare("a_covered", {}));
}

TEST(SweepParts, areReadAsTheyWereWritten) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("parts"));
    sweep::PartWriter writer(folder.path(""));
    sweep::RunRow failed;
    failed.run = 1;
    failed.reason = "line one, \"quoted\"";
    failed.wall_s = 0.25;
    sweep::RunRow good;
    good.run = 0;
    good.measures = {{"a", 0.1}, {"b[1]", -3e-300}};
    writer.add(failed);
    writer.add(good);
    ASSERT_TRUE(writer.close());
    std::vector<sweep::RunRow> rows;
    ASSERT_TRUE(
        sweep::readParts(folder.path(""), [&](sweep::RunRow&& row) { rows.push_back(std::move(row)); }));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].run, 0U);
    EXPECT_EQ(rows[0].measures, good.measures);
    EXPECT_EQ(rows[1].reason, failed.reason);
    EXPECT_EQ(rows[1].wall_s, 0.25);
    EXPECT_TRUE(rows[1].measures.empty());
}

TEST(SweepParts, haveNumbersOfTheirOwnForEveryWriter) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("parts"));
    sweep::PartWriter first(folder.path(""));
    sweep::PartWriter second(folder.path(""));
    EXPECT_EQ(*first.number(), "0000");
    EXPECT_EQ(*second.number(), "0001");
    // Taken and never written: no rows.
    EXPECT_EQ(*sweep::finishedRuns(folder.path(""), 3), std::vector<bool>(3, false));
}

TEST(SweepParts, thatAreNoneAreNamed) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("parts"));
    folder.write("parts/0000.csv", "run,status,reason,wall_s,processor_s,a\n0,ok,,0.1,0.1,zwei\n");
    const auto read = sweep::finishedRuns(folder.path(""), 3);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where.line, 2);
    EXPECT_NE(read.error().where.file.find("0000.csv"), std::string::npos);
    folder.write("parts/0000.csv", "time_s,t0\n0,1\n");
    EXPECT_FALSE(sweep::finishedRuns(folder.path(""), 3));
}

TEST(SweepResults, countARunThatIsThereTwiceOnce) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("parts"));
    const sweep::SweepPlan plan = test::numbersPlan(2);
    folder.write("parts/0000.csv",
                 "run,status,reason,wall_s,processor_s,sum\n1,ok,,0.1,0.1,2.5\n0,ok,,0.1,0.1,1.5\n");
    folder.write("parts/0001.csv", "run,status,reason,wall_s,processor_s,sum\n1,ok,,0.7,0.7,99\n");
    const auto results = sweep::readResults(plan, folder.path(""));
    ASSERT_TRUE(results) << describe(results.error());
    EXPECT_EQ(results->done, 2U);
    EXPECT_EQ(results->cells[0].measures[0].n, 2U);
    EXPECT_EQ(*results->cells[0].measures[0].mean, 2.0);
    EXPECT_EQ(results->cells[1].runs, 0U);
}

TEST(SweepResults, keepAMeasureThatNoRunCouldDetermine) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("parts"));
    sweep::SweepPlan plan = test::numbersPlan(2);
    // The list was determined in one run; without it the measure has no number.
    folder.write("parts/0000.csv", "run,status,reason,wall_s,processor_s,sum,lost,list,list[0]\n"
                                   "0,ok,,0.1,0.1,1.5,NA,NA,NA\n1,ok,,0.1,0.1,2.5,NA,NA,4\n");
    auto results = sweep::mergeParts(plan, folder.path(""));
    ASSERT_TRUE(results) << describe(results.error());
    EXPECT_EQ(results->measures, (std::vector<std::string>{"sum", "list[0]", "lost"}));
    EXPECT_EQ(results->cells[0].measures[2].n, 0U);
    EXPECT_FALSE(results->shares[2]);
    const std::string runs = test::readAll(folder.path("runs.csv"));
    EXPECT_NE(runs.find("reason,sum,list[0],lost,wall_s"), std::string::npos) << runs;
    EXPECT_NE(runs.find("ok,,1.5,NA,NA,"), std::string::npos) << runs;
    EXPECT_NE(test::readAll(folder.path("cells.csv")).find("0,0.5,lost,2,0,0,NA,NA"), std::string::npos);
    // A plan that names its measures has them in its order.
    plan.measures = {"lost", "sum", "list"};
    results = sweep::readResults(plan, folder.path(""));
    ASSERT_TRUE(results);
    EXPECT_EQ(results->measures, (std::vector<std::string>{"lost", "sum", "list[0]"}));
}

TEST(SweepResults, nameTheFileOfFramesThatCounts) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("parts"));
    std::filesystem::create_directories(folder.path("frames"));
    auto plan = sweep::parseSweepPlan("[sweep]\nscene = \"numbers\"\nseeds = \"1:3\"\n", "numbers.toml");
    ASSERT_TRUE(plan);
    const std::string head = "run,status,reason,wall_s,processor_s,sum\n";
    // Run 1 was done twice; run 2 failed; 0002 was written by a task that died before its rows.
    folder.write("parts/0000.csv", head + "0,ok,,0.1,0.1,1.5\n1,ok,,0.1,0.1,2.5\n");
    folder.write("parts/0001.csv", head + "1,ok,,0.1,0.1,2.5\n");
    folder.write("parts/0002.csv", "");
    for (const char* file : {"frames/0000.npz", "frames/0001.npz", "frames/0002.npz"})
        folder.write(file, "frames");
    const std::string named = "run,file\n0,frames/0000.npz\n1,frames/0000.npz\n";
    ASSERT_TRUE(sweep::mergeParts(*plan, folder.path(""), true));
    EXPECT_EQ(test::readAll(folder.path("frames.csv")), named);
    EXPECT_TRUE(std::filesystem::exists(folder.path("frames/0002.npz"))) << "its rows may still come";
    folder.write("parts/0003.csv", head + "2,failed,lost,0.1,0.1,NA\n");
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(sweep::mergeParts(*plan, folder.path(""), true));
        EXPECT_EQ(test::readAll(folder.path("frames.csv")), named);
        EXPECT_TRUE(std::filesystem::exists(folder.path("frames/0000.npz")));
        EXPECT_FALSE(std::filesystem::exists(folder.path("frames/0001.npz")));
        EXPECT_FALSE(std::filesystem::exists(folder.path("frames/0002.npz")));
    }
}
