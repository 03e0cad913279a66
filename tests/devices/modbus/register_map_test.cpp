// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/register_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace teleta;
using namespace teleta::modbus;

namespace {

const std::string kLink = "[link]\nkind = 'tcp'\nhost = 'h'\n";

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

std::string errorOf(const std::string& text) {
    const auto map = parseRegisterMap(text, "d.toml");
    return map ? std::string() : describe(map.error());
}

InputRegister inputAt(int address, RegisterType type = RegisterType::int16,
                      RegisterTable table = RegisterTable::holding) {
    return {.name = {},
            .table = table,
            .address = static_cast<std::uint16_t>(address),
            .format = {.type = type},
            .unit = "1"};
}

} // namespace

TEST(RegisterMap, readsEveryField) {
    const auto map = parseRegisterMap(R"(
kind = 'modbus'
name = 'arm and bracelet'
input_rate_Hz = 100
supply = 'board voltage'
temperature = 'board temperature'
[link]
kind = 'rtu'
path = '/dev/ttyUSB0'
baud = 19200
parity = 'even'
stop_bits = 2
server = 17
answer_timeout_s = 0.05
[tactors]
address = 10
type = 'int32'
word_order = 'low_first'
scale = 0.001
offset = -0.5
unit = 'V'
off = 0.1
start = 0.9
full = 3
[watchdog]
address = 30
[status]
table = 'input'
address = 7
type = 'uint16'
timed_out_bit = 0
too_hot_bit = 15
[[input]]
name = 'board voltage'
address = 40
type = 'float32'
unit = 'V'
[[input]]
name = 'board temperature'
address = 42
type = 'int16'
scale = 0.1
unit = 'degC'
[[input]]
name = 'angle'
table = 'input'
address = 100
type = 'int32'
scale = 1e-6
unit = 'rad'
[[input]]
name = 'torque'
address = 101
type = 'int16'
unit = 'N m'
[[joint]]
angle = 'angle'
torque = 'torque'
[[joint]]
angle = 'angle'
torque = 'torque'
[[joint]]
angle = 'angle'
torque = 'torque'
[[joint]]
angle = 'angle'
torque = 'torque'
)",
                                      "d.toml");
    ASSERT_TRUE(map) << describe(map.error());
    EXPECT_EQ(map->name, "arm and bracelet");
    const auto& link = std::get<RtuLink>(map->link);
    EXPECT_EQ(link.path, "/dev/ttyUSB0");
    EXPECT_EQ(link.baud, 19200);
    EXPECT_EQ(link.parity, 'E');
    EXPECT_EQ(link.stopBits, 2);
    EXPECT_EQ(linkName(*map), "/dev/ttyUSB0");
    EXPECT_EQ(map->server, 17);
    EXPECT_EQ(map->answerTimeout_s, 0.05);
    EXPECT_EQ(map->inputRate_Hz, 100.0);
    ASSERT_TRUE(map->tactors);
    EXPECT_EQ(map->tactors->address, 10);
    EXPECT_EQ(map->tactors->format.type, RegisterType::int32);
    EXPECT_EQ(map->tactors->format.order, WordOrder::lowFirst);
    EXPECT_EQ(map->tactors->format.scale, 0.001);
    EXPECT_EQ(map->tactors->format.offset, -0.5);
    EXPECT_EQ(map->tactors->registers(), 12U);
    EXPECT_EQ(map->tactors->off, 0.1);
    EXPECT_EQ(map->tactors->start, 0.9);
    EXPECT_EQ(map->tactors->full, 3.0);
    EXPECT_EQ(map->watchdogAddress, 30);
    ASSERT_TRUE(map->status);
    EXPECT_EQ(map->status->input.table, RegisterTable::input);
    EXPECT_EQ(map->status->timedOutBit, 0);
    EXPECT_EQ(map->status->tooHotBit, 15);
    EXPECT_EQ(map->status->supplyLowBit, std::nullopt);
    ASSERT_EQ(map->inputs.size(), 4U);
    EXPECT_EQ(map->inputs[2].table, RegisterTable::input);
    EXPECT_EQ(map->supply, 0U);
    EXPECT_EQ(map->temperature, 1U);
    ASSERT_EQ(map->joints.size(), 4U);
    EXPECT_EQ(map->joints.at(3).angle, 2U);
    EXPECT_EQ(map->joints.at(3).torque, 3U);
}

