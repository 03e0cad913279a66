// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_folder.h"
#include "backend/sweep/sweep_runner.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <sys/resource.h>

using namespace teleta;
using test::readAll;
using test::TemporaryFolder;

namespace {

/// Runs with two small frames and so many measures that their rows take more room than their frames.
class FramedRuns : public sweep::SweepSubject {
public:
    static constexpr std::size_t kMeasures = 2000;

    [[nodiscard]] std::unique_ptr<sweep::SweepWorker> makeWorker() const override {
        return std::make_unique<Worker>();
    }
    [[nodiscard]] std::string source() const override { return "framed"; }
    [[nodiscard]] bool hasFrames() const override { return true; }

private:
    class Worker : public sweep::SweepWorker {
    public:
        core::Expected<sweep::RunMeasures>
        run(const sweep::SweepPlan&, std::uint64_t, std::uint64_t seed,
            const std::function<void(const scene_run::LabelledFrame&)>& onFrame) override {
            const std::array<float, 4> values{};
            for (int i = 0; onFrame && i < 2; ++i)
                onFrame({0.1 * i, values, {}});
            sweep::RunMeasures measures;
            for (std::size_t i = 0; i < kMeasures; ++i)
                measures.emplace_back("m" + std::to_string(i), static_cast<double>(seed) + 1.0 / 3.0);
            return measures;
        }
        std::optional<core::ArrayLayout> layoutOf(const sweep::SweepPlan&, std::uint64_t) override {
            return core::ArrayLayout{2, 2};
        }
    };
};

sweep::SweepPlan framedPlan() {
    return *sweep::parseSweepPlan("[sweep]\nscene = \"framed\"\nseeds = \"1:3\"\n", "framed.toml");
}

bool runsIn(const std::string& folder) {
    sweep::SweepOptions options;
    options.folder = folder;
    options.workers = 1;
    options.frames = true;
    return sweep::runSweep(framedPlan(), FramedRuns(), options).has_value();
}

/// The kernel ends the process when it writes the rows, which are larger than a file may be, after the
/// frames, which are not.
[[noreturn]] void dieBetweenFramesAndRows(const std::string& folder) {
    const rlimit most{50'000, 50'000};
    setrlimit(RLIMIT_FSIZE, &most);
    const rlimit noDump{0, 0};
    setrlimit(RLIMIT_CORE, &noDump);
    std::signal(SIGXFSZ, SIG_DFL);
    runsIn(folder);
    std::_Exit(0);
}

} // namespace

TEST(SweepFramesDeathTest, areThereOnceAfterAKillBetweenFramesAndRows) {
    const TemporaryFolder temporary;
    const sweep::SweepFolder folder{temporary.path("s"), "framed", "1", true};
    ASSERT_TRUE(folder.open(framedPlan(), false));
    EXPECT_EXIT(dieBetweenFramesAndRows(folder.folder), testing::KilledBySignal(SIGXFSZ), "");
    ASSERT_TRUE(std::filesystem::exists(folder.folder + "/frames/0000.npz"));
    ASSERT_EQ(std::filesystem::file_size(folder.folder + "/parts/0000.csv"), 0U);

    ASSERT_TRUE(runsIn(folder.folder));
    const auto results = folder.merge(framedPlan());
    ASSERT_TRUE(results) << describe(results.error());
    EXPECT_EQ(results->done, 3U);
    EXPECT_EQ(readAll(folder.folder + "/frames.csv"),
              "run,file\n0,frames/0001.npz\n1,frames/0001.npz\n2,frames/0001.npz\n");
    EXPECT_FALSE(std::filesystem::exists(folder.folder + "/frames/0000.npz"));
    EXPECT_TRUE(std::filesystem::exists(folder.folder + "/frames/0001.npz"));
}
