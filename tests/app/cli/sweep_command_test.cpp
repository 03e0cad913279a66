// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/program_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <sys/mount.h>
#include <thread>

using nlohmann::json;
using teleta::test::ProgramResult;
using teleta::test::readAll;
using teleta::test::run;
using teleta::test::RunningProgram;
using teleta::test::splitCsv;
using teleta::test::TemporaryFolder;

namespace {

constexpr const char* kSmall =
    "[sweep]\nscene = \"tactile-indenter\"\nseeds = \"1:3\"\n[sweep.vary]\nduration_s = [1.2]\n"
    "\"effect.noise.sd_N\" = [0.005, 0.05]\n";
/// Some seconds of one core.
constexpr const char* kLong = "[sweep]\nscene = \"tactile-two-contacts\"\nseeds = \"1:60\"\n[sweep.vary]\n"
                              "\"effect.noise.sd_N\" = [0.005, 0.03]\n";

class SweepCommand : public testing::Test {
protected:
    ProgramResult sweep(const std::string& text, std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"sweep", m_folder.write("sweep.toml", text), "--out",
                                     m_folder.path("out")};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    }
    std::string out(const std::string& name) const { return readAll(m_folder.path("out/" + name)); }

    TemporaryFolder m_folder;
};

} // namespace

TEST_F(SweepCommand, writesRunsCellsFiguresAndHowToRepeatIt) {
    const ProgramResult result = sweep(kSmall, {"--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto runs = splitCsv(out("runs.csv"));
    ASSERT_EQ(runs.size(), 7U);
    EXPECT_EQ((std::vector<std::string>(runs[0].begin(), runs[0].begin() + 7)),
              (std::vector<std::string>{"run", "cell", "seed", "duration_s", "effect.noise.sd_N", "status",
                                        "reason"}));
    EXPECT_EQ((std::vector<std::string>(runs[5].begin(), runs[5].begin() + 7)),
              (std::vector<std::string>{"4", "1", "2", "1.2", "0.05", "ok", ""}));
    EXPECT_EQ(runs[0].back(), "processor_s");
    const json document = json::parse(result.out);
    EXPECT_EQ(document["done"], 6);
    EXPECT_EQ(document["cells"][1]["settings"]["effect.noise.sd_N"], 0.05);
    EXPECT_EQ(document["cells"][1]["measures"]["frames"]["mean"], 240.0);
    EXPECT_TRUE(std::filesystem::exists(m_folder.path("out/figures/contact_error_mean_m.svg")));
    EXPECT_EQ(json::parse(out("sweep.json"))["text"], kSmall);

    // The same command has nothing left to do and writes the same again.
    const std::string before = out("runs.csv");
    EXPECT_EQ(sweep(kSmall).exitCode, 0);
    EXPECT_EQ(out("runs.csv"), before);
    const ProgramResult status = run({"sweep", "--status", m_folder.path("out"), "--json"});
    EXPECT_EQ(json::parse(status.out), document) << status.err;
}

TEST_F(SweepCommand, refusesAChangedFileUntilItIsToldToBeginAnew) {
    ASSERT_EQ(sweep(kSmall).exitCode, 0);
    const std::string changed = std::string(kSmall).replace(std::string(kSmall).find("1:3"), 3, "1:4");
    const ProgramResult refused = sweep(changed);
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_NE(refused.err.find("1:4"), std::string::npos) << refused.err;
    EXPECT_EQ(sweep(changed, {"--restart"}).exitCode, 0);
    EXPECT_EQ(splitCsv(out("runs.csv")).size(), 9U);
}

TEST_F(SweepCommand, goesOnAfterAKillWithTheSameResult) {
    ASSERT_EQ(sweep(kLong, {"--workers", "2"}).exitCode, 0);
    const std::string cells = out("cells.csv");
    const std::string file = m_folder.path("sweep.toml");
    const std::string folder = m_folder.path("killed");
    // Rows are written after five seconds at the latest: kill it soon after the first ones.
    {
        RunningProgram program({"sweep", file, "--out", folder, "--workers", "1"});
        while (!program.ended() && !(std::filesystem::exists(folder + "/parts/0000.csv") &&
                                     std::filesystem::file_size(folder + "/parts/0000.csv") > 0))
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        program.send(SIGKILL);
        EXPECT_EQ(program.wait().exitCode, -SIGKILL);
    }
    const ProgramResult status = run({"sweep", "--status", folder, "--json"});
    ASSERT_EQ(status.exitCode, 0) << status.err;
    EXPECT_GT(json::parse(status.out)["done"], 0);
    EXPECT_LT(json::parse(status.out)["done"], 120);
    const ProgramResult rest = run({"sweep", file, "--out", folder});
    ASSERT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_EQ(readAll(folder + "/cells.csv"), cells);
}

TEST_F(SweepCommand, letsRunsEndWhenItIsInterrupted) {
    const std::string file = m_folder.write("sweep.toml", kLong);
    RunningProgram program({"sweep", file, "--out", m_folder.path("out"), "--workers", "1"});
    while (!program.ended() && !std::filesystem::exists(m_folder.path("out/sweep.json")))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    program.send(SIGINT);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exitCode, 1);
    const auto runs = splitCsv(out("runs.csv"));
    EXPECT_GT(runs.size(), 1U);
    EXPECT_LT(runs.size(), 121U);
    for (std::size_t i = 1; i < runs.size(); ++i)
        EXPECT_EQ(runs[i][4], "ok");
}

TEST_F(SweepCommand, countsFailedRunsAgainstWhatIsAllowed) {
    ASSERT_EQ(sweep(kSmall).exitCode, 0);
    // As if one run had failed.
    m_folder.write("out/parts/0000.csv",
                   "run,status,reason,wall_s,processor_s,frames\n0,failed,\"lost, all of it\",1,1,NA\n"
                   "1,ok,,1,1,240\n2,ok,,1,1,240\n3,ok,,1,1,240\n4,ok,,1,1,240\n5,ok,,1,1,240\n");
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.path("out/parts")))
        if (entry.path().filename() != "0000.csv")
            std::filesystem::remove(entry.path());
    const ProgramResult failed = sweep(kSmall, {"--merge"});
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_NE(failed.err.find("1 of 6 runs failed"), std::string::npos) << failed.err;
    EXPECT_EQ(sweep(kSmall, {"--merge", "--allow-failed", "0.2"}).exitCode, 0);
    EXPECT_NE(out("runs.csv").find("failed,\"lost, all of it\""), std::string::npos);
}

