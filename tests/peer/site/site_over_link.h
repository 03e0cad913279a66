// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/site_keys/site_keys.h"
#include "delay_line.h"

#include <QDeadlineTimer>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <memory>
#include <optional>
#include <sched.h>
#include <string>
#include <sys/prctl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace teleta::test {

inline constexpr int kLinkPatience_ms = 20'000;
inline constexpr double kLinkDelay_s = 0.02;

/// A program at one end of the link; killed with the object.
class LinkProgram {
public:
    LinkProgram(const peer::DelayLine& line, peer::DelayLine::End end, const QString& program,
                const QStringList& arguments) {
        const int network = line.networkOf(end);
        m_process.setChildProcessModifier([network] {
            prctl(PR_SET_PDEATHSIG, SIGKILL); // it ends with the test
            if (setns(network, CLONE_NEWNET) != 0)
                _exit(99);
        });
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(program, arguments);
    }
    ~LinkProgram() {
        m_process.kill();
        m_process.waitForFinished(kLinkPatience_ms);
    }
    LinkProgram(const LinkProgram&) = delete;
    LinkProgram& operator=(const LinkProgram&) = delete;

    /// The next line that contains this text; nothing when the program ends or is silent.
    [[nodiscard]] std::optional<std::string> waitFor(const std::string& text) {
        for (QDeadlineTimer deadline(kLinkPatience_ms);;) {
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
    [[nodiscard]] std::pair<int, std::string> wait(int longest_ms = kLinkPatience_ms) {
        if (!m_process.waitForFinished(longest_ms))
            return {-1, "it does not end"};
        return {m_process.exitCode(), m_process.readAllStandardOutput().toStdString()};
    }
    void say(const std::string& line) {
        m_process.write((line + '\n').c_str());
        m_process.waitForBytesWritten(kLinkPatience_ms);
    }
    /// Sends it a signal, or ends it by one.
    void send(int signal) const { (void)::kill(static_cast<pid_t>(m_process.processId()), signal); }
    /// Ends it in good order.
    void end() {
        m_process.terminate();
        m_process.waitForFinished(kLinkPatience_ms);
    }

private:
    QProcess m_process;
};

/// A site at one end of a link of 20 ms and 1 % loss, consoles at the other one, with certificates. Needs
/// root.
class SiteOverLink : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        m_folder = std::make_unique<QTemporaryDir>();
        const auto commands = site_keys::commandsFor({.folder = m_folder->filePath("keys").toStdString(),
                                                      .site = "lab",
                                                      .consoles = {"console1", "console2"},
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

    /// The link and the files of the consoles. Skips the test without the rights. seed: of what is lost.
    void connect(std::uint64_t seed = 1) {
        try {
            m_line = std::make_unique<peer::DelayLine>(seed);
        } catch (const std::system_error& error) {
            GTEST_SKIP() << "needs root and /dev/net/tun: " << error.what();
        }
        setBoth({.delay_s = kLinkDelay_s, .loss = 0.01});
        for (const char* name : {"console1", "console2", "viewer1"})
            std::ofstream(path(std::string(name) + ".toml"))
                << "kind = \"remote_site\"\nname = \"lab\"\nconsole = \"" << name
                << "\"\nviewer = " << (std::string(name) == "viewer1" ? "true" : "false") << '\n'
                << meeting(name, peer::DelayLine::A);
    }
    /// devices: the [[device]] tables.
    void startSite(const std::string& devices) {
        std::ofstream(path("site.toml")) << "kind = \"site\"\nname = \"lab\"\n"
                                         << meeting("site", peer::DelayLine::B) << devices;
        m_site = std::make_unique<LinkProgram>(
            *m_line, peer::DelayLine::A, QStringLiteral(TELETA_SITE_PROGRAM),
            QStringList{QString::fromStdString(path("site.toml")), QStringLiteral("--json"),
                        QStringLiteral("--state"), m_folder->path()});
        ASSERT_TRUE(m_site->waitFor("\"ready\""));
    }

    [[nodiscard]] static std::string path(const std::string& name) {
        return m_folder->filePath(QString::fromStdString(name)).toStdString();
    }
    [[nodiscard]] std::string meeting(const std::string& member, peer::DelayLine::End peer) const {
        return "[operator]\ndomain = 110\ninterface = \"tun0\"\npeers = [\"" +
               peer::DelayLine::addressOf(peer) + "\"]\nsecurity = \"certificates\"\ncertificates = \"" +
               path("keys/" + member) + "\"\n";
    }
    void setBoth(const peer::LinkConditions& conditions) {
        for (const peer::DelayLine::End end : {peer::DelayLine::A, peer::DelayLine::B})
            m_line->set(end, conditions);
    }

    static inline std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<peer::DelayLine> m_line;
    std::unique_ptr<LinkProgram> m_site;
};

} // namespace teleta::test