TEST(RegisterMap, saysWhereAFileIsWrong) {
    const std::string begin = "kind = 'modbus'\nname = 'n'\n" + kLink;
    const std::string tactors = "[tactors]\naddress = 0\ntype = 'uint16'\nunit = 'V'\nfull = 3\n";
    const std::string watchdog = "[watchdog]\naddress = 20\n";
    struct Case {
        std::string text;
        std::string error;
    };
    const std::vector<Case> cases = {
        {"kind = 'modbus'\nname = 'n'\n[link]\nkind = 'udp'\n",
         "d.toml:4:8: unknown value \"udp\" of \"kind\" (expected one of: tcp, "
         "rtu)"},
        {begin + "port = 0\n" + tactors,
         "d.toml:6:8: \"port\" is out of range: 0 (expected a whole number from 1 to 65535)"},
        {begin + "server = 256\n" + tactors,
         "d.toml:6:10: \"server\" is out of range: 256 (expected a whole number from 0 to 255)"},
        {begin + "answer_timeout_s = 0\n" + tactors,
         "d.toml:6:20: \"answer_timeout_s\" is out of range: 0 (expected a number from 0.001 to 10)"},
        {begin, "d.toml:3:1: the file names no register (expected [tactors] or [[input]])"},
        {begin + "[tactors]\naddress = 65531\ntype = 'uint16'\nunit = 'V'\nfull = 3\n",
         "d.toml:7:11: the last register would be beyond 65535 (expected an address of at most 65530)"},
        {begin + "[tactors]\naddress = 65525\ntype = 'float32'\nunit = 'V'\nfull = 3\n",
         "d.toml:7:11: the last register would be beyond 65535 (expected an address of at most 65524)"},
        {begin + "[tactors]\naddress = -1\ntype = 'uint16'\nunit = 'V'\nfull = 3\n",
         "d.toml:7:11: \"address\" is out of range: -1 (expected a whole number from 0 to 65535)"},
        {begin + "[tactors]\naddress = 0\ntype = 'float64'\nunit = 'V'\nfull = 3\n",
         "d.toml:8:8: unknown value \"float64\" of \"type\"; perhaps \"float32\" is meant (expected one of: "
         "int16, uint16, int32, float32)"},
        {begin + tactors + "scale = 0\n", "d.toml:11:9: \"scale\" is 0 (expected the value of one count)"},
        {begin + tactors + "scale = 0.00001\n",
         "d.toml:10:8: \"full\" does not fit into the register (expected a value that type, scale and offset "
         "can express)"},
        {begin + tactors + "off = 3\n", "d.toml:10:8: \"full\" and \"off\" are the same (expected a value at "
                                        "which the motor runs as fast as "
                                        "it can)"},
        {begin + tactors + "off = 1\nstart = 3.5\n" + watchdog,
         "d.toml:12:9: \"start\" is not between \"off\" and \"full\" (expected the value of the weakest "
         "intensity)"},
        {begin + tactors + "off = 1\nstart = 0\n" + watchdog,
         "d.toml:12:9: \"start\" is not between \"off\" and \"full\" (expected the value of the weakest "
         "intensity)"},
        {begin + tactors,
         "d.toml:6:1: nothing turns the motors off when the program is killed or the line is cut (expected "
         "[watchdog] with the address of the driver's watchdog register, or with by_traffic = true where it "
         "turns "
         "them off when nothing is written)"},
        {begin + "answer_timeout_s = 0.3\n" + tactors + watchdog,
         "d.toml:3:1: \"answer_timeout_s\" is too long for motors: STOP may have to wait for it (expected at "
         "most "
         "0.2 s)"},
        {begin + tactors + "[watchdog]\nby_traffic = false\n", "d.toml:11:1: \"address\" is missing"},
        {begin + tactors + "[watchdog]\naddress = 5\n",
         "d.toml:12:11: the watchdog is a register of a motor (expected a register of its own)"},
        {begin + "[watchdog]\naddress = 5\n[[input]]\nname = 'a'\naddress = 0\ntype = 'int16'\nunit = '1'\n",
         "d.toml:6:1: there is no motor to watch (expected a table [tactors])"},
        {begin + tactors + "[status]\naddress = 9\ntype = 'float32'\n",
         "d.toml:13:8: a float has no bits to look at (expected one of: int16, uint16, int32)"},
        {begin + tactors + "[status]\naddress = 9\ntype = 'uint16'\ntoo_hot_bit = 16\n",
         "d.toml:14:15: \"too_hot_bit\" is out of range: 16 (expected a whole number from 0 to 15)"},
        {begin + tactors + "[[input]]\nname = 'a'\naddress = 0\ntype = 'int16'\nunit = '1'\n" +
             "[[input]]\nname = 'a'\naddress = 1\ntype = 'int16'\nunit = '1'\n",
         "d.toml:17:8: the name \"a\" is used twice (expected a name of its own for each input)"},
        {begin + tactors + "[[input]]\nname = 'a'\naddress = 0\ntype = 'int16'\nunit = 'rad'\n" +
             "[[input]]\nname = 'b'\naddress = 1\ntype = 'int16'\nunit = 'N m'\n" +
             repeated("[[joint]]\nangle = 'a'\ntorque = 'b'\n", 17),
         "d.toml:21:1: too many joints: 17 (expected at most 16, from the base to the tip)"},
        {"supply = 'a'\n" + begin + tactors,
         "d.toml:1:10: there is no input \"a\" (expected the name of an [[input]])"},
        {"supply = 'a'\n" + begin + "[[input]]\nname = 'a'\naddress = 0\ntype = 'int16'\nunit = 'mV'\n",
         "d.toml:1:10: the unit of \"a\" is \"mV\" (expected an input in V)"},
        {begin + "[tactor]\naddress = 0\n",
         "d.toml:6:2: unknown key \"tactor\"; perhaps \"tactors\" is meant (expected one of: kind, name, "
         "input_rate_Hz, link, tactors, watchdog, status, input, joint, supply, temperature)"},
        {begin + "[tactors]\naddress = 0\ntype = 'uint16'\nunit = 'V'\n", "d.toml:6:1: \"full\" is missing"},
        {begin + "[tactors\n", "d.toml:6:9: "},
    };
    for (const Case& c : cases) {
        const std::string error = errorOf(c.text);
        EXPECT_EQ(error.substr(0, c.error.ends_with(": ") ? c.error.size() : std::string::npos), c.error)
            << c.text;
    }
}

