// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote_site_file.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

namespace teleta::site_link {
namespace {

constexpr const char* kWhole = R"(kind = "remote_site"
name = "lab"
console = "console1"
person = "A. Name"
viewer = true
mesh_path = "meshes"
[operator]
domain = 72
interface = "wg0"
peers = ["10.8.0.1"]
security = "certificates"
certificates = "keys/console1"
)";

std::string errorOf(const std::string& text) {
    const auto file = parseRemoteSite(text, "/files/lab.toml");
    return file ? std::string() : core::describe(file.error());
}

TEST(RemoteSiteFile, hasAllKeysOfTheSpecification) {
    const auto file = parseRemoteSite(kWhole, "/files/lab.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->name, "lab");
    EXPECT_EQ(file->console, "console1");
    EXPECT_EQ(file->person, "A. Name");
    EXPECT_TRUE(file->viewer);
    EXPECT_EQ(file->meshPath, "/files/meshes");
    EXPECT_EQ(file->meeting.domain, (dds::DomainConfig{72, "wg0", {"10.8.0.1"}}));
    ASSERT_TRUE(file->meeting.security);
    EXPECT_EQ(file->meeting.security->folder, "/files/keys/console1");
}

TEST(RemoteSiteFile, withoutSecurityNobodyElseMayListen) {
    const std::string open = "kind = \"remote_site\"\nname = \"lab\"\nconsole = \"a\"\n[operator]\n"
                             "security = \"none\"\ninterface = ";
    const auto file = parseRemoteSite(open + "\"lo\"\n", "lab.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_EQ(file->meeting.domain.domain, OperatorDomain::kDefaultDomain);
    EXPECT_FALSE(file->meeting.security);
    const std::string error = errorOf(open + "\"eth0\"\n");
    EXPECT_NE(error.find("lab.toml:5"), std::string::npos) << error;
    EXPECT_NE(error.find("anybody on this network could move the arm"), std::string::npos) << error;
}

/// Of a site: consoles may be anywhere.
TEST(RemoteSiteFile, aSiteIsOnATunnelUnlessItsFileSaysOtherwise) {
    auto file = parseRemoteSite(kWhole, "/files/lab.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    OperatorDomain meeting = file->meeting;
    EXPECT_FALSE(meeting.anyInterface);
    EXPECT_TRUE(meeting.checkInterface()) << "who joins says that wg0 is not there";
    meeting.domain.interface = "lo";
    EXPECT_TRUE(meeting.checkInterface());
    meeting.domain.interface = "";
    const auto refused = meeting.checkInterface();
    ASSERT_FALSE(refused);
    EXPECT_NE(core::describe(refused.error()).find("security_bind = \"any\""), std::string::npos);
    ifaddrs* all = nullptr;
    ASSERT_EQ(getifaddrs(&all), 0);
    for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
        if ((one->ifa_flags & (IFF_LOOPBACK | IFF_POINTOPOINT)) != 0)
            continue;
        meeting.domain.interface = one->ifa_name;
        EXPECT_FALSE(meeting.checkInterface()) << one->ifa_name;
        if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET || one->ifa_netmask == nullptr)
            continue;
        // DDS takes the address of the network for the interface as well.
        in_addr network = reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr;
        network.s_addr &= reinterpret_cast<const sockaddr_in*>(one->ifa_netmask)->sin_addr.s_addr;
        meeting.domain.interface = inet_ntoa(network);
        EXPECT_FALSE(meeting.checkInterface()) << meeting.domain.interface;
    }
    freeifaddrs(all);
    meeting.domain.interface = "";
    meeting.anyInterface = true;
    EXPECT_TRUE(meeting.checkInterface());
    file = parseRemoteSite(std::string(kWhole) + "security_bind = \"any\"\n", "/files/lab.toml");
    ASSERT_TRUE(file) << core::describe(file.error());
    EXPECT_TRUE(file->meeting.anyInterface);
}

TEST(RemoteSiteFile, saysWhatIsWrongAndWhere) {
    EXPECT_NE(errorOf("kind = \"remote_site\"\n").find("name"), std::string::npos);
    std::string text = kWhole;
    text.replace(text.find("console1"), 8, "Console 1");
    EXPECT_NE(errorOf(text).find("\"Console 1\" cannot be a name"), std::string::npos) << errorOf(text);
    EXPECT_NE(errorOf(std::string(kWhole) + "ports = 1\n").find("ports"), std::string::npos);
    EXPECT_NE(errorOf("kind = \"site\"\n").find("remote_site"), std::string::npos);
}

} // namespace
} // namespace teleta::site_link
