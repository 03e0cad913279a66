// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/cli/program_run.h"
#include "tests/support/peer_process.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace teleta {

using nlohmann::json;
using test::ProgramResult;

inline constexpr const char* kUrdf = TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf";
inline constexpr std::size_t kJoint =
    2; ///< joint_3, which turns the arm about its own axis when it is stretched
inline constexpr double kRate_radPerS = 0.3;
inline constexpr double kDeceleration_radPerS2 = 3.0;
inline constexpr double kFirstPoint_s = 0.04;
inline constexpr double kLease_s = 0.1;

/// A robot of Fast DDS and MuJoCo over the loopback interface, and the file with which the programs move it.
class RosArmPeer : public ::testing::Test {
protected:
    /// domain: no other test's. more: options of the robot. duration_s: it ends by itself then.
    void start(int domain, const QStringList& more = {}, int duration_s = 100) {
        m_domain = domain;
        QStringList arguments = {"--domain",     QString::number(domain),
                                 "--urdf",       QLatin1String(kUrdf),
                                 "--start-from", "desired",
                                 "--json",       m_folder.filePath("log"),
                                 "--seconds",    QString::number(duration_s),
                                 "--commands"};
        m_robot.start(QStringLiteral(TELETA_ROS_ROBOT), arguments + more, true);
        ASSERT_TRUE(m_robot.waitFor("ready"));
        writeFile("");
    }

    void writeFile(const std::string& more, const std::string& ros = {}, const std::string& limits = {}) {
        std::ofstream file(path());
        file << "kind = \"ros_arm\"\nname = \"Robot\"\nbase_frame = \"base_link\"\ntip_frame = \"tool0\"\n"
                "effort_unit = \"Nm\"\njoint_timeout_s = 0.25\n"
             << (more.find("adapter") == std::string::npos ? "controller = \"/arm_controller\"\n" : "")
             << more << "[ros]\ndomain = " << m_domain << "\ninterface = \"lo\"\n"
             << ros << "[limits]\nspeed_scale = 1.0\ntip_turn_radPerS = 1.0\n"
             << limits;
    }

    /// A file beside that of the arm.
    void writeBeside(const QString& name, const std::string& text) const {
        std::ofstream(m_folder.filePath(name).toStdString()) << text;
    }

    [[nodiscard]] std::string path() const { return m_folder.filePath("arm.toml").toStdString(); }

    [[nodiscard]] std::vector<std::string> jogArguments(double seconds) const {
        return {"arm",     "jog",       path(),
                "--joint", "joint_3",   "--rate",
                "0.3",     "--seconds", std::to_string(seconds),
                "--yes",   "--json"};
    }

    [[nodiscard]] ProgramResult check() const { return test::run({"ros", "check", path(), "--json"}); }

    static std::string resultOf(const json& rows, const std::string& name) {
        for (const json& row : rows) {
            if (row["check"] == name && row["result"] == "problem")
                return row["detail"];
        }
        return "";
    }

    std::vector<json> logOf(const std::string& event) {
        std::vector<json> found;
        std::ifstream file(m_folder.filePath("log").toStdString());
        for (std::string line; std::getline(file, line);) {
            const json one = json::parse(line, nullptr, false);
            if (!one.is_discarded() && one["event"] == event)
                found.push_back(one);
        }
        return found;
    }

    /// Waits until the robot logs something that holds, at most 30 s.
    template <typename Holds>
    bool eventually(const Holds& holds) {
        using Clock = std::chrono::steady_clock;
        for (const auto end = Clock::now() + std::chrono::seconds(30); Clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
            if (holds())
                return true;
        }
        return false;
    }

    [[nodiscard]] bool comesToMove() {
        return eventually([this] { return !logOf("trajectory").empty(); });
    }

    static double steady_s(const json& event) { return 1e-9 * event["steady_ns"].get<double>(); }

    /// When the joint was last farther than this from where it came to rest.
    double lastAway_s(double tolerance_rad) {
        const std::vector<json> states = logOf("state");
        const double end = states.back()["position"][kJoint];
        double last_s = 0.0;
        for (const json& state : states) {
            if (std::abs(state["position"][kJoint].get<double>() - end) > tolerance_rad)
                last_s = steady_s(state);
        }
        return last_s;
    }

    QTemporaryDir m_folder;
    test::PeerProcess m_robot;
    int m_domain = 0;
};

} // namespace teleta
