// SPDX-License-Identifier: GPL-3.0-or-later
// The devices against a server that somebody else wrote: pymodbus on loopback TCP, and on a serial line that
// socat makes of two pseudo terminals.
#include "backend/core/threads/wakeup.h"
#include "devices/modbus/input_reader.h"
#include "devices/modbus/libmodbus_link.h"
#include "devices/modbus/modbus_bracelet.h"
#include "devices/modbus/modbus_joints.h"
#include "tests/devices/manual_clock.h"
#include "tests/support/peer_process.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>

using namespace teleta;
using namespace teleta::modbus;
using core::DeviceState;
using core::WriteOutcome;
using test::eventually;
using test::PeerProcess;

namespace {

// Debian's, for which the package is installed; another one may come first in the path.
const QString kPython = QStringLiteral("/usr/bin/python3");
const QString kServer = QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py");
const std::string kZero = "write 10 0 0 0 0 0 0";
const std::string kDrivenLine = "write 10 4095 4095 4095 4095 4095 4095";
constexpr core::Drive kDriven = {4095, 4095, 4095, 4095, 4095, 4095};

const std::string kRegisters = R"(
input_rate_Hz = 50
[tactors]
address = 10
type = 'uint16'
unit = '1'
full = 4095
[watchdog]
address = 20
[[input]]
name = 'voltage'
address = 100
type = 'float32'
unit = 'V'
[[input]]
name = 'swapped'
address = 102
type = 'float32'
word_order = 'low_first'
unit = 'V'
[[input]]
name = 'position'
table = 'input'
address = 104
type = 'int32'
scale = 1e-6
unit = 'rad'
[[input]]
name = 'turned'
table = 'input'
address = 106
type = 'int32'
word_order = 'low_first'
unit = '1'
[[input]]
name = 'angle'
address = 108
type = 'int16'
scale = 0.001
unit = 'rad'
[[input]]
name = 'torque'
address = 109
type = 'int16'
scale = 0.01
unit = 'N m'
[[joint]]
angle = 'angle'
torque = 'torque'
[[joint]]
angle = 'position'
torque = 'torque'
[[joint]]
angle = 'angle'
torque = 'torque'
[[joint]]
angle = 'angle'
torque = 'torque'
)";

/// A server, and a bracelet and joints connected to it.
class ModbusPeerTest : public testing::Test {
protected:
    void SetUp() override {
        if (!test::runs(kPython, {QStringLiteral("-c"), QStringLiteral("import pymodbus.server.async_io")}))
            GTEST_SKIP() << "python3-pymodbus or python3-serial-asyncio is not installed";
    }