TEST_F(SweepCommand, keepsWhatItHasWhenTheDiskIsFull) {
    const std::string small = m_folder.path("small");
    std::filesystem::create_directory(small);
    if (mount("tmpfs", small.c_str(), "tmpfs", 0, "size=28k") != 0)
        GTEST_SKIP() << "no file system can be mounted here";
    const std::string text = std::string(kLong).replace(std::string(kLong).find("1:60"), 4, "1:15");
    const std::string file = m_folder.write("sweep.toml", text);
    const ProgramResult full = run({"sweep", file, "--out", small + "/s"});
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_NE(full.err.find(small), std::string::npos) << full.err;
    // With room again the same command goes on.
    EXPECT_EQ(mount("tmpfs", small.c_str(), "tmpfs", MS_REMOUNT, "size=8m"), 0);
    const ProgramResult rest = run({"sweep", file, "--out", small + "/s"});
    EXPECT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_EQ(splitCsv(readAll(small + "/s/runs.csv")).size(), 31U);
    umount(small.c_str());
}

TEST_F(SweepCommand, writesFramesThatNumpyReads) {
    const ProgramResult result = sweep(kSmall, {"--frames", "npz", "--workers", "1"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string check = m_folder.write("check.py", R"(
import numpy, sys
a = numpy.load(sys.argv[1])
n, m = len(a["frames"]), len(a["contact_force_N"])
assert a["frames"].shape == (6 * 240, 84) and a["frames"].dtype == numpy.float32
assert list(a["layout"]) == [6, 14] and a["pitch_m"] == 0.0034
assert sorted(set(zip(a["cell"], a["seed"]))) == [(c, s) for c in (0, 1) for s in (1, 2, 3)]
b = a["contact_begin"]
assert len(b) == n + 1 and b[0] == 0 and b[-1] == m and (numpy.diff(b) >= 0).all() and m > 100
assert a["contact_place_m"].shape == (m, 2) and a["contact_normal"].shape == (m, 3)
# Frames with a contact are those that carry load; the noise is 0.05 N at most.
loaded = numpy.diff(b) > 0
assert a["frames"][loaded].sum(1).max() > 2.0
assert abs(numpy.median(a["frames"][~loaded])) < 0.2
)");
    EXPECT_EQ(std::system(("/usr/bin/python3 " + check + " " + m_folder.path("out/frames/0000.npz")).c_str()),
              0);
    EXPECT_EQ(run({"features", m_folder.path("out/frames/0000.npz"), "--rate", "200"}).exitCode, 0);
    EXPECT_EQ(run({"sweep", m_folder.write("arm.toml", "[sweep]\nscene = \"teleta-touch\"\n"), "--out",
                   m_folder.path("arm"), "--frames", "npz"})
                  .exitCode,
              2);
}

// The example of the handbook, as it is printed there, on a small result.
TEST_F(SweepCommand, writesFramesFromWhichTheHandbooksExampleLearns) {
    std::string example;
    for (const char* language : {"en", "fr", "ja", "zh_CN"}) {
        std::istringstream page(
            readAll(std::string(TELETA_SOURCE_DIR "/resources/handbook/") + language + "/sweeps.md"));
        std::string line, block;
        while (std::getline(page, line) && line != "    import csv")
            ;
        do
            block += (line.starts_with("    ") ? line.substr(4) : line) + "\n";
        while (std::getline(page, line) && (line.empty() || line.starts_with("    ")));
        EXPECT_GT(block.size(), 500U) << language;
        if (example.empty())
            example = block;
        EXPECT_EQ(block, example) << language;
    }
    const ProgramResult made = run({"sweep",
                                    m_folder.write("sweep.toml", "[sweep]\nscene = \"tactile-two-contacts\"\n"
                                                                 "seeds = \"1:4\"\n"),
                                    "--out", m_folder.path("frames"), "--frames", "npz"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const std::string learn = m_folder.write("learn.py", example);
    ASSERT_EQ(
        std::system(("cd " + m_folder.path("") + " && /usr/bin/python3 " + learn + " > learned.txt").c_str()),
        0);
    std::istringstream said(readAll(m_folder.path("learned.txt")));
    double centroid_mm = 0.0, learned_mm = 0.0;
    std::string name, unit;
    ASSERT_TRUE(said >> name >> centroid_mm >> unit && name == "centroid:") << said.str();
    ASSERT_TRUE(said >> name >> learned_mm >> unit && name == "learned:") << said.str();
    // Half the length of the array is 24 mm.
    EXPECT_GT(learned_mm, 0.0);
    EXPECT_LT(learned_mm, centroid_mm) << said.str();
    EXPECT_LT(centroid_mm, 5.0);
}

TEST_F(SweepCommand, waitsForASchedulerThatDoesNotAnswerForAWhile) {
    ASSERT_EQ(sweep(kSmall).exitCode, 0);
    const auto program = [&](const std::string& name, const std::string& text) {
        std::filesystem::permissions(m_folder.write("bin/" + name, "#!/bin/sh\n" + text),
                                     std::filesystem::perms::owner_all);
    };
    std::filesystem::create_directory(m_folder.path("bin"));
    program("sbatch", "echo \"$@\" >> " + m_folder.path("asked") + "\necho 7\n");
    program("squeue", "echo x >> " + m_folder.path("looks") + "\n[ $(wc -l < " + m_folder.path("looks") +
                          ") -gt 2 ] || { echo 'slurm_load_jobs error: busy' >&2; exit 1; }\n");
    const std::vector<std::string> command{"sweep",          m_folder.path("sweep.toml"),
                                           "--out",          m_folder.path("out"),
                                           "--slurm",        "--wait",
                                           "--allow-failed", "0.25"};
    const std::vector<std::pair<std::string, std::string>> path{
        {"PATH", m_folder.path("bin") + ":/usr/bin:/bin"}};
    const ProgramResult result = run(command, {.environment = path, .outPath = {}});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.err.find("busy; asking again (2 of 9)"), std::string::npos) << result.err;
    EXPECT_NE(readAll(m_folder.path("asked")).find("--merge --allow-failed 0.25"), std::string::npos);
}

TEST_F(SweepCommand, saysWhatIsWrongAndWhatThereIs) {
    EXPECT_EQ(run({"sweep"}).exitCode, 2);
    EXPECT_EQ(run({"sweep", "contour-ladder"}).exitCode, 2);
    const ProgramResult unknown = run({"sweep", "no-such", "--out", m_folder.path("out")});
    EXPECT_NE(unknown.exitCode, 0);
    EXPECT_NE(unknown.err.find("contour-ladder"), std::string::npos) << unknown.err;
    const ProgramResult measure =
        sweep(std::string("[sweep]\nmeasures = [\"contact_eror_mean_m\"]\n") + (kSmall + 8));
    EXPECT_NE(measure.exitCode, 0);
    EXPECT_NE(measure.err.find("contact_error_mean_m"), std::string::npos) << measure.err;
    EXPECT_NE(measure.err.find("sweep.toml:2:"), std::string::npos) << measure.err;
}
