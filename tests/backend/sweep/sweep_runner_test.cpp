// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_parts.h"
#include "backend/sweep/sweep_results.h"
#include "backend/sweep/sweep_runner.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/sweep/swept_numbers.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <thread>

using namespace teleta;
using test::readAll;
using test::SweptNumbers;
using test::TemporaryFolder;

namespace {

/// A file of results without its last two columns, which are times.
std::string withoutTimes(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line, text;
    while (std::getline(lines, line)) {
        line.resize(line.rfind(','));
        text += line.substr(0, line.rfind(',')) + "\n";
    }
    return text;
}

sweep::SweepOutcome sweepIn(const TemporaryFolder& folder, const sweep::SweepPlan& plan,
                            const SweptNumbers& numbers, std::size_t workers = 2, std::uint64_t first = 0,
                            std::uint64_t end = sweep::kMostRuns) {
    sweep::SweepOptions options;
    options.folder = folder.path("s");
    options.workers = workers;
    options.first = first;
    options.end = end;
    const auto outcome = sweep::runSweep(plan, numbers, options);
    EXPECT_TRUE(outcome) << describe(outcome.error());
    return outcome.value_or(sweep::SweepOutcome{});
}

} // namespace

TEST(SweepRunner, givesTheSameBytesForAnyNumberOfWorkersAndTasks) {
    const sweep::SweepPlan plan = test::numbersPlan(500); // 2500 runs, more than two parts
    const SweptNumbers numbers({3});
    std::string runs, cells;
    for (const std::size_t workers : {1U, 2U, 7U}) {
        const TemporaryFolder folder;
        sweepIn(folder, plan, numbers, workers);
        ASSERT_TRUE(sweep::mergeParts(plan, folder.path("s")));
        const std::string own = withoutTimes(readAll(folder.path("s/runs.csv")));
        const std::string ownCells = readAll(folder.path("s/cells.csv"));
        if (runs.empty()) {
            runs = own;
            cells = ownCells;
        }
        EXPECT_EQ(own, runs);
        EXPECT_EQ(ownCells, cells);
    }
    // Tasks of an array, the last one first, and merged twice.
    const TemporaryFolder folder;
    sweepIn(folder, plan, numbers, 1, 1100, 2500);
    sweepIn(folder, plan, numbers, 1, 0, 1100);
    ASSERT_TRUE(sweep::mergeParts(plan, folder.path("s")));
    ASSERT_TRUE(sweep::mergeParts(plan, folder.path("s")));
    EXPECT_EQ(withoutTimes(readAll(folder.path("s/runs.csv"))), runs);
    EXPECT_EQ(readAll(folder.path("s/cells.csv")), cells);
    EXPECT_EQ(runs.substr(0, runs.find('\n')), "run,cell,seed,x,status,reason,sum,later");
}

TEST(SweepRunner, goesOnWithWhatIsMissing) {
    const sweep::SweepPlan plan = test::numbersPlan(20);
    const TemporaryFolder folder;
    const SweptNumbers first;
    sweepIn(folder, plan, first, 2, 0, 33);
    EXPECT_EQ(first.runs(), 33U);
    const SweptNumbers second;
    const sweep::SweepOutcome outcome = sweepIn(folder, plan, second);
    EXPECT_EQ(second.runs(), 67U);
    EXPECT_EQ(outcome.done, 100U);
    const SweptNumbers third;
    EXPECT_EQ(sweepIn(folder, plan, third).done, 100U);
    EXPECT_EQ(third.runs(), 0U);
}

TEST(SweepRunner, keepsAFailedRunAsARowWithItsReason) {
    const sweep::SweepPlan plan = test::numbersPlan(4);
    const TemporaryFolder folder;
    const SweptNumbers numbers({2});
    EXPECT_EQ(sweepIn(folder, plan, numbers).failed, 5U);
    const auto results = sweep::mergeParts(plan, folder.path("s"));
    ASSERT_TRUE(results);
    EXPECT_EQ(results->done, 20U);
    EXPECT_EQ(results->failed, 5U);
    EXPECT_EQ(results->cells[0].failed, 1U);
    EXPECT_EQ(results->cells[0].measures[0].n, 3U);
    // Seeds 1, 3 and 4 of x = 0.5.
    EXPECT_DOUBLE_EQ(*results->cells[0].measures[0].mean, 0.5 + 8.0 / 3.0);
    EXPECT_NE(readAll(folder.path("s/runs.csv")).find("failed,\"seed 2, \"\"as asked\"\"\",NA"),
              std::string::npos);
}

TEST(SweepRunner, letsRunsEndAndKeepsThemWhenItIsInterrupted) {
    const sweep::SweepPlan plan = test::numbersPlan(1'000'000);
    const TemporaryFolder folder;
    const SweptNumbers numbers;
    sweep::SweepOptions options;
    options.folder = folder.path("s");
    options.workers = 2;
    options.end = 5'000'000;
    options.goOn = [](const sweep::SweepProgress& progress) {
        EXPECT_EQ(progress.all, 5'000'000U);
        EXPECT_EQ(progress.measure, "sum");
        EXPECT_FALSE(progress.worst.empty());
        return false;
    };
    const auto outcome = sweep::runSweep(plan, numbers, options);
    ASSERT_TRUE(outcome);
    EXPECT_TRUE(outcome->interrupted);
    EXPECT_GT(outcome->done, 0U);
    EXPECT_LT(outcome->done, outcome->all);
    const auto finished = sweep::finishedRuns(folder.path("s"), plan.runs());
    ASSERT_TRUE(finished);
    EXPECT_EQ(static_cast<std::uint64_t>(std::ranges::count(*finished, true)), outcome->done);
}

TEST(SweepRunner, namesAMeasureThatNoRunHas) {
    sweep::SweepPlan plan = test::numbersPlan(20);
    plan.measures = {"sum", "some"};
    plan.measuresPlace = {"numbers.toml", 4, 12};
    const TemporaryFolder folder;
    const SweptNumbers numbers;
    sweep::SweepOptions options;
    options.folder = folder.path("s");
    options.workers = 1;
    const auto outcome = sweep::runSweep(plan, numbers, options);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(numbers.runs(), 1U);
    EXPECT_EQ(outcome.error().where.line, 4);
    EXPECT_NE(outcome.error().message.find("some"), std::string::npos);
    EXPECT_NE(outcome.error().expected.find("sum"), std::string::npos);
}

TEST(SweepRunner, mergesTwiceAtOnceWithoutHarm) {
    const sweep::SweepPlan plan = test::numbersPlan(400);
    const TemporaryFolder folder;
    const SweptNumbers numbers;
    sweepIn(folder, plan, numbers);
    ASSERT_TRUE(sweep::mergeParts(plan, folder.path("s")));
    const std::string runs = readAll(folder.path("s/runs.csv"));
    std::thread other([&] {
        for (int i = 0; i < 5; ++i)
            EXPECT_TRUE(sweep::mergeParts(plan, folder.path("s")));
    });
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(sweep::mergeParts(plan, folder.path("s")));
    other.join();
    EXPECT_EQ(readAll(folder.path("s/runs.csv")), runs);
}
