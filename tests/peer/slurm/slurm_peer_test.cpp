// SPDX-License-Identifier: GPL-3.0-or-later
// teleta sweep --slurm against a real Slurm of one node (slurm.sh).
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

using nlohmann::json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

int shell(const std::string& command) {
    const int status = std::system(command.c_str()); // NOLINT(cert-env33-c)
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string outputOf(const std::string& command) {
    std::string text;
    if (std::FILE* pipe = popen(command.c_str(), "r")) {
        std::array<char, 256> piece{};
        while (std::fgets(piece.data(), piece.size(), pipe) != nullptr)
            text += piece.data();
        pclose(pipe);
    }
    return text;
}

/// Waits for a condition, at most a minute.
template <typename Condition>
bool within(Condition&& condition) {
    for (int i = 0; i < 600; ++i) {
        if (condition())
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

/// One cluster for all tests of this program.
class Slurm : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_cluster = new TemporaryFolder;
        s_started = shell(TELETA_SLURM " start " + s_cluster->path(""));
        setenv("SLURM_CONF", s_cluster->path("slurm.conf").c_str(), 1);
    }
    static void TearDownTestSuite() {
        shell(TELETA_SLURM " stop " + s_cluster->path(""));
        delete s_cluster;
    }
    void SetUp() override {
        if (s_started == 77)
            GTEST_SKIP() << "no Slurm can be started here";
        ASSERT_EQ(s_started, 0);
        m_sweep = m_folder.write("sweep.toml", kSweep);
    }

    ProgramResult sweep(std::vector<std::string> more) const {
        std::vector<std::string> all{"sweep", m_sweep};
        all.insert(all.end(), more.begin(), more.end());
        return run(all, {.environment = {{"SLURM_CONF", s_cluster->path("slurm.conf")}}, .outPath = {}});
    }
    /// cells.csv of the same sweep on this machine alone.
    std::string cellsHere() const {
        const ProgramResult here = sweep({"--out", m_folder.path("here")});
        EXPECT_EQ(here.exitCode, 0) << here.err;
        return readAll(m_folder.path("here/cells.csv"));
    }
    std::uint64_t done(const std::string& out) const {
        const ProgramResult status = run({"sweep", "--status", m_folder.path(out), "--json"});
        return status.exitCode == 0 ? json::parse(status.out)["done"].get<std::uint64_t>() : 0;
    }
    std::string queue() const { return outputOf("squeue --noheader --array --me --format=%T"); }

    static constexpr const char* kSweep = "[sweep]\nscene = \"tactile-two-contacts\"\nseeds = \"1:20\"\n"
                                          "[sweep.vary]\n\"effect.noise.sd_N\" = [0.005, 0.03, 0.06]\n";
    static inline TemporaryFolder* s_cluster = nullptr;
    static inline int s_started = 0;
    TemporaryFolder m_folder;
    std::string m_sweep;
};

} // namespace

TEST_F(Slurm, givesTheResultsOfOneMachine) {
    const ProgramResult result = sweep(
        {"--out", m_folder.path("s"), "--slurm", "--tasks", "6", "--wait", "--sbatch-option", "--time=5"});
    ASSERT_EQ(result.exitCode, 0) << result.err << readAll(m_folder.path("s/log/task-0.txt"));
    EXPECT_EQ(readAll(m_folder.path("s/cells.csv")), cellsHere());
    const std::string script = readAll(m_folder.path("s/job.sh"));
    EXPECT_NE(script.find("#SBATCH --array=0-5"), std::string::npos);
    EXPECT_NE(script.find("#SBATCH --time=5"), std::string::npos);
    EXPECT_TRUE(queue().empty()) << queue();
}

TEST_F(Slurm, saysWhichJobRunsAndMergesByItself) {
    const ProgramResult result =
        sweep({"--out", m_folder.path("s"), "--slurm", "--runs-per-task", "20", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json submitted = json::parse(result.out);
    EXPECT_EQ(submitted["tasks"], 3);
    EXPECT_NE(submitted["array"], submitted["merge"]);
    ASSERT_TRUE(within([&] { return std::filesystem::exists(m_folder.path("s/cells.csv")); }));
    EXPECT_EQ(done("s"), 60U);
}

TEST_F(Slurm, losesNothingWhenTasksAreKilledAndRequeued) {
    const ProgramResult result = sweep({"--out", m_folder.path("s"), "--slurm", "--tasks", "2", "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string array = json::parse(result.out)["array"];
    ASSERT_TRUE(within([&] { return queue().find("RUNNING") != std::string::npos; })) << queue();
    // One task is put back by the scheduler, the processes of the other die.
    EXPECT_EQ(shell("scontrol requeue " + array + "_0"), 0);
    const auto killed = [&] {
        const std::string job = outputOf("squeue --noheader --array --jobs=" + array + "_1 --format=%A");
        std::istringstream pids(outputOf("scontrol listpids " + job.substr(0, job.find('\n')) +
                                         " | awk 'NR > 1 && $1 > 1 { print $1 }'"));
        int count = 0;
        for (int pid = 0; pids >> pid;)
            count += kill(pid, SIGKILL) == 0 ? 1 : 0;
        return count > 0;
    };
    EXPECT_TRUE(within(killed)) << queue();
    ASSERT_TRUE(within([&] { return queue().empty(); })) << queue();
    // What the killed task has not done is missing, which the command says and then does.
    const ProgramResult rest = sweep({"--out", m_folder.path("s")});
    ASSERT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_EQ(readAll(m_folder.path("s/cells.csv")), cellsHere());
}

TEST_F(Slurm, goesOnAfterItsNodeWasLost) {
    ASSERT_EQ(sweep({"--out", m_folder.path("s"), "--slurm", "--tasks", "4"}).exitCode, 0);
    ASSERT_TRUE(within([&] { return queue().find("RUNNING") != std::string::npos; })) << queue();
    EXPECT_EQ(shell(TELETA_SLURM " kill-node " + s_cluster->path("")), 0);
    EXPECT_EQ(shell(TELETA_SLURM " start-node " + s_cluster->path("")), 0);
    ASSERT_TRUE(within([&] { return queue().empty(); })) << queue();
    const ProgramResult rest = sweep({"--out", m_folder.path("s")});
    ASSERT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_EQ(readAll(m_folder.path("s/cells.csv")), cellsHere());
}

TEST_F(Slurm, passesOnWhatSlurmRefuses) {
    const ProgramResult result =
        sweep({"--out", m_folder.path("s"), "--slurm", "--sbatch-option", "--partition=nowhere"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("partition"), std::string::npos) << result.err;
}

TEST(SlurmThatIsNotThere, isNamedWithItsPackage) {
    const TemporaryFolder folder;
    const std::string sweep = folder.write("sweep.toml", "[sweep]\nladder = \"contour\"\n");
    const ProgramResult result = run({"sweep", sweep, "--out", folder.path("s"), "--slurm"},
                                     {.environment = {{"PATH", folder.path("")}}, .outPath = {}});
    EXPECT_NE(result.exitCode, 0);
    EXPECT_NE(result.err.find("slurm-client"), std::string::npos) << result.err;
}
