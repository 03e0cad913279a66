// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/file_descriptor.h"

#include <arpa/inet.h>
#include <cstdint>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>

namespace teleta::test {

/// A UDP port of this machine.
class UdpListener {
public:
    UdpListener()
        : m_socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof(address);
        if (!m_socket.isOpen() ||
            ::bind(m_socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0 ||
            ::getsockname(m_socket.get(), reinterpret_cast<sockaddr*>(&address), &length) != 0)
            throw std::runtime_error("no UDP socket");
        m_port = ntohs(address.sin_port);
    }

    [[nodiscard]] std::uint16_t port() const { return m_port; }

    /// The next datagram; empty when none comes within 20 s.
    [[nodiscard]] std::string read() const {
        constexpr int kLineWait_ms = 20'000;
        pollfd ready{m_socket.get(), POLLIN, 0};
        std::string datagram(2048, '\0');
        const ssize_t size = ::poll(&ready, 1, kLineWait_ms) == 1
                                 ? ::recv(m_socket.get(), datagram.data(), datagram.size(), 0)
                                 : 0;
        datagram.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
        return datagram;
    }

private:
    core::FileDescriptor m_socket;
    std::uint16_t m_port = 0;
};

} // namespace teleta::test