TEST(RegisterMap, takesMotorsThatRunTheOtherWayRoundAndWatchTheTraffic) {
    const auto map =
        parseRegisterMap("kind = 'modbus'\nname = 'n'\n" + kLink +
                             "[tactors]\naddress = 0\ntype = 'uint16'\nunit = 'V'\noff = 10\nstart = "
                             "7\nfull = 2\n[watchdog]\nby_traffic = true\n",
                         "d.toml");
    ASSERT_TRUE(map) << describe(map.error());
    EXPECT_TRUE(map->watchedByTraffic);
    EXPECT_FALSE(map->watchdogAddress);
    EXPECT_EQ(tactorWords(*map->tactors, {0.0, 1e-9, 1.0, 0.5, 0.0, 0.0}),
              (std::vector<std::uint16_t>{10, 7, 2, 5, 10, 10}));
}

TEST(RegisterMap, mapsIntensitiesToTheRangeOfTheMotor) {
    const TactorRegisters tactors{
        .address = 0, .format = {.scale = 0.001}, .unit = "V", .off = 0.2, .start = 1.0, .full = 3.0};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(tactorWords(tactors, {0.0, 0.5, 1.0, nan, infinity, -1.0}),
              (std::vector<std::uint16_t>{200, 2000, 3000, 200, 3000, 200}));
    // The weakest intensity is the start voltage, not off.
    EXPECT_EQ(tactorWords(tactors, {1e-9, 0, 0, 0, 0, 0})[0], 1000);
}

