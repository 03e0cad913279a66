// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/site_keys/site_keys.h"
#include "devices/site/remote/remote_arm.h"
#include "devices/site/site_client.h"
#include "tests/support/peer_process.h"

#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::test {

/// teleta-site in a process of its own, with the files for it and for its consoles, in a domain on the
/// loopback interface.
class SiteProcess {
public:
    /// devices: the [[device]] tables. domain: no other test's.
    SiteProcess(int domain, const std::string& devices)
        : m_domain(domain) {
        setDevices(devices);
    }

    /// Makes keys for it and for these consoles. Before setDevices().
    void secure(const std::vector<std::string>& consoles, const std::vector<std::string>& viewers) {
        m_keys = m_folder.filePath("keys").toStdString();
        const auto commands = site_keys::commandsFor(
            {.folder = m_keys, .site = "lab", .consoles = consoles, .viewers = viewers}, std::time(nullptr));
        ASSERT_TRUE(commands) << core::describe(commands.error());
        QProcess shell;
        shell.setProcessChannelMode(QProcess::MergedChannels);
        shell.start("/bin/sh", {"-ec", QString::fromStdString(*commands)});
        ASSERT_TRUE(shell.waitForFinished(60'000));
        ASSERT_EQ(shell.exitCode(), 0) << shell.readAll().toStdString();
    }

    /// Before start().
    void setDevices(const std::string& devices) {
        std::ofstream file(m_folder.filePath("site.toml").toStdString());
        file << "kind = \"site\"\nname = \"lab\"\nsupervisors = [\"boss\"]\n"
             << m_keysOfFile << (m_recordings.isEmpty() ? "" : "record = true\n") << meeting("site")
             << devices;
    }
    /// More lines of the file, before its tables. Before setDevices().
    void setKeysOfFile(const std::string& lines) { m_keysOfFile = lines; }
    /// It records there. Before setDevices().
    void recordInto(const QString& folder) { m_recordings = folder; }

    void start() {
        QStringList arguments{m_folder.filePath("site.toml"), "--json", "--state", m_folder.path()};
        if (!m_recordings.isEmpty())
            arguments << "--recordings" << m_recordings;
        m_process.start(QStringLiteral(TELETA_SITE_PROGRAM), arguments, true);
        ASSERT_TRUE(m_process.waitFor("\"ready\""));
        m_id = m_process.processId();
    }
    void kill() { m_process.kill(); }
    /// Whether its log had a line with this text until it was ready.
    [[nodiscard]] bool said(const std::string& text) {
        return std::ranges::any_of(m_process.takeLines(), [&text](const std::string& line) {
            return line.find(text) != std::string::npos;
        });
    }
    /// Waits until its log has a line with this text.
    [[nodiscard]] bool says(const std::string& text) { return m_process.waitFor(text).has_value(); }
    void send(int signal) const { ASSERT_EQ(::kill(static_cast<pid_t>(m_id), signal), 0); }

    /// The file with which a console reaches it.
    [[nodiscard]] std::string fileOf(const std::string& console, bool viewer = false,
                                     const std::string& person = {}) const {
        const std::string path = m_folder.filePath(QString::fromStdString(console) + ".toml").toStdString();
        std::ofstream(path) << "kind = \"remote_site\"\nname = \"lab\"\nconsole = \"" << console << "\"\n"
                            << (person.empty() ? std::string() : "person = \"" + person + "\"\n")
                            << "viewer = " << (viewer ? "true" : "false") << '\n'
                            << meeting(console);
        return path;
    }
    /// After secure(): makes the certificate of a member anew, for so many days.
    void renew(const std::string& member, int days) const {
        QProcess shell;
        shell.setWorkingDirectory(QString::fromStdString(m_keys));
        shell.start("openssl",
                    {"x509", "-req", "-sha256", "-in", QString::fromStdString(member + "/req.pem"), "-CA",
                     "identity_ca.pem", "-CAkey", "identity_ca_key.pem", "-CAcreateserial", "-days",
                     QString::number(days), "-out", QString::fromStdString(member + "/cert.pem")});
        ASSERT_TRUE(shell.waitForFinished(60'000));
        ASSERT_EQ(shell.exitCode(), 0) << shell.readAllStandardError().toStdString();
    }
    [[nodiscard]] QTemporaryDir& folder() { return m_folder; }
    [[nodiscard]] qint64 processId() const { return m_id; }
    /// Memory that it holds; 0: it does not run.
    [[nodiscard]] double memory_MiB() const {
        std::ifstream status("/proc/" + std::to_string(m_id) + "/status");
        for (std::string line; std::getline(status, line);) {
            if (line.starts_with("VmRSS:"))
                return std::stod(line.substr(6)) / 1024.0;
        }
        return 0.0;
    }

private:
    [[nodiscard]] std::string meeting(const std::string& member) const {
        return "[operator]\ndomain = " + std::to_string(m_domain) + "\ninterface = \"lo\"\nsecurity = " +
               (m_keys.empty() ? std::string("\"none\"\n")
                               : "\"certificates\"\ncertificates = \"" + m_keys + '/' + member + "\"\n");
    }

    int m_domain;
    std::string m_keys; ///< folder of the keys; empty: it has none
    QString m_recordings;
    std::string m_keysOfFile;
    QTemporaryDir m_folder;
    PeerProcess m_process;
    qint64 m_id = 0;
};

/// A console at that site, with an operator's hand on one arm. Commands are given by a thread of its own, as
/// a view does while a key is held.
class TestConsole {
public:
    TestConsole(const SiteProcess& site, const std::string& name, bool viewer = false)
        : TestConsole(site.fileOf(name, viewer)) {}
    /// path: of its file.
    explicit TestConsole(const std::string& path) {
        auto file = site_link::readRemoteSite(path);
        EXPECT_TRUE(file) << core::describe(file.error());
        m_name = file->console;
        auto client = site_link::SiteClient::open(*file, "test", m_stop);
        EXPECT_TRUE(client) << core::describe(client.error());
        m_client = *client;
        for (const recording::StreamInfo& stream : m_client->streams()) {
            if (stream.kind != recording::StreamKind::joints)
                continue;
            auto described = pipeline::recordedArm(stream, "lab");
            EXPECT_TRUE(described);
            const std::string arm = stream.name.substr(0, stream.name.find('-'));
            m_arm = std::move(*site_link::RemoteArm::open(m_client, arm, described->description, false));
        }
        m_arm->start(m_wakeup);
    }
    ~TestConsole() {
        letGo();
        m_arm->stop();
    }

    [[nodiscard]] site_link::SiteClient& client() { return *m_client; }
    [[nodiscard]] const std::shared_ptr<site_link::SiteClient>& sharedClient() const { return m_client; }
    [[nodiscard]] site_link::SiteView view() const { return m_client->view(); }
    [[nodiscard]] core::StopSwitch& stop() { return m_stop; }
    [[nodiscard]] std::string hindrance() const { return m_arm->hindrance(); }
    [[nodiscard]] bool controls() const { return view().controls(m_name); }

    /// Waits at most 10 s until it holds.
    template <typename Holds>
    [[nodiscard]] static bool eventually(const Holds& holds) {
        using Clock = std::chrono::steady_clock;
        for (const auto end = Clock::now() + std::chrono::seconds(10); Clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(5))) {
            if (holds())
                return true;
        }
        return false;
    }

    std::uint64_t request(site::RequestKind kind, const std::string& target = {}) {
        return m_client->request(kind, target);
    }
    /// The same, and waits for the answer.
    site::RequestAnswer ask(site::RequestKind kind, const std::string& target = {}) {
        const std::uint64_t id = request(kind, target);
        (void)eventually([&] {
            const auto request = view().request;
            return request && request->id == id && request->answer != site::RequestAnswer::waits;
        });
        const auto request = view().request;
        return request && request->id == id ? request->answer : site::RequestAnswer::waits;
    }

    /// Holds the switch and asks for this rate of the second joint until letGo().
    void press(double rate_radPerS) {
        m_rate_radPerS = rate_radPerS;
        pressBy([rate_radPerS] { return rate_radPerS; });
    }
    /// The same with a rate that is asked for each time; 0: the switch is let go.
    void pressBy(std::function<double()> rate_radPerS) {
        letGo();
        m_hand = std::jthread([this, rate_radPerS = std::move(rate_radPerS)](const std::stop_token& stop) {
            core::ArmCommand command;
            command.rate_radPerS = core::JointVector::zeros(m_arm->description().joints());
            while (!stop.stop_requested()) {
                command.rate_radPerS[1] = rate_radPerS();
                command.time_ns = core::steadyNow_ns();
                m_arm->post(command);
                std::this_thread::sleep_for(std::chrono::milliseconds(15));
            }
            if (m_freezes)
                return;
            command.rate_radPerS[1] = 0.0;
            command.time_ns = core::steadyNow_ns();
            m_arm->post(command);
        });
    }
    void letGo() {
        if (!m_hand.joinable())
            return;
        m_hand.request_stop();
        m_hand.join();
    }

    /// The view hangs while the switch is held: no more commands come from it, not even that it is let go.
    void freeze() {
        m_freezes = true;
        letGo();
    }

    [[nodiscard]] core::DeviceStatus armStatus() const { return m_arm->status(); }
    /// All samples since the last call.
    [[nodiscard]] std::vector<core::JointSample> takeSamples() {
        std::vector<core::JointSample> samples;
        for (core::JointSample sample; m_arm->joints().pop(sample);)
            samples.push_back(sample);
        if (!samples.empty())
            m_newest = samples.back();
        return samples;
    }
    /// That of the second joint in the newest sample; 0 before the first one.
    [[nodiscard]] double newestAngle() const {
        return m_newest.angle_rad.size() > 1 ? m_newest.angle_rad[1] : 0.0;
    }

    /// The newest angle of the second joint. It waits for one that was read at the site after this call.
    [[nodiscard]] double angle() {
        const std::int64_t from_ns = core::steadyNow_ns();
        EXPECT_TRUE(eventually([&] {
            take();
            return m_newest.time_ns > from_ns;
        }));
        return m_newest.angle_rad[1];
    }
    /// Whether the joint stays where it is for so long.
    [[nodiscard]] bool rests(std::chrono::milliseconds time, double tolerance_rad = 1e-3) {
        const double from = angle();
        for (const auto end = std::chrono::steady_clock::now() + time;
             std::chrono::steady_clock::now() < end;) {
            if (std::abs(angle() - from) > tolerance_rad)
                return false;
        }
        return true;
    }
    /// Whether it moves by this. On a busy machine a command may come so late that the arm is held; then the
    /// switch has to be pressed anew.
    [[nodiscard]] bool moves(double by_rad = 0.02) {
        using Clock = std::chrono::steady_clock;
        constexpr int kPresses = 10;
        const double from = angle();
        for (int presses = 0; presses < kPresses; ++presses) {
            for (const auto end = Clock::now() + std::chrono::seconds(2); Clock::now() < end;) {
                if (std::abs(angle() - from) > by_rad)
                    return true;
            }
            if (m_hand.joinable())
                press(m_rate_radPerS);
        }
        return false;
    }
    /// When the joint was last farther than this from where it is now, by the clock here.
    [[nodiscard]] std::int64_t lastAway_ns(double tolerance_rad) {
        const double end = angle();
        std::int64_t last_ns = 0;
        for (const core::JointSample& sample : m_track) {
            if (std::abs(sample.angle_rad[1] - end) > tolerance_rad)
                last_ns = sample.time_ns;
        }
        return last_ns;
    }

private:
    void take() {
        for (core::JointSample sample; m_arm->joints().pop(sample);) {
            m_newest = sample;
            m_track.push_back(sample);
        }
    }

    std::string m_name;
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::shared_ptr<site_link::SiteClient> m_client;
    std::unique_ptr<site_link::RemoteArm> m_arm;
    core::JointSample m_newest;
    std::vector<core::JointSample> m_track;
    double m_rate_radPerS = 0.0; ///< that the hand asks for
    std::atomic<bool> m_freezes{false};
    std::jthread m_hand;
};

} // namespace teleta::test