    void serve(const QStringList& arguments) {
        m_server.start(kPython, QStringList{kServer} + arguments);
        const auto ready = m_server.waitFor("ready ");
        ASSERT_TRUE(ready) << m_server.errors();
        m_where = ready->substr(6);
    }
    void serveTcp(const std::string& port = "0") {
        serve({QStringLiteral("tcp"), QString::fromStdString(port)});
        use("[link]\nkind = 'tcp'\nhost = '127.0.0.1'\nport = " + m_where);
    }
    void use(const std::string& link) {
        auto map = parseRegisterMap("kind = 'modbus'\nname = 'peer'\n" + kRegisters + link + '\n', "peer");
        ASSERT_TRUE(map) << describe(map.error());
        m_map = *map;
    }
    void open() {
        auto bracelet = openModbusBracelet(m_map, m_stop);
        ASSERT_TRUE(bracelet) << describe(bracelet.error());
        m_bracelet = std::move(*bracelet);
        m_bracelet->start(m_wakeup);
        ASSERT_TRUE(live());
    }
    [[nodiscard]] bool live() {
        return eventually(m_wakeup, [&] {
            return m_bracelet->status().state == DeviceState::live && m_bracelet->connection() > 0;
        });
    }
    core::WriteResult write(const core::Drive& drive) {
        return m_bracelet->write({.drive = drive, .connection = m_bracelet->connection()});
    }
    /// Lines of the server that tell of the motors, since the last call.
    std::vector<std::string> motorLines() {
        EXPECT_TRUE(m_server.command("sync")) << m_server.errors();
        std::vector<std::string> lines;
        for (const std::string& line : m_server.takeLines()) {
            if (line.starts_with("write 10 "))
                lines.push_back(line);
        }
        return lines;
    }
    /// A fault while the motors are driven: they are zeroed, the state is shown, and after the fault nothing
    /// goes on until somebody asks. message: what the state says of it; empty when the fault passes by
    /// itself.
    void expectSafeLoss(const std::string& fault, const std::string& message) {
        ASSERT_EQ(write(kDriven).outcome, WriteOutcome::written);
        const std::uint64_t connection = m_bracelet->connection();
        (void)motorLines();
        ASSERT_TRUE(m_server.command(fault));
        EXPECT_NE(m_bracelet->write({.drive = kDriven, .connection = connection}).outcome,
                  WriteOutcome::written);
        if (!message.empty()) {
            EXPECT_EQ(m_bracelet->connection(), 0U);
            const core::DeviceStatus status = m_bracelet->status();
            EXPECT_TRUE(status.state == DeviceState::lost || status.state == DeviceState::reconnecting);
            EXPECT_NE(status.message.find(message), std::string::npos) << status.message;
        }
        ASSERT_TRUE(m_server.command("fault none"));
        ASSERT_TRUE(live());
        EXPECT_EQ(m_bracelet->write({.drive = kDriven, .connection = connection}).outcome,
                  WriteOutcome::refused);
        const std::vector<std::string> lines = motorLines();
        const auto lastDriven = std::ranges::find(lines.rbegin(), lines.rend(), kDrivenLine);
        EXPECT_LE(std::ranges::count(lines, kDrivenLine), 1) << "only the one in which the fault was met";
        ASSERT_GT(lastDriven - lines.rbegin(), 0) << "zero frames came after it";
        EXPECT_EQ(std::ranges::count(lines, kZero) + std::ranges::count(lines, kDrivenLine),
                  static_cast<std::ptrdiff_t>(lines.size()));
        EXPECT_EQ(write(kDriven).outcome, WriteOutcome::written);
        EXPECT_EQ(motorLines().back(), kDrivenLine);
    }

    void expectSafeAfterNonsense() {
        ASSERT_EQ(write(kDriven).outcome, WriteOutcome::written);
        ASSERT_TRUE(m_server.command("fault garbage"));
        EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
        ASSERT_TRUE(m_server.command("fault none"));
        ASSERT_TRUE(live());
        EXPECT_EQ(motorLines().back(), kZero);
    }

    void readsEveryType() {
        for (const char* line : {"float 100 3.25", "float 102 -1e10 swapped", "int 104 -1570796",
                                 "int 106 -2147483648 swapped", "set 108 64536 250"})
            ASSERT_TRUE(m_server.command(line)) << m_server.errors();
        auto link = openLibmodbusLink(m_map);
        ASSERT_TRUE(link) << describe(link.error());
        InputReader reader(m_map.inputs);
        std::vector<double> values(reader.inputs());
        const Answer answer = reader.read(**link, values);
        ASSERT_TRUE(answer.done()) << describe(answer);
        EXPECT_EQ(values[0], 3.25);
        EXPECT_EQ(values[1], static_cast<double>(-1e10F));
        EXPECT_DOUBLE_EQ(values[2], -1.570796);
        EXPECT_EQ(values[3], -2147483648.0);
        EXPECT_DOUBLE_EQ(values[4], -1.0);
        EXPECT_DOUBLE_EQ(values[5], 2.5);
    }

    void drivesTheMotors() {
        ASSERT_TRUE(m_server.command("set 10 7 7 7 7 7 7"));
        open();
        std::vector<std::string> lines = motorLines();
        ASSERT_FALSE(lines.empty());
        for (const std::string& line : lines)
            EXPECT_EQ(line, kZero) << "what the motors did before is over";
        EXPECT_EQ(write({0, 1, 2, 2048, 4094, 4095}).outcome, WriteOutcome::written);
        lines = motorLines();
        EXPECT_NE(std::ranges::find(lines, "write 10 0 1 2 2048 4094 4095"), lines.end());
        EXPECT_GT(m_bracelet->description().maximumRate_Hz, 0.0);
        EXPECT_LE(m_bracelet->description().maximumRate_Hz, 200.0);
        const core::BraceletTelemetry telemetry = m_bracelet->telemetry();
        EXPECT_EQ(telemetry.framesEchoed, telemetry.framesWritten);
        EXPECT_EQ(telemetry.framesLost, 0U);
        (void)write(kDriven);
        m_bracelet->stop();
        EXPECT_EQ(motorLines().back(), kZero);
    }

