// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_folder.h"
#include "backend/sweep/sweep_runner.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/sweep/swept_numbers.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace teleta;
using test::readAll;
using test::TemporaryFolder;

namespace {

sweep::SweepFolder folderAt(const std::string& path) {
    return {path, "numbers", "1.2.3", false};
}

void sweepInto(const std::string& path, const sweep::SweepPlan& plan) {
    const test::SweptNumbers numbers;
    ASSERT_TRUE(folderAt(path).open(plan, false));
    sweep::SweepOptions options;
    options.folder = path;
    ASSERT_TRUE(sweep::runSweep(plan, numbers, options));
}

} // namespace

TEST(SweepFolder, holdsWhatIsNeededToRepeatTheSweep) {
    const TemporaryFolder folder;
    const sweep::SweepPlan plan = test::numbersPlan(4);
    sweepInto(folder.path("s"), plan);
    ASSERT_TRUE(folderAt(folder.path("s")).merge(plan));
    const auto document = nlohmann::json::parse(readAll(folder.path("s/sweep.json")));
    EXPECT_EQ(document["text"], plan.text);
    EXPECT_EQ(document["app_version"], "1.2.3");
    EXPECT_EQ(document["runs"], 20);
    EXPECT_EQ(document["done"], 20);
    EXPECT_TRUE(std::filesystem::exists(folder.path("s/figures/sum.svg")));
    sweep::SweepPlan read;
    const auto again = sweep::SweepFolder::read(folder.path("s"), read);
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(read.runs(), 20U);
    EXPECT_EQ(read.text, plan.text);
}

TEST(SweepFolder, refusesAnotherSweepAndSaysWhatDiffers) {
    const TemporaryFolder folder;
    sweepInto(folder.path("s"), test::numbersPlan(4));
    const sweep::SweepPlan other = test::numbersPlan(5);
    const auto refused = folderAt(folder.path("s")).open(other, false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    EXPECT_NE(refused.error().message.find("seeds = \"1:4\""), std::string::npos) << refused.error().message;
    EXPECT_NE(refused.error().message.find("seeds = \"1:5\""), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder.path("s/parts/0000.csv")));

    sweep::SweepFolder newer = folderAt(folder.path("s"));
    newer.version = "1.2.4";
    EXPECT_FALSE(newer.open(test::numbersPlan(4), false));
    sweep::SweepFolder changed = folderAt(folder.path("s"));
    changed.source = "other numbers";
    EXPECT_FALSE(changed.open(test::numbersPlan(4), false));
    EXPECT_TRUE(folderAt(folder.path("s")).open(test::numbersPlan(4), false));

    EXPECT_TRUE(folderAt(folder.path("s")).open(other, true));
    EXPECT_FALSE(std::filesystem::exists(folder.path("s/parts/0000.csv")));
}

TEST(SweepFolder, touchesNoFolderOfOtherFiles) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("mine"));
    folder.write("mine/thesis.txt", "years of work");
    for (const bool restart : {false, true})
        EXPECT_FALSE(folderAt(folder.path("mine")).open(test::numbersPlan(4), restart));
    EXPECT_EQ(readAll(folder.path("mine/thesis.txt")), "years of work");
    sweep::SweepPlan plan;
    EXPECT_EQ(sweep::SweepFolder::read(folder.path("mine"), plan).error().kind, core::ErrorKind::notFound);
    folder.write("mine/sweep.json", "[1, 2");
    EXPECT_EQ(sweep::SweepFolder::read(folder.path("mine"), plan).error().kind, core::ErrorKind::badInput);
}

TEST(SweepFolder, keepsOtherFilesWhenItBeginsAnew) {
    const TemporaryFolder folder;
    sweepInto(folder.path("s"), test::numbersPlan(4));
    folder.write("s/notes.txt", "look at x = 2.5");
    ASSERT_TRUE(folderAt(folder.path("s")).open(test::numbersPlan(4), true));
    EXPECT_EQ(readAll(folder.path("s/notes.txt")), "look at x = 2.5");
}
