// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/libmodbus_link.h"
#include "devices/modbus/simulated_driver.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <thread>
#include <vector>

using namespace teleta;
using namespace teleta::modbus;
using namespace std::chrono_literals;

namespace {

RegisterMap driverMap() {
    return parseRegisterMap("kind = 'modbus'\nname = 'driver'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\n"
                            "[tactors]\naddress = 10\ntype = 'uint16'\nunit = '1'\noff = 5.0\nfull = 100\n"
                            "[watchdog]\naddress = 20\n[status]\naddress = 30\ntype = 'uint16'\n"
                            "timed_out_bit = 2\n",
                            "driver.toml")
        .value();
}

std::unique_ptr<RegisterLink> linkTo(const SimulatedDriver& driver) {
    RegisterMap map = driverMap();
    map.link = TcpLink{"127.0.0.1", driver.port()};
    map.answerTimeout_s = 5.0;
    return openLibmodbusLink(map).value();
}

std::vector<std::uint16_t> wordsAt(RegisterLink& link, std::uint16_t address, std::size_t count) {
    std::vector<std::uint16_t> words(count);
    EXPECT_TRUE(link.read(RegisterTable::holding, address, words).done());
    return words;
}

constexpr std::array<std::uint16_t, 6> kOn{50, 60, 70, 80, 90, 100};
const std::vector<std::uint16_t> kOff(6, 5);

} // namespace

TEST(SimulatedDriver, keepsWhatIsWrittenWhileTheWatchdogCounts) {
    const auto driver = SimulatedDriver::start(driverMap(), 60s).value();
    const auto link = linkTo(*driver);
    EXPECT_EQ(wordsAt(*link, 10, 6), kOff) << "off at first";
    ASSERT_TRUE(link->write(20, std::array<std::uint16_t, 1>{1}).done());
    ASSERT_TRUE(link->write(10, kOn).done());
    EXPECT_EQ(wordsAt(*link, 10, 6), std::vector(kOn.begin(), kOn.end()));
    // Somebody else reads the same.
    EXPECT_EQ(wordsAt(*linkTo(*driver), 10, 6), std::vector(kOn.begin(), kOn.end()));
    EXPECT_EQ(driver->timeouts(), 0U);
}

TEST(SimulatedDriver, turnsTheMotorsOffWhenTheWatchdogStandsStill) {
    const auto driver = SimulatedDriver::start(driverMap(), 50ms).value();
    const auto link = linkTo(*driver);
    ASSERT_TRUE(link->write(20, std::array<std::uint16_t, 1>{1}).done());
    ASSERT_TRUE(link->write(10, kOn).done());
    // Other writes do not count.
    while (driver->timeouts() == 0) {
        ASSERT_TRUE(link->write(40, std::array<std::uint16_t, 1>{7}).done());
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_EQ(wordsAt(*link, 10, 6), kOff);
    EXPECT_EQ(wordsAt(*link, 30, 1).front(), 4) << "bit 2: timed out";
    ASSERT_TRUE(link->write(20, std::array<std::uint16_t, 1>{2}).done());
    EXPECT_EQ(wordsAt(*link, 30, 1).front(), 0) << "it counts again";
}

TEST(SimulatedDriver, withoutAWatchdogRegisterAnyWriteCounts) {
    RegisterMap map = driverMap();
    map.watchdogAddress.reset();
    map.watchedByTraffic = true;
    const auto driver = SimulatedDriver::start(map, 50ms).value();
    const auto link = linkTo(*driver);
    ASSERT_TRUE(link->write(10, kOn).done());
    while (driver->timeouts() == 0) {
        // Reading is no traffic that says that somebody is in command.
        (void)wordsAt(*link, 10, 6);
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_EQ(wordsAt(*link, 10, 6), kOff);
}

TEST(SimulatedDriver, isRefusedForADeviceWithoutMotors) {
    RegisterMap map = driverMap();
    map.tactors.reset();
    const auto driver = SimulatedDriver::start(map);
    ASSERT_FALSE(driver);
    EXPECT_EQ(driver.error().kind, core::ErrorKind::badInput);
}