    PeerProcess m_server;
    std::string m_where;
    RegisterMap m_map;
    core::StopSwitch m_stop;
    core::Wakeup m_wakeup;
    std::unique_ptr<core::BraceletLink> m_bracelet;
};

/// The same over a serial line.
class ModbusRtuPeerTest : public ModbusPeerTest {
protected:
    void SetUp() override {
        ModbusPeerTest::SetUp();
        if (IsSkipped())
            return;
        if (!test::runs(QStringLiteral("socat"), {QStringLiteral("-V")}))
            GTEST_SKIP() << "socat is not installed";
        const QString ours = m_folder.filePath(QStringLiteral("ours"));
        const QString theirs = m_folder.filePath(QStringLiteral("theirs"));
        m_line.start(QStringLiteral("socat"),
                     {QStringLiteral("-d"), QStringLiteral("-d"), QStringLiteral("pty,rawer,link=") + ours,
                      QStringLiteral("pty,rawer,link=") + theirs},
                     true);
        ASSERT_TRUE(m_line.waitFor("starting data transfer loop"));
        serve({QStringLiteral("rtu"), theirs});
        use("[link]\nkind = 'rtu'\npath = '" + ours.toStdString() + "'\nanswer_timeout_s = 0.2");
    }

    QTemporaryDir m_folder;
    PeerProcess m_line;
};

} // namespace

TEST_F(ModbusPeerTest, readsEveryTypeAsThePeerPacksIt) {
    serveTcp();
    readsEveryType();
}

TEST_F(ModbusPeerTest, drivesTheMotorsFromZeroToZero) {
    serveTcp();
    drivesTheMotors();
}

TEST_F(ModbusPeerTest, isSafeWhenTheServerAnswersWithExceptions) {
    serveTcp();
    open();
    expectSafeLoss("fault exception", "exception 2");
}

TEST_F(ModbusPeerTest, isSafeWhenTheServerStopsAnswering) {
    serveTcp();
    open();
    expectSafeLoss("fault silent", "did not answer in time");
}

TEST_F(ModbusPeerTest, isSafeWhenTheServerAnswersLate) {
    serveTcp();
    open();
    expectSafeLoss("fault late 0.3", "did not answer in time");
}

TEST_F(ModbusPeerTest, isSafeWhenRequestsAreLostOnTheirWay) {
    serveTcp();
    open();
    expectSafeLoss("fault drop", "did not answer in time");
}

TEST_F(ModbusPeerTest, isSafeWhenTheServerAnswersNonsense) {
    serveTcp();
    open();
    expectSafeAfterNonsense();
}

TEST_F(ModbusPeerTest, isSafeWhenTheServerHangsUp) {
    serveTcp();
    open();
    expectSafeLoss("hangup", "");
}

TEST_F(ModbusPeerTest, comesBackWhenTheServerDoes) {
    serveTcp();
    open();
    ASSERT_EQ(write(kDriven).outcome, WriteOutcome::written);
    m_server.kill();
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        return m_bracelet->status().state == DeviceState::reconnecting && m_bracelet->connection() == 0;
    }));
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
    serveTcp(m_where);
    ASSERT_TRUE(live());
    for (const std::string& line : motorLines())
        EXPECT_EQ(line, kZero);
}

TEST_F(ModbusPeerTest, saysWhenNobodyListens) {
    serveTcp();
    m_server.kill();
    const auto bracelet = openModbusBracelet(m_map, m_stop);
    ASSERT_FALSE(bracelet);
    EXPECT_EQ(bracelet.error().kind, core::ErrorKind::unavailable);
    EXPECT_NE(bracelet.error().message.find("tcp://127.0.0.1:" + m_where), std::string::npos)
        << bracelet.error().message;
}

