// SPDX-License-Identifier: GPL-3.0-or-later
// The joints of a Modbus device as a source, read from a server of pymodbus.
#include "app/sources/source_list.h"
#include "app/sources/source_request.h"
#include "backend/pipeline/joint_channel.h"
#include "tests/support/peer_process.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>
#include <variant>

namespace teleta::console {
namespace {

using namespace std::chrono_literals;

class ModbusSource : public ::testing::Test {
protected:
    void SetUp() override {
        m_server.start(QStringLiteral("/usr/bin/python3"),
                       {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py"), "tcp", "0"});
        const auto ready = m_server.waitFor("ready");
        ASSERT_TRUE(ready) << m_server.errors();
        m_port = ready->substr(ready->find_last_of(' ') + 1);
    }
    [[nodiscard]] std::string write(const char* name, const std::string& text) const {
        const std::string path = m_folder.filePath(QLatin1String(name)).toStdString();
        std::ofstream(path) << text;
        return path;
    }
    /// Two joints: angles in mrad in 108 and 110, torques in 10 mN m in 109 and 111.
    [[nodiscard]] std::string arm() const {
        std::string text = "kind = 'modbus'\nname = 'bench arm'\ninput_rate_Hz = 100\n[link]\nkind = 'tcp'\n"
                           "host = '127.0.0.1'\nport = " +
                           m_port + '\n';
        for (int joint = 0; joint < 2; ++joint) {
            const std::string number = std::to_string(joint);
            text += "[[input]]\nname = 'angle" + number + "'\naddress = " + std::to_string(108 + 2 * joint) +
                    "\ntype = 'int16'\nscale = 0.001\nunit = 'rad'\n[[input]]\nname = 'torque" + number +
                    "'\naddress = " + std::to_string(109 + 2 * joint) +
                    "\ntype = 'int16'\nscale = 0.01\nunit = 'N m'\n[[joint]]\nangle = 'angle" + number +
                    "'\ntorque = 'torque" + number + "'\n";
        }
        return text;
    }
    [[nodiscard]] core::Expected<std::shared_ptr<pipeline::Channel>>
    open(const app::SourceRequest& request) const {
        return app::makeSourceFactory(request, m_stop)();
    }

    QTemporaryDir m_folder;
    test::PeerProcess m_server;
    core::StopSwitch m_stop;
    std::string m_port;
};

TEST_F(ModbusSource, tellsJointsThatNothingMoves) {
    ASSERT_TRUE(m_server.command("set 108 500 123 65036 7"));
    const std::string path = write("bench.toml", arm());
    EXPECT_TRUE(app::isArmFile(path));
    EXPECT_FALSE(app::isSourceList(path));
    const std::string list = write("list.toml", "[[source]]\narm = 'bench.toml'\n");
    const auto requests = app::readSourceList(list);
    ASSERT_TRUE(requests) << core::describe(requests.error());
    const auto opened = open(requests->front());
    ASSERT_TRUE(opened) << core::describe(opened.error());
    const auto channel = std::dynamic_pointer_cast<pipeline::JointChannel>(*opened);
    ASSERT_NE(channel, nullptr);
    EXPECT_EQ(channel->summary().name, "bench arm");
    EXPECT_FALSE(channel->summary().simulated);
    EXPECT_TRUE(std::isinf(channel->description().highest_rad[1])) << "nobody told the range";
    EXPECT_EQ(channel->device().hindrance(),
              "this arm is read-only: it reports its joints but cannot be moved");
    core::Wakeup wakeup;
    channel->start(wakeup);
    core::JointSample sample;
    bool came = false;
    for (const auto end = std::chrono::steady_clock::now() + 10s;
         !came && std::chrono::steady_clock::now() < end;) {
        (void)wakeup.waitFor(20ms);
        (void)channel->process();
        came = channel->popSample(sample);
    }
    channel->stop();
    ASSERT_TRUE(came);
    EXPECT_DOUBLE_EQ(sample.angle_rad[0], 0.5);
    EXPECT_DOUBLE_EQ(sample.torque_Nm[0], 1.23);
    EXPECT_DOUBLE_EQ(sample.angle_rad[1], -0.5);
    EXPECT_DOUBLE_EQ(sample.torque_Nm[1], 0.07);
}

TEST_F(ModbusSource, aDeviceWithoutJointsSaysSo) {
    std::string text = arm();
    text.erase(text.find("[[input]]"));
    const auto opened = open(app::ArmRequest{write("driver.toml", text)});
    ASSERT_FALSE(opened);
    EXPECT_NE(core::describe(opened.error()).find("the file names no register"), std::string::npos)
        << core::describe(opened.error());
    const auto broken = open(app::ArmRequest{write("broken.toml", "kind = 'modbus'\nname = 3\n")});
    ASSERT_FALSE(broken);
    EXPECT_NE(core::describe(broken.error()).find("broken.toml:2"), std::string::npos)
        << core::describe(broken.error());
}

} // namespace
} // namespace teleta::console
