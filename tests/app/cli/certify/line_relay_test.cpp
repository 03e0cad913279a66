// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/line_relay.h"
#include "app/cli/commands/certify/motor_watch.h"
#include "backend/core/steady_time.h"
#include "devices/modbus/libmodbus_link.h"
#include "devices/modbus/simulated_driver.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <thread>

using namespace teleta;
using namespace teleta::cli;
using modbus::Answer;
using namespace std::chrono_literals;

namespace {

modbus::RegisterMap driverMap(int port) {
    modbus::RegisterMap map =
        modbus::parseRegisterMap(
            "kind = 'modbus'\nname = 'driver'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\n"
            "[tactors]\naddress = 0\ntype = 'uint16'\nunit = '1'\nfull = 100\n"
            "[watchdog]\naddress = 6\n",
            "driver.toml")
            .value();
    map.link = modbus::TcpLink{"127.0.0.1", port};
    return map;
}

/// A driver that waits for a minute, with a line to it that can fail.
struct Line {
    std::unique_ptr<modbus::SimulatedDriver> driver =
        modbus::SimulatedDriver::start(driverMap(0), 60s).value();
    std::unique_ptr<LineRelay> relay = LineRelay::start("127.0.0.1", driver->port()).value();

    [[nodiscard]] std::unique_ptr<modbus::RegisterLink> link(double answerTimeout_s = 5.0) const {
        modbus::RegisterMap map = driverMap(relay->port());
        map.answerTimeout_s = answerTimeout_s;
        return modbus::openLibmodbusLink(map).value();
    }
};

Answer readOne(modbus::RegisterLink& link) {
    std::array<std::uint16_t, 1> word{};
    return link.read(modbus::RegisterTable::holding, 0, word);
}

} // namespace

TEST(LineRelay, carriesBothWaysAsLongAsNothingIsWrong) {
    const Line line;
    const auto link = line.link();
    EXPECT_TRUE(link->write(0, std::array<std::uint16_t, 2>{7, 8}).done());
    std::array<std::uint16_t, 2> words{};
    EXPECT_TRUE(link->read(modbus::RegisterTable::holding, 0, words).done());
    EXPECT_EQ(words, (std::array<std::uint16_t, 2>{7, 8}));
}

TEST(LineRelay, aCutLineEndsConnectionsUntilItIsWhole) {
    const Line line;
    const auto link = line.link();
    ASSERT_TRUE(readOne(*link).done());
    line.relay->set(LineFault::cut);
    EXPECT_EQ(readOne(*link).kind, Answer::Kind::lost);
    line.relay->set(LineFault::none);
    EXPECT_TRUE(readOne(*line.link()).done());
}

TEST(LineRelay, whatIsLostNeverArrives) {
    const Line line;
    const auto link = line.link(0.2);
    ASSERT_TRUE(readOne(*link).done());
    line.relay->set(LineFault::lost);
    EXPECT_EQ(link->write(0, std::array<std::uint16_t, 1>{9}).kind, Answer::Kind::timedOut);
    line.relay->set(LineFault::none);
    std::array<std::uint16_t, 1> word{1};
    EXPECT_TRUE(line.link()->read(modbus::RegisterTable::holding, 0, word).done());
    EXPECT_EQ(word.front(), 0);
}

TEST(LineRelay, whatIsLateHasArrivedAndIsAnsweredLater) {
    const Line line;
    const auto link = line.link(0.2);
    ASSERT_TRUE(readOne(*link).done());
    line.relay->set(LineFault::late);
    EXPECT_EQ(link->write(0, std::array<std::uint16_t, 1>{9}).kind, Answer::Kind::timedOut);
    line.relay->set(LineFault::none);
    std::array<std::uint16_t, 1> word{};
    EXPECT_TRUE(line.link()->read(modbus::RegisterTable::holding, 0, word).done());
    EXPECT_EQ(word.front(), 9);
}

TEST(LineRelay, liesAreSeenThrough) {
    for (const LineFault lie : {LineFault::garbage, LineFault::strange}) {
        const Line line;
        const auto link = line.link(0.2);
        line.relay->set(lie);
        EXPECT_FALSE(readOne(*link).done());
    }
    const Line line;
    const auto link = line.link();
    line.relay->set(LineFault::refused);
    EXPECT_EQ(readOne(*link), (Answer{Answer::Kind::exception, 4}));
}

TEST(LineRelay, tellsWhyThereIsNoLine) {
    const auto relay = LineRelay::start("host name with blanks", 502);
    ASSERT_FALSE(relay);
    EXPECT_EQ(relay.error().kind, core::ErrorKind::unavailable);
    EXPECT_FALSE(relay.error().message.empty());
}

TEST(MotorWatch, seesTheMotorsGoOnAndOff) {
    const Line line;
    const auto link = line.link();
    const auto watch = MotorWatch::start(driverMap(line.driver->port())).value();
    const auto comesToBe = [&watch](bool on, std::int64_t after_ns) {
        while (watch->newest().asked_ns <= after_ns)
            std::this_thread::sleep_for(1ms);
        return watch->newest().on == on;
    };
    EXPECT_TRUE(comesToBe(false, core::steadyNow_ns()));
    ASSERT_TRUE(link->write(0, std::array<std::uint16_t, 6>{0, 0, 0, 0, 0, 1}).done());
    const std::int64_t on_ns = core::steadyNow_ns();
    EXPECT_TRUE(comesToBe(true, on_ns));
    EXPECT_FALSE(watch->offSince(on_ns)) << "still on";
    ASSERT_TRUE(link->write(0, std::array<std::uint16_t, 6>{}).done());
    const std::int64_t off_ns = core::steadyNow_ns();
    EXPECT_TRUE(comesToBe(false, off_ns));
    const auto off = watch->offSince(on_ns);
    ASSERT_TRUE(off);
    EXPECT_GE(off->answered_ns, on_ns);
    EXPECT_TRUE(watch->wasOnAfter(on_ns));
    EXPECT_FALSE(watch->wasOnAfter(off_ns));
    EXPECT_FALSE(watch->failed());
}
