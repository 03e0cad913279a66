// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/domain_config.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace teleta::dds {
namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(DdsDomain, usesNoMulticastAndLooksOnThisComputer) {
    const std::string xml = configurationOf({.domain = 7, .interface = "lo", .peers = {}});
    EXPECT_TRUE(holds(xml, "<Domain Id=\"7\">")) << xml;
    EXPECT_TRUE(holds(xml, "<AllowMulticast>false</AllowMulticast>")) << xml;
    EXPECT_TRUE(holds(xml, "<NetworkInterface name=\"lo\"/>")) << xml;
    EXPECT_TRUE(holds(xml, "<Peers><Peer Address=\"127.0.0.1\"/></Peers>")) << xml;
    EXPECT_FALSE(holds(xml, "FragmentSize")) << xml;
    EXPECT_TRUE(holds(xml, "<ReceiveBufferSize>256KiB</ReceiveBufferSize>")) << xml;
}

TEST(DdsDomain, keepsPacketsWholeOnNetworks) {
    const std::string xml =
        configurationOf({.domain = 0, .interface = "192.168.1.5", .peers = {"robot.local", "10.0.0.2"}});
    EXPECT_TRUE(holds(xml, "<NetworkInterface address=\"192.168.1.5\"/>")) << xml;
    EXPECT_TRUE(holds(xml, "<Peer Address=\"localhost\"/><Peer Address=\"robot.local\"/>"
                           "<Peer Address=\"10.0.0.2\"/>"))
        << xml;
    EXPECT_TRUE(holds(xml, "<MaxMessageSize>1300B</MaxMessageSize>")) << xml;
    EXPECT_FALSE(holds(configurationOf({}), "NetworkInterface"));
}

TEST(DdsDomain, threadsHaveAPriorityOnlyWhereTheUserMayGiveOne) {
    EXPECT_FALSE(holds(configurationOf({}), "Threads"));
    EXPECT_TRUE(holds(configurationOf({}, 9), "<Thread Name=\"recv\"><Scheduling><Class>realtime</Class>"
                                              "<Priority>9</Priority></Scheduling></Thread>"));
}

TEST(DdsDomain, namesCannotBreakOutOfTheConfiguration) {
    const std::string xml = configurationOf({.domain = 0, .interface = "a\"/><b&", .peers = {"<x>"}});
    EXPECT_TRUE(holds(xml, "name=\"a&quot;/>&lt;b&amp;\"")) << xml;
    EXPECT_TRUE(holds(xml, "Address=\"&lt;x>\"")) << xml;
}

TEST(DdsDomain, isThatOfTheEnvironment) {
    unsetenv("ROS_DOMAIN_ID");
    EXPECT_EQ(defaultDomain(), 0);
    setenv("ROS_DOMAIN_ID", "42", 1);
    EXPECT_EQ(defaultDomain(), 42);
    for (const char* bad : {"-1", "233", "x", "4 ", "1e1", "99999999999999999999"}) {
        setenv("ROS_DOMAIN_ID", bad, 1);
        const auto domain = defaultDomain();
        ASSERT_FALSE(domain) << bad;
        EXPECT_NE(domain.error().message.find("ROS_DOMAIN_ID"), std::string::npos);
        EXPECT_NE(domain.error().expected.find("232"), std::string::npos);
    }
    unsetenv("ROS_DOMAIN_ID");
}

} // namespace
} // namespace teleta::dds
