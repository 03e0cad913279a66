// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <arpa/inet.h>
#include <array>
#include <cstddef>
#include <fcntl.h>
#include <mutex>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace teleta::test {

/// A connection to a server on this machine that breaks like a network: the program loses its connections,
/// while the server keeps them because it is not told. Thread: any; the bytes pass through its own thread.
class BreakableLine {
public:
    explicit BreakableLine(int serverPort)
        : m_serverPort(serverPort)
        , m_listener(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address = loopback(0);
        socklen_t length = sizeof address;
        const bool listens = bind(m_listener, reinterpret_cast<sockaddr*>(&address), length) == 0 &&
                             listen(m_listener, 8) == 0 &&
                             getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &length) == 0 &&
                             pipe2(m_wake.data(), O_CLOEXEC) == 0;
        if (!listens)
            throw std::runtime_error("cannot listen");
        m_port = ntohs(address.sin_port);
        m_thread = std::jthread([this] { carry(); });
    }
    ~BreakableLine() {
        close(m_wake[1]); // ends the thread
        m_thread.join();
        close(m_wake[0]);
        close(m_listener);
        for (const Pair& pair : m_pairs) {
            close(pair.program);
            close(pair.server);
        }
    }
    BreakableLine(const BreakableLine&) = delete;
    BreakableLine& operator=(const BreakableLine&) = delete;

    [[nodiscard]] int port() const { return m_port; }

    /// Breaks the current connections; later ones work.
    void cut() {
        const std::scoped_lock lock(m_mutex);
        for (Pair& pair : m_pairs) {
            pair.isCut = true;
            shutdown(pair.program, SHUT_RDWR);
        }
    }

private:
    struct Pair {
        int program = -1;
        int server = -1;
        bool isCut = false;
    };

    static sockaddr_in loopback(int port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(static_cast<in_port_t>(port));
        return address;
    }

    void carry() {
        while (true) {
            std::vector<pollfd> watched{{m_listener, POLLIN, 0}, {m_wake[0], POLLIN, 0}};
            {
                const std::scoped_lock lock(m_mutex);
                for (const Pair& pair : m_pairs) {
                    if (pair.isCut)
                        continue;
                    watched.push_back({pair.program, POLLIN, 0});
                    watched.push_back({pair.server, POLLIN, 0});
                }
            }
            if (poll(watched.data(), watched.size(), -1) < 0)
                continue;
            if (watched[1].revents != 0)
                return;
            for (std::size_t i = 2; i < watched.size(); ++i) {
                if (watched[i].revents != 0)
                    pass(watched[i].fd);
            }
            // Last, because a new connection may get the descriptor of a closed one.
            if (watched[0].revents != 0)
                take();
        }
    }

    void take() {
        const int program = accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        if (program < 0)
            return;
        const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        const sockaddr_in address = loopback(m_serverPort);
        if (connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
            close(server);
            close(program);
            return;
        }
        const std::scoped_lock lock(m_mutex);
        m_pairs.push_back({program, server, false});
    }

    /// Forwards bytes from one end of a pair, or its closing.
    void pass(int from) {
        const std::scoped_lock lock(m_mutex);
        for (std::size_t i = 0; i < m_pairs.size(); ++i) {
            const Pair pair = m_pairs[i];
            if (pair.isCut || (pair.program != from && pair.server != from))
                continue;
            std::array<char, 65536> buffer{};
            const ssize_t size = recv(from, buffer.data(), buffer.size(), 0);
            if (size > 0 && sendAll(pair.program == from ? pair.server : pair.program, buffer.data(),
                                    static_cast<std::size_t>(size)))
                return;
            close(pair.program);
            close(pair.server);
            m_pairs.erase(m_pairs.begin() + static_cast<std::ptrdiff_t>(i));
            return;
        }
    }

    static bool sendAll(int to, const char* data, std::size_t size) {
        while (size > 0) {
            const ssize_t sent = send(to, data, size, MSG_NOSIGNAL);
            if (sent <= 0)
                return false;
            data += sent;
            size -= static_cast<std::size_t>(sent);
        }
        return true;
    }

    int m_serverPort;
    int m_listener;
    int m_port = 0;
    std::array<int, 2> m_wake{-1, -1};
    std::mutex m_mutex;
    std::vector<Pair> m_pairs;
    std::jthread m_thread;
};

} // namespace teleta::test
