// SPDX-License-Identifier: GPL-3.0-or-later
// teleta-site with a robot of Fast DDS and MuJoCo at 1 kHz, and a console that moves it, for an hour.
// TELETA_SOAK_S sets another time in seconds. It prints a row a minute.
#include "backend/core/quantile.h"
#include "robot_fixture.h"
#include "tests/peer/site/site_process.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace teleta {
namespace {

using namespace std::chrono_literals;
using site::Mode;
using test::PeerProcess;
using test::SiteProcess;
using test::TestConsole;

constexpr int kHour_s = 3600;
constexpr int kLook_s = 2;
constexpr int kRow_s = 60;
/// Memory is judged only after the programs have filled their buffers once.
constexpr int kWarmUp_s = 300;
constexpr double kGrowth = 0.05;
constexpr double kPress_radPerS = 0.05;
/// The robot writes on while the console is asked.
constexpr std::int64_t kBetweenCounts = 500;

double memory_MiB(qint64 process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmRSS:"))
            return std::stod(line.substr(6)) / 1024.0;
    }
    return 0.0;
}

class SiteSoak : public RosArmPeer {
protected:
    json tell() {
        m_console.say("tell");
        const auto line = m_console.waitFor("{");
        EXPECT_TRUE(line) << m_console.errors();
        (void)m_console.takeLines();
        return line ? json::parse(*line) : json::object();
    }
    /// Joint states that the robot has written since it began.
    std::int64_t written() {
        m_robot.say("counts");
        const auto line = m_robot.waitFor("done");
        EXPECT_TRUE(line);
        return line ? json::parse(line->substr(5))["joint_states"].get<std::int64_t>() : 0;
    }

    PeerProcess m_console;
};

TEST_F(SiteSoak, anHourAtFullRateIsWithoutFaultAndMemoryIsFlat) {
    const char* wanted = std::getenv("TELETA_SOAK_S");
    const int duration_s = wanted != nullptr ? std::max(10, std::atoi(wanted)) : kHour_s;
    start(126, {"--rate", "1000", "--pad"}, duration_s + 300);
    writeFile("", "announce = false\n");
    writeBeside("pad.toml", "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\n"
                            "format = \"Float64MultiArray\"\nrows = 14\ncols = 6\npitch_mm = 3.4\n"
                            "rate_Hz = 100\n[ros]\ndomain = 126\ninterface = \"lo\"\n");
    SiteProcess site(127, "[[device]]\nfile = \"" + path() + "\"\n[[device]]\nid = \"pad\"\ntaxels = \"" +
                              m_folder.filePath("pad.toml").toStdString() + "\"\n");
    site.start();
    m_console.start(QStringLiteral(TELETA_SITE_CONSOLE), {QString::fromStdString(site.fileOf("a"))});
    ASSERT_TRUE(m_console.waitFor("ready")) << m_console.errors();
    m_console.say("request");
    ASSERT_TRUE(TestConsole::eventually([&] { return tell()["controls"].get<bool>(); }));

    const std::int64_t writtenBefore = written();
    m_console.say("count");
    (void)tell();
    std::vector<double> siteMemory_MiB;
    std::vector<double> consoleMemory_MiB;
    std::map<int, int> looksInMode;
    int moved = 0;
    double angle = 0.0;
    const auto begin = std::chrono::steady_clock::now();
    const auto elapsed_s = [&] {
        return static_cast<int>(
            std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - begin)
                .count());
    };
    for (int row_s = 0; elapsed_s() < duration_s;) {
        // Back and forth; a press that was held because this machine was busy is let go as well.
        m_console.say("press " + std::to_string(angle > 0.0 ? -kPress_radPerS : kPress_radPerS));
        std::this_thread::sleep_for(std::chrono::seconds(kLook_s));
        m_console.say("let_go");
        std::this_thread::sleep_for(500ms);
        const json told = tell();
        ++looksInMode[told["mode"].get<int>()];
        moved += std::abs(told["angle"].get<double>() - angle) > 0.01 ? 1 : 0;
        angle = told["angle"];
        siteMemory_MiB.push_back(site.memory_MiB());
        consoleMemory_MiB.push_back(memory_MiB(m_console.processId()));
        ASSERT_GT(siteMemory_MiB.back(), 0.0) << "the site has ended after " << elapsed_s() << " s";
        ASSERT_TRUE(told["reached"].get<bool>()) << elapsed_s() << " s";
        ASSERT_TRUE(told["controls"].get<bool>()) << elapsed_s() << " s";
        if (elapsed_s() >= row_s) {
            std::printf(
                "%5d s: site %.1f MiB, console %.1f MiB, joint samples %llu, lost %llu, refused %llu\n",
                elapsed_s(), siteMemory_MiB.back(), consoleMemory_MiB.back(),
                told["joints"]["samples"].get<unsigned long long>(),
                told["joints"]["lost"].get<unsigned long long>(), told["refused"].get<unsigned long long>());
            std::fflush(stdout);
            row_s += kRow_s;
        }
    }
    const std::int64_t writtenAfter = written();
    const json told = tell();
    const auto samples = told["joints"]["samples"].get<std::int64_t>();
    const auto lost = told["joints"]["lost"].get<std::int64_t>();
    const std::int64_t untold = writtenAfter - writtenBefore - samples - lost;
    std::printf("%d s: the robot wrote %lld joint states; %lld came, %lld are told as lost, %lld are missing "
                "besides; moved in %d of %zu presses\n",
                elapsed_s(), static_cast<long long>(writtenAfter - writtenBefore),
                static_cast<long long>(samples), static_cast<long long>(lost), static_cast<long long>(untold),
                moved, siteMemory_MiB.size());
    for (const auto& [mode, looks] : looksInMode)
        std::printf("mode %d at %d looks\n", mode, looks);

    EXPECT_EQ(looksInMode.count(static_cast<int>(Mode::fault)), 0U);
    EXPECT_EQ(looksInMode.count(static_cast<int>(Mode::stopped)), 0U);
    EXPECT_GT(2 * moved, static_cast<int>(siteMemory_MiB.size()));
    EXPECT_LE(std::abs(untold), kBetweenCounts);
    if (duration_s < 3 * kWarmUp_s)
        GTEST_SKIP() << "memory is judged in a run of at least " << 3 * kWarmUp_s << " s only";
    for (const auto* memory : {&siteMemory_MiB, &consoleMemory_MiB}) {
        const auto warm =
            memory->begin() + static_cast<std::ptrdiff_t>(memory->size()) * kWarmUp_s / duration_s;
        const auto part = (memory->end() - warm) / 3;
        const double before_MiB = core::medianOf(std::vector<double>(warm, warm + part));
        const double after_MiB = core::medianOf(std::vector<double>(memory->end() - part, memory->end()));
        std::printf("%s: %.2f MiB after warm-up, %.2f MiB at the end\n",
                    memory == &siteMemory_MiB ? "site" : "console", before_MiB, after_MiB);
        EXPECT_LT(after_MiB, (1.0 + kGrowth) * before_MiB);
    }
}

} // namespace
} // namespace teleta
