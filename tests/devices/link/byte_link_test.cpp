// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/steady_time.h"
#include "devices/link/byte_link.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

namespace teleta::link {
namespace {

constexpr std::int64_t kPatience_ns = 20'000'000'000;

std::int64_t soon() {
    return core::steadyNow_ns() + kPatience_ns;
}

std::string readAll(ByteLink& link) {
    std::string text;
    std::array<std::uint8_t, 4> buffer{};
    std::size_t count = 0;
    while (link.read(buffer, count, soon(), nullptr) == ByteLink::Outcome::done)
        text.append(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
    return text;
}

TEST(ByteLink, readsAFileToItsEnd) {
    const teleta::test::TemporaryFolder folder;
    auto link = ByteLink::open(FileAddress{folder.write("bytes", "some bytes")}, soon(), nullptr);
    ASSERT_TRUE(link) << core::describe(link.error());
    EXPECT_TRUE(link->isFile());
    EXPECT_EQ(readAll(*link), "some bytes");
    EXPECT_TRUE(link->ended());
    EXPECT_FALSE(link->goneReason().empty());
}

TEST(ByteLink, readsANamedPipeThatMayComeBack) {
    const teleta::test::TemporaryFolder folder;
    const std::string path = folder.path("pipe");
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    auto link = ByteLink::open(FileAddress{path}, soon(), nullptr);
    ASSERT_TRUE(link) << core::describe(link.error());
    const int writer = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(::write(writer, "abc", 3), 3);
    ::close(writer);
    EXPECT_EQ(readAll(*link), "abc");
    EXPECT_FALSE(link->ended()) << "another writer may open it";
    EXPECT_EQ(link->goneReason(), "The other program closed the pipe.");
    EXPECT_FALSE(link->isFile());
}

TEST(ByteLink, setsParityAndStopBitsOfAPort) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_GE(master, 0);
    ASSERT_EQ(::grantpt(master), 0);
    ASSERT_EQ(::unlockpt(master), 0);
    const std::string path = ::ptsname(master);
    for (const auto& [parity, stopBits] : {std::pair{Parity::none, 1}, std::pair{Parity::even, 2},
                                           std::pair{Parity::odd, 1}, std::pair{Parity::even, 1}}) {
        termios before{};
        ASSERT_EQ(::tcgetattr(master, &before), 0);
        before.c_cflag |= HUPCL;
        ASSERT_EQ(::tcsetattr(master, TCSANOW, &before), 0);
        const auto link = ByteLink::open(SerialAddress{path, 921600, parity, stopBits}, soon(), nullptr);
        ASSERT_TRUE(link) << core::describe(link.error());
        termios settings{};
        ASSERT_EQ(::tcgetattr(master, &settings), 0);
        // A pseudo-terminal keeps stop bits and the kind of parity; that there is none it says of itself.
        EXPECT_EQ((settings.c_cflag & CSTOPB) != 0, stopBits == 2);
        EXPECT_EQ((settings.c_cflag & PARODD) != 0, parity == Parity::odd);
        EXPECT_EQ(settings.c_cflag & HUPCL, 0U) << "a board must not start anew when the port is closed";
        EXPECT_EQ(::cfgetospeed(&settings), static_cast<speed_t>(B921600));
    }
    ::close(master);
}

TEST(ByteLink, refusesAUdpPortThatIsTaken) {
    for (std::uint16_t port = 40'000; port < 40'100; ++port) {
        const auto first = ByteLink::open(UdpAddress{port}, soon(), nullptr);
        if (!first)
            continue; // somebody has it
        EXPECT_TRUE(first->isDatagrams());
        const auto second = ByteLink::open(UdpAddress{port}, soon(), nullptr);
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().kind, core::ErrorKind::unavailable);
        return;
    }
    FAIL() << "no free port";
}

TEST(ByteLink, takesDatagramsOfTheOnlyHostThatMaySend) {
    const auto sendTo = [](std::uint16_t port) {
        const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_port = htons(port);
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::sendto(socket, "abc", 3, 0, reinterpret_cast<const sockaddr*>(&place), sizeof place), 3);
        ::close(socket);
    };
    struct Case {
        const char* from;
        bool isTaken;
    };
    for (const Case& known : {Case{"192.0.2.1", false}, Case{"127.0.0.1", true}, Case{"localhost", true},
                              Case{"::ffff:127.0.0.1", true}, Case{"", true}}) {
        const std::string from = known.from;
        bool isOpen = false;
        for (std::uint16_t port = 40'100; port < 40'200 && !isOpen; ++port) {
            auto link = ByteLink::open(UdpAddress{port, from}, soon(), nullptr);
            if (!link)
                continue; // somebody has it
            isOpen = true;
            sendTo(port);
            std::array<std::uint8_t, 8> buffer{};
            std::size_t count = 0;
            const std::int64_t deadline_ns = known.isTaken ? soon() : core::steadyNow_ns() + 100'000'000;
            EXPECT_EQ(link->read(buffer, count, deadline_ns, nullptr),
                      known.isTaken ? ByteLink::Outcome::done : ByteLink::Outcome::timedOut)
                << from;
            EXPECT_EQ(count, known.isTaken ? 3U : 0U) << from;
        }
        EXPECT_TRUE(isOpen) << from << ": no free port";
    }
}

TEST(ByteLink, saysThatAFolderIsNoFile) {
    const teleta::test::TemporaryFolder folder;
    const auto link = ByteLink::open(FileAddress{folder.path(".")}, soon(), nullptr);
    ASSERT_FALSE(link);
    EXPECT_EQ(link.error().kind, core::ErrorKind::refused);
    EXPECT_NE(link.error().message.find("is a folder"), std::string::npos) << link.error().message;
}

TEST(LinkAddress, isOneOfAWebSocketServer) {
    for (const char* url : {"ws://127.0.0.1:5000", "wss://host/path", "ws://[::1]:80"})
        EXPECT_TRUE(isWebAddress(url)) << url;
    for (const char* url : {"", "ws://", "ws://:5000", "ws:///path", "ws://host:99999", "ws://host:port",
                            "ws://a b", "ws://host\n", "http://host", "host:5000"})
        EXPECT_FALSE(isWebAddress(url)) << url;
}

TEST(LinkAddress, hasTheNameThatPeopleKnow) {
    EXPECT_EQ(displayName(SerialAddress{"/dev/serial/by-id/usb-skin"}), "usb-skin");
    EXPECT_EQ(displayName(TcpAddress{"hand", 1000}), "hand:1000");
    EXPECT_EQ(displayName(UdpAddress{4000}), "udp:4000");
    EXPECT_EQ(displayName(FileAddress{"runs/bytes.bin"}), "bytes.bin");
}

} // namespace
} // namespace teleta::link
