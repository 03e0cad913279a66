// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/service_manager.h"
#include "backend/core/file_descriptor.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>

namespace teleta::site_program {
namespace {

/// What systemd listens on.
class Listener {
public:
    explicit Listener(const std::string& name)
        : m_socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::ranges::copy(name, address.sun_path);
        if (name.front() == '@')
            address.sun_path[0] = '\0';
        const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
        EXPECT_EQ(::bind(m_socket.get(), reinterpret_cast<const sockaddr*>(&address), length), 0);
        setenv("NOTIFY_SOCKET", name.c_str(), 1);
    }
    ~Listener() { unsetenv("NOTIFY_SOCKET"); }

    [[nodiscard]] std::string heard() const {
        std::array<char, 256> bytes{};
        const ssize_t size = ::recv(m_socket.get(), bytes.data(), bytes.size(), 0);
        return {bytes.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
    }

private:
    core::FileDescriptor m_socket;
};

TEST(ServiceManager, isToldThroughItsSocket) {
    const test::TemporaryFolder folder;
    const Listener systemd(folder.path("notify"));
    ServiceManager().tell("READY=1");
    EXPECT_EQ(systemd.heard(), "READY=1");
}

TEST(ServiceManager, mayHaveAnAbstractSocket) {
    const Listener systemd("@teleta-service-manager-test-" + std::to_string(::getpid()));
    ServiceManager().tell("WATCHDOG=1");
    EXPECT_EQ(systemd.heard(), "WATCHDOG=1");
}

TEST(ServiceManager, isNotNeeded) {
    unsetenv("NOTIFY_SOCKET");
    ServiceManager().tell("READY=1");
    setenv("NOTIFY_SOCKET", "/nowhere/at/all", 1);
    ServiceManager().tell("READY=1");
    unsetenv("NOTIFY_SOCKET");
}

} // namespace
} // namespace teleta::site_program
