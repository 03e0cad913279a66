// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_config.h"

#include <gtest/gtest.h>

namespace teleta::wts {
namespace {

TEST(WtsConfig, readsSerialPortsWithTheirBaudRate) {
    const auto address = parseWtsAddress("/dev/serial/by-id/usb-wts", 921600);
    ASSERT_TRUE(address);
    EXPECT_EQ(*address, WtsAddress(SerialAddress{"/dev/serial/by-id/usb-wts", 921600}));
    EXPECT_EQ(displayName(*address), "usb-wts");
    EXPECT_EQ(*parseWtsAddress("ttyUSB0"), WtsAddress(SerialAddress{"ttyUSB0", 115200}));
}

TEST(WtsConfig, readsTcpAddresses) {
    EXPECT_EQ(*parseWtsAddress("tcp://192.168.1.20:1000"), WtsAddress(TcpAddress{"192.168.1.20", 1000}));
    EXPECT_EQ(*parseWtsAddress("tcp://[fe80::1]:65535"), WtsAddress(TcpAddress{"fe80::1", 65535}));
    EXPECT_EQ(displayName(*parseWtsAddress("tcp://hand:1000")), "hand:1000");
}

TEST(WtsConfig, refusesWhatIsNeither) {
    for (const char* text :
         {"", "tcp://", "tcp://host", "tcp://host:", "tcp://:1000", "tcp://host:0", "tcp://host:65536",
          "tcp://host:12a", "tcp://host:-1", "tcp://fe80::1:1000", "udp://host:1000", "tcp://[]:1000"}) {
        const auto address = parseWtsAddress(text);
        ASSERT_FALSE(address) << text;
        EXPECT_EQ(address.error().kind, core::ErrorKind::badInput);
        EXPECT_FALSE(address.error().expected.empty());
    }
}

} // namespace
} // namespace teleta::wts
