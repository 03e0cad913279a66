// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/node_claim.h"
#include "devices/modbus/libmodbus_link.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>

using namespace teleta;
using namespace teleta::modbus;

namespace {

/// A serial line that nobody answers on.
class SerialLine {
public:
    SerialLine()
        : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        if (m_master >= 0 && ::grantpt(m_master) == 0 && ::unlockpt(m_master) == 0)
            m_path = ::ptsname(m_master);
    }
    ~SerialLine() {
        if (m_master >= 0)
            ::close(m_master);
    }
    SerialLine(const SerialLine&) = delete;
    SerialLine& operator=(const SerialLine&) = delete;
    [[nodiscard]] const std::string& path() const { return m_path; }

private:
    int m_master;
    std::string m_path;
};

RegisterMap mapOf(const std::string& path) {
    RegisterMap map;
    map.link = RtuLink{.path = path};
    return map;
}

} // namespace

TEST(LibmodbusLink, aSerialLineOfAnotherProgramIsNotOpenedUntilItIsFree) {
    const SerialLine line;
    ASSERT_FALSE(line.path().empty());
    {
        const auto other = core::NodeClaim::take(line.path());
        ASSERT_TRUE(other && *other);
        const auto link = openLibmodbusLink(mapOf(line.path()));
        ASSERT_FALSE(link);
        EXPECT_EQ(link.error().kind, core::ErrorKind::unavailable);
        EXPECT_NE(link.error().message.find("another program uses " + line.path()), std::string::npos)
            << link.error().message;
        EXPECT_FALSE(link.error().expected.empty()) << "what to do";
    }
    const auto link = openLibmodbusLink(mapOf(line.path()));
    EXPECT_TRUE(link) << describe(link.error());
}

TEST(LibmodbusLink, aSerialLineHasOneDeviceAtATimeThatSpeaks) {
    const SerialLine line;
    ASSERT_FALSE(line.path().empty());
    auto first = openLibmodbusLink(mapOf(line.path()));
    ASSERT_TRUE(first) << describe(first.error());
    EXPECT_FALSE(openLibmodbusLink(mapOf(line.path())));
    first->reset();
    const auto second = openLibmodbusLink(mapOf(line.path()));
    EXPECT_TRUE(second) << describe(second.error());
}

TEST(LibmodbusLink, aSerialLineThatIsNotThereIsToldAsSuch) {
    const auto link = openLibmodbusLink(mapOf("/dev/tty-that-is-not-there"));
    ASSERT_FALSE(link);
    EXPECT_EQ(link.error().message.find("another program"), std::string::npos) << link.error().message;
    EXPECT_NE(link.error().message.find("/dev/tty-that-is-not-there"), std::string::npos);
}