TEST(RegisterMap, writesTwoRegistersAMotorWhereTheTypeTakesThem) {
    const TactorRegisters tactors{.address = 0,
                                  .format = {.type = RegisterType::float32, .order = WordOrder::lowFirst},
                                  .unit = "1",
                                  .off = 0.0,
                                  .start = 0.0,
                                  .full = 1.0};
    EXPECT_EQ(tactorWords(tactors, {1.0, 0.5, 0.0, 0.0, 0.0, 0.0}),
              (std::vector<std::uint16_t>{0, 0x3F80, 0, 0x3F00, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(RegisterMap, readsNeighboursTogetherAndNothingElse) {
    const std::vector<InputRegister> inputs = {inputAt(12), inputAt(10, RegisterType::float32), inputAt(14),
                                               inputAt(12, RegisterType::int16, RegisterTable::input)};
    const std::vector<ReadRequest> plan = planReads(inputs);
    ASSERT_EQ(plan.size(), 3U);
    EXPECT_EQ(plan[0].address, 10);
    EXPECT_EQ(plan[0].count, 3);
    EXPECT_EQ(plan[0].inputs, (std::vector<std::size_t>{1, 0}));
    EXPECT_EQ(plan[1].address, 14) << "register 13 is not listed: perhaps there is none";
    EXPECT_EQ(plan[1].count, 1);
    EXPECT_EQ(plan[2].table, RegisterTable::input);
    EXPECT_TRUE(planReads({}).empty());
}

TEST(RegisterMap, readsAtMost125RegistersAtOnce) {
    std::vector<InputRegister> inputs;
    for (int address = 0; address < 300; address += 2)
        inputs.push_back(inputAt(address, RegisterType::int32));
    const std::vector<ReadRequest> plan = planReads(inputs);
    ASSERT_EQ(plan.size(), 3U);
    int next = 0;
    for (const ReadRequest& request : plan) {
        EXPECT_EQ(request.address, next);
        EXPECT_LE(request.count, 125);
        EXPECT_EQ(request.count % 2, 0) << "no value is cut in two";
        next = request.address + request.count;
    }
    EXPECT_EQ(next, 300);
}

TEST(RegisterMap, readsARegisterThatTwoInputsShareOnce) {
    const std::vector<ReadRequest> plan =
        planReads({inputAt(5), inputAt(5), inputAt(5, RegisterType::int32)});
    ASSERT_EQ(plan.size(), 1U);
    EXPECT_EQ(plan[0].count, 2);
    EXPECT_EQ(plan[0].inputs.size(), 3U);
}

TEST(RegisterMap, comesWithAControllerOfUniversalRobots) {
    const auto map = readRegisterMap(":/devices/ur-controller.toml");
    ASSERT_TRUE(map) << describe(map.error());
    EXPECT_FALSE(map->tactors) << "read-only";
    EXPECT_FALSE(map->watchdogAddress);
    EXPECT_EQ(linkName(*map), "tcp://192.168.0.10:502");
    const auto find = [&](const std::string& name) -> const InputRegister& {
        const auto found = std::ranges::find(map->inputs, name, &InputRegister::name);
        EXPECT_NE(found, map->inputs.end()) << name;
        return *found;
    };
    // The manufacturer's list: angles in mrad from 270, currents in mA from 290, position in 0.1 mm from 400.
    const std::array<std::uint16_t, 1> raw = {static_cast<std::uint16_t>(-1571)};
    EXPECT_EQ(find("wrist_3_angle").address, 275);
    EXPECT_DOUBLE_EQ(decode(find("wrist_3_angle").format, raw), -1.571);
    EXPECT_EQ(find("elbow_current").address, 292);
    EXPECT_DOUBLE_EQ(decode(find("elbow_current").format, raw), -1.571);
    EXPECT_EQ(find("tcp_z").address, 402);
    EXPECT_DOUBLE_EQ(decode(find("tcp_z").format, raw), -0.1571);
    EXPECT_EQ(find("tool_temperature").address, 769);
    EXPECT_EQ(planReads(map->inputs).size(), 10U);
}

TEST(RegisterMap, comesWithAMotorDriverToStartFrom) {
    const auto map = readRegisterMap(":/devices/motor-driver.toml");
    ASSERT_TRUE(map) << describe(map.error());
    ASSERT_TRUE(map->tactors);
    EXPECT_EQ(tactorWords(*map->tactors, {1, 1, 1, 1, 1, 0.5}),
              (std::vector<std::uint16_t>{3000, 3000, 3000, 3000, 3000, 1500}));
    EXPECT_EQ(map->watchdogAddress, 6);
}

TEST(RegisterMap, saysWhenThereIsNoFile) {
    for (const char* path : {"/nowhere/device.toml", ":/devices/nothing.toml"}) {
        const auto map = readRegisterMap(path);
        ASSERT_FALSE(map);
        EXPECT_EQ(map.error().kind, core::ErrorKind::notFound);
        EXPECT_EQ(map.error().where.file, path);
    }
}

TEST(RegisterMap, namesItsLink) {
    RegisterMap map;
    map.link = TcpLink{.host = "::1", .port = 1502};
    EXPECT_EQ(linkName(map), "tcp://[::1]:1502");
}