TEST_F(ModbusPeerTest, throwsAwayAnswersThatComeTooLate) {
    serveTcp();
    ASSERT_TRUE(m_server.command("set 100 1 2"));
    auto link = openLibmodbusLink(m_map);
    ASSERT_TRUE(link) << describe(link.error());
    std::vector<std::uint16_t> words(1);
    ASSERT_TRUE(m_server.command("fault late 0.3"));
    EXPECT_EQ((*link)->read(RegisterTable::holding, 100, words), Answer{Answer::Kind::timedOut});
    // The server has answered when it takes the next command.
    ASSERT_TRUE(m_server.command("fault none"));
    ASSERT_TRUE((*link)->read(RegisterTable::holding, 101, words).done());
    EXPECT_EQ(words[0], 2) << "not the answer to the first question";
    EXPECT_EQ((*link)->lateAnswers(), 1U);
}

TEST_F(ModbusPeerTest, tellsAnExceptionFromASilence) {
    serveTcp();
    auto link = openLibmodbusLink(m_map);
    ASSERT_TRUE(link) << describe(link.error());
    std::vector<std::uint16_t> words(1);
    EXPECT_EQ((*link)->read(RegisterTable::holding, 5000, words), (Answer{Answer::Kind::exception, 2}));
    EXPECT_TRUE((*link)->read(RegisterTable::holding, 100, words).done()) << "the connection is sound";
    m_server.kill();
    EXPECT_FALSE((*link)->read(RegisterTable::holding, 100, words).done());
}

TEST_F(ModbusPeerTest, streamsJointsAndOutlivesFaults) {
    serveTcp();
    ASSERT_TRUE(m_server.command("set 108 500 123"));
    auto joints = makeModbusJoints(m_map, core::ArmDescription());
    ASSERT_TRUE(joints) << describe(joints.error());
    (*joints)->start(m_wakeup);
    core::JointSample sample;
    std::size_t samples = 0;
    const auto drain = [&] {
        while ((*joints)->joints().pop(sample))
            ++samples;
        return samples;
    };
    ASSERT_TRUE(eventually(m_wakeup, [&] { return drain() >= 5; }));
    EXPECT_DOUBLE_EQ(sample.angle_rad[0], 0.5);
    EXPECT_DOUBLE_EQ(sample.torque_Nm[3], 1.23);
    EXPECT_EQ((*joints)->status().state, DeviceState::live);

    ASSERT_TRUE(m_server.command("fault exception"));
    ASSERT_TRUE(eventually(m_wakeup, [&] { return (*joints)->status().state == DeviceState::lost; }));
    EXPECT_NE((*joints)->status().message.find("exception 2"), std::string::npos);
    ASSERT_TRUE(m_server.command("fault none"));
    drain();
    const std::size_t before = samples;
    ASSERT_TRUE(eventually(m_wakeup, [&] { return drain() > before; }));
    EXPECT_GE((*joints)->status().framesLost, 3U);
    (*joints)->stop();
    for (const std::string& line : m_server.takeLines())
        EXPECT_FALSE(line.starts_with("write")) << "read-only: " << line;
}

TEST_F(ModbusRtuPeerTest, readsEveryTypeAsThePeerPacksIt) {
    readsEveryType();
}

TEST_F(ModbusRtuPeerTest, drivesTheMotorsFromZeroToZero) {
    drivesTheMotors();
}

TEST_F(ModbusRtuPeerTest, isSafeWhenTheServerStopsAnswering) {
    open();
    expectSafeLoss("fault silent", "did not answer in time");
}

TEST_F(ModbusRtuPeerTest, isSafeWhenRequestsAreLostOnTheirWay) {
    open();
    expectSafeLoss("fault drop", "did not answer in time");
}

TEST_F(ModbusRtuPeerTest, isSafeWhenTheServerAnswersLate) {
    open();
    expectSafeLoss("fault late 0.3", "did not answer in time");
}

TEST_F(ModbusRtuPeerTest, isSafeWhenTheServerAnswersNonsense) {
    open();
    expectSafeAfterNonsense();
}

TEST_F(ModbusRtuPeerTest, isSafeWhenTheServerAnswersWithExceptions) {
    open();
    expectSafeLoss("fault exception", "exception 2");
}

TEST_F(ModbusRtuPeerTest, isLostWhenTheLineIsUnplugged) {
    open();
    m_line.kill();
    ASSERT_TRUE(eventually(m_wakeup, [&] {
        return m_bracelet->connection() == 0 && m_bracelet->status().state != DeviceState::live;
    }));
    EXPECT_EQ(write(kDriven).outcome, WriteOutcome::lost);
    EXPECT_FALSE(m_bracelet->status().message.empty());
}
