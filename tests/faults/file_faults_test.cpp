// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings, studies and results while the disk fails: at the first operation on a file, at the second, and
// so on; and after a power cut between any two of them. Nothing that was said to last may be missing, and
// nothing may be half.
#include "tests/backend/core/temporary_folder.h"
#include "tests/faults/disk_model.h"
#include "tests/faults/work_check.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace teleta::test;
namespace fs = std::filesystem;

namespace {

class FileFaults : public testing::TestWithParam<const char*> {};

/// Operations of a work that succeeds.
long long operationsOf(const std::string& work) {
    TemporaryFolder folder;
    TemporaryFolder outside;
    fs::create_directory(folder.path("f"));
    const WorkResult result = runWork(work, folder.path("f"), {{"FAULTY_COUNT", outside.path("count")}});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return std::stoll(readAll(outside.path("count")));
}

} // namespace

TEST_P(FileFaults, eachFailingOperationIsToldAndLosesNothing) {
    const std::string work = GetParam();
    TemporaryFolder all;
    const long long operations = operationsOf(work);
    ASSERT_GT(operations, 10);
    for (const char* kind : {"eio", "enospc", "short"}) {
        for (long long at = 0; at < operations; ++at) {
            fs::remove_all(all.path("f"));
            fs::create_directory(all.path("f"));
            const WorkResult result =
                runWork(work, all.path("f"), {{"FAULTY_KIND", kind}, {"FAULTY_AT", std::to_string(at)}});
            const std::string where = std::string(kind) + " at operation " + std::to_string(at);
            EXPECT_TRUE(result.exitCode == 0 || (result.exitCode == 1 && !result.errors.empty()))
                << where << ": " << result.exitCode << " " << result.errors;
            EXPECT_EQ(wrongWith(work, all.path("f"), acksIn(all.path("f"))), "")
                << where << ": " << result.errors;
            for (const auto& entry : fs::directory_iterator(all.path("f"))) {
                const bool expected =
                    entry.path().filename() == "acks" || entry.path().filename() == "result";
                EXPECT_TRUE(expected || work != "output") << where << " left " << entry.path();
            }
        }
    }
}

TEST_P(FileFaults, aPowerCutBetweenAnyTwoOperationsLosesNothing) {
    const std::string work = GetParam();
    TemporaryFolder folder;
    TemporaryFolder outside;
    const std::string root = folder.path("f");
    fs::create_directory(root);
    ASSERT_EQ(runWork(work, root, {{"FAULTY_LOG", outside.path("log")}}).exitCode, 0);
    const std::vector<FileOp> ops = decoded(readAll(outside.path("log")));
    ASSERT_GT(ops.size(), 10U);

    std::mt19937_64 random(1);
    DiskModel disk(root);
    int acks = 0;
    std::size_t cuts = 0;
    for (std::size_t at = 0; at <= ops.size(); ++at) {
        constexpr int kChances = 4;
        for (int chance = 0; chance < 2 + kChances; ++chance) {
            const Leftover leftover = chance == 0   ? Leftover::all
                                      : chance == 1 ? Leftover::nothing
                                                    : Leftover::anything;
            fs::remove_all(root);
            const auto files = disk.cut(leftover, random);
            for (const std::string& made : disk.folders())
                fs::create_directories(made);
            for (const auto& [path, bytes] : files)
                std::ofstream(path, std::ios::binary) << bytes;
            EXPECT_EQ(wrongWith(work, root, acks), "")
                << "cut after operation " << at << " of " << ops.size() << ", way " << chance;
            ++cuts;
        }
        if (at == ops.size())
            break;
        disk.apply(ops[at]);
        acks += ops[at].path == root + "/acks" && ops[at].kind == FileOp::Kind::write ? 1 : 0;
    }
    RecordProperty("cuts", static_cast<int>(cuts));
}

INSTANTIATE_TEST_SUITE_P(Works, FileFaults, testing::ValuesIn(kWorks),
                         [](const testing::TestParamInfo<const char*>& work) {
                             return std::string(work.param);
                         });
