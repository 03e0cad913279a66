// SPDX-License-Identifier: GPL-3.0-or-later
// A site and its consoles in two network namespaces, over a link with delay and loss, with certificates. Both
// ends run on this computer, so the true offset of their clocks is 0.
#include "backend/core/steady_time.h"
#include "backend/site_keys/site_keys.h"
#include "delay_line.h"

#include <QDeadlineTimer>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <memory>
#include <optional>
#include <sched.h>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace teleta {
namespace {

using namespace std::chrono_literals;
using peer::DelayLine;

constexpr int kPatience_ms = 20'000;
constexpr double kDelay_s = 0.02;

/// A program at one end of the link; killed with the object.
class Program {
public:
    Program(const DelayLine& line, DelayLine::End end, const QString& program, const QStringList& arguments) {
        const int network = line.networkOf(end);
        m_process.setChildProcessModifier([network] {
            if (setns(network, CLONE_NEWNET) != 0)
                _exit(99);
        });
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(program, arguments);
    }
    ~Program() {
        m_process.kill();
        m_process.waitForFinished(kPatience_ms);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// The next line that contains this text; nothing when the program ends or is silent.
    [[nodiscard]] std::optional<std::string> waitFor(const std::string& text) {
        for (QDeadlineTimer deadline(kPatience_ms);;) {
            while (m_process.canReadLine()) {
                const std::string line = m_process.readLine().trimmed().toStdString();
                if (line.find(text) != std::string::npos)
                    return line;
            }
            if (deadline.hasExpired() ||
                !m_process.waitForReadyRead(static_cast<int>(deadline.remainingTime())))
                return std::nullopt;
        }
    }
    /// All that it prints until it ends, and its exit code.
    [[nodiscard]] std::pair<int, std::string> wait() {
        m_process.waitForFinished(kPatience_ms);
        return {m_process.exitCode(), m_process.readAllStandardOutput().toStdString()};
    }

private:
    QProcess m_process;
};

class SiteLink : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto commands = site_keys::commandsFor({.folder = m_folder->filePath("keys").toStdString(),
                                                      .site = "lab",
                                                      .consoles = {"console1"},
                                                      .viewers = {"viewer1"}},
                                                     std::time(nullptr));
        ASSERT_TRUE(commands);
        QProcess shell;
        shell.setProcessChannelMode(QProcess::MergedChannels);
        shell.start("/bin/sh", {"-ec", QString::fromStdString(*commands)});
        ASSERT_TRUE(shell.waitForFinished(60'000));
        ASSERT_EQ(shell.exitCode(), 0) << shell.readAll().toStdString();
    }
    static void TearDownTestSuite() { m_folder.reset(); }

    void SetUp() override {
        try {
            m_line = std::make_unique<DelayLine>();
        } catch (const std::system_error& error) {
            GTEST_SKIP() << "needs root and /dev/net/tun: " << error.what();
        }
        for (const DelayLine::End end : {DelayLine::A, DelayLine::B})
            m_line->set(end, {.delay_s = kDelay_s, .loss = 0.01});
        std::ofstream(path("site.toml")) << "kind = \"site\"\nname = \"lab\"\n"
                                         << meeting("site", DelayLine::B)
                                         << "[[device]]\nid = \"practice\"\n"
                                            "scene = \":/scenes/teleoperation.toml\"\n";
        for (const char* name : {"console1", "viewer1"})
            std::ofstream(path(std::string(name) + ".toml"))
                << "kind = \"remote_site\"\nname = \"lab\"\nconsole = \"" << name
                << "\"\nviewer = " << (std::string(name) == "viewer1" ? "true" : "false") << '\n'
                << meeting(name, DelayLine::A);
        m_site = std::make_unique<Program>(
            *m_line, DelayLine::A, QStringLiteral(TELETA_SITE_PROGRAM),
            QStringList{QString::fromStdString(path("site.toml")), QStringLiteral("--json")});
        ASSERT_TRUE(m_site->waitFor("\"ready\""));
    }

    [[nodiscard]] static std::string path(const std::string& name) {
        return m_folder->filePath(QString::fromStdString(name)).toStdString();
    }
    [[nodiscard]] std::string meeting(const std::string& member, DelayLine::End peer) const {
        return "[operator]\ndomain = 110\ninterface = \"tun0\"\npeers = [\"" + DelayLine::addressOf(peer) +
               "\"]\nsecurity = \"certificates\"\ncertificates = \"" + path("keys/" + member) + "\"\n";
    }
    [[nodiscard]] std::unique_ptr<Program> console(const QStringList& arguments) const {
        return std::make_unique<Program>(*m_line, DelayLine::B, QStringLiteral(TELETA_PROGRAM), arguments);
    }
    [[nodiscard]] static QString file(const char* name) {
        return QString::fromStdString(path(std::string(name) + ".toml"));
    }
    [[nodiscard]] std::unique_ptr<Program> jog() const {
        return console({"arm", "jog", file("console1"), "--joint", "joint_2", "--rate", "0.3", "--seconds",
                        "2", "--yes", "--json"});
    }
    /// Prints the site's state, at the site's end of the link: it does not suffer from it.
    [[nodiscard]] std::unique_ptr<Program> watch() const {
        return std::make_unique<Program>(
            *m_line, DelayLine::A, QStringLiteral(TELETA_PROGRAM),
            QStringList{QStringLiteral("site"), QStringLiteral("watch"), file("viewer1")});
    }
    void setBoth(const peer::LinkConditions& conditions) {
        for (const DelayLine::End end : {DelayLine::A, DelayLine::B})
            m_line->set(end, conditions);
    }
    static std::vector<std::string> fieldsOf(const std::string& row) {
        std::vector<std::string> fields(1);
        for (const char c : row)
            c == ',' ? fields.push_back({}) : fields.back().push_back(c);
        return fields;
    }

    static inline std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<DelayLine> m_line;
    std::unique_ptr<Program> m_site;
};

TEST_F(SiteLink, theBoundOfTheClockHoldsOverTheLink) {
    const auto [code, out] =
        console({"site", "clock", file("viewer1"), "--seconds", "6.5", "--json"})->wait();
    ASSERT_EQ(code, 0);
    const auto rows = nlohmann::json::parse(out);
    ASSERT_GE(rows.size(), 5U);
    for (const auto& row : rows) {
        EXPECT_LE(std::abs(row["offset_s"].get<double>()), row["bound_s"].get<double>()) << row;
        // Half of the way there and back at least, since how it is split cannot be seen.
        EXPECT_GE(row["bound_s"].get<double>(), kDelay_s) << row;
    }
}

TEST_F(SiteLink, anArmIsMovedOverTheLink) {
    const auto [code, out] = jog()->wait();
    ASSERT_EQ(code, 0);
    const auto told = nlohmann::json::parse(out);
    // All of 2 s at 0.3 rad/s, unless this machine was so busy that a command came too late and held the arm.
    EXPECT_GT(told["way"].get<double>(), 0.02) << out;
    EXPECT_LT(told["way"].get<double>(), 0.65) << out;
    EXPECT_FALSE(told["time_to_rest_s"].is_null()) << out;
}

TEST_F(SiteLink, aCutLinkHoldsTheArmAndABurstMovesNothing) {
    const auto watched = watch();
    ASSERT_TRUE(watched->waitFor(",free,"));
    for (const bool burst : {false, true}) {
        const auto moving = jog();
        ASSERT_TRUE(watched->waitFor(",moving,"));
        std::this_thread::sleep_for(500ms);
        const std::int64_t cut_ns = core::steadyNow_ns();
        setBoth({.delay_s = kDelay_s, .cut = !burst, .holds = burst});
        const auto held = watched->waitFor(",held,");
        ASSERT_TRUE(held);
        // What was on the way, the lease of 100 ms, the looks of the programs, and a busy machine. Control
        // lasts for 2 s.
        EXPECT_LT(core::elapsed_s(cut_ns, core::steadyNow_ns()), 1.5);
        const std::string accepted = fieldsOf(*held).at(6);
        // Longer than the control lease: the commands that come then are of nobody.
        ASSERT_TRUE(watched->waitFor(",free,"));
        std::this_thread::sleep_for(500ms);
        setBoth({.delay_s = kDelay_s});
        EXPECT_EQ(moving->wait().first, 1);
        std::this_thread::sleep_for(300ms);
        const auto after = console({"site", "watch", file("viewer1"), "--seconds", "0.5", "--json"})->wait();
        const auto rows = nlohmann::json::parse(after.second);
        ASSERT_FALSE(rows.empty());
        EXPECT_EQ(std::to_string(rows.back()["accepted"].get<int>()), accepted)
            << (burst ? "held and let go" : "cut");
    }
}

} // namespace
} // namespace teleta
