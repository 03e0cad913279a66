// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/line_relay.h"

#include "backend/core/failure.h"
#include "backend/core/file_descriptor.h"

#include <QCoreApplication>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stop_token>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using core::FileDescriptor;

struct RelayText {
    Q_DECLARE_TR_FUNCTIONS(RelayText)
};

constexpr int kLook_ms = 2;

/// Small messages leave at once.
void sendSoon(const FileDescriptor& socket) {
    const int yes = 1;
    setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

struct Pair {
    FileDescriptor program;
    FileDescriptor server;
    std::string held; ///< answers that wait
    bool broken = false;
};

class Relay : public LineRelay {
public:
    Relay(FileDescriptor listener, std::uint16_t port, sockaddr_storage server, socklen_t length)
        : m_listener(std::move(listener))
        , m_port(port)
        , m_server(server)
        , m_length(length)
        , m_thread([this](const std::stop_token& stop) { run(stop); }) {}

    [[nodiscard]] std::uint16_t port() const override { return m_port; }
    void set(LineFault fault) override { m_fault.store(fault, std::memory_order_release); }

private:
    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            const LineFault fault = m_fault.load(std::memory_order_acquire);
            if (fault == LineFault::cut)
                m_pairs.clear();
            std::vector<pollfd> waits{{m_listener.get(), POLLIN, 0}};
            for (Pair& pair : m_pairs) {
                if (fault != LineFault::late && !pair.held.empty())
                    pair.broken = !pass(pair.program, std::exchange(pair.held, {}));
                waits.push_back({pair.program.get(), POLLIN, 0});
                waits.push_back({pair.server.get(), POLLIN, 0});
            }
            if (poll(waits.data(), waits.size(), kLook_ms) > 0) {
                for (std::size_t k = 0; k < m_pairs.size(); ++k) {
                    if (waits[2 * k + 1].revents != 0)
                        request(m_pairs[k]);
                    if (waits[2 * k + 2].revents != 0)
                        answer(m_pairs[k]);
                }
                if (waits.front().revents != 0)
                    welcome();
            }
            std::erase_if(m_pairs, [](const Pair& pair) { return pair.broken; });
        }
    }

    void welcome() {
        FileDescriptor program(accept4(m_listener.get(), nullptr, nullptr, SOCK_CLOEXEC));
        if (!program.isOpen() || m_fault.load(std::memory_order_acquire) == LineFault::cut)
            return;
        FileDescriptor server(socket(m_server.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
        if (connect(server.get(), reinterpret_cast<const sockaddr*>(&m_server), m_length) != 0)
            return;
        sendSoon(program);
        sendSoon(server);
        m_pairs.push_back({std::move(program), std::move(server), {}, false});
    }

    /// What waits in a socket; empty: its other end is gone.
    [[nodiscard]] static std::string take(const FileDescriptor& from) {
        std::array<char, 4096> bytes{};
        const ssize_t length = recv(from.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
        return length > 0 ? std::string(bytes.data(), static_cast<std::size_t>(length)) : std::string();
    }

    [[nodiscard]] static bool pass(const FileDescriptor& to, const std::string& bytes) {
        return send(to.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
    }

    void request(Pair& pair) {
        const std::string bytes = take(pair.program);
        if (bytes.empty())
            pair.broken = true;
        else if (m_fault.load(std::memory_order_acquire) != LineFault::lost)
            pair.broken = !pass(pair.server, bytes);
    }

    void answer(Pair& pair) {
        std::string bytes = take(pair.server);
        if (bytes.empty()) {
            pair.broken = true;
            return;
        }
        // Bytes 0 and 1 number the request, 4 and 5 the length of what follows, 7 is the function.
        constexpr std::size_t kFunction = 7;
        switch (m_fault.load(std::memory_order_acquire)) {
        case LineFault::late:
            pair.held += bytes;
            return;
        case LineFault::garbage:
            for (char& byte : bytes)
                byte = 'U';
            break;
        case LineFault::refused:
            if (bytes.size() > kFunction) {
                bytes.resize(kFunction + 2);
                bytes[4] = 0;
                bytes[5] = 3;
                bytes[kFunction] = static_cast<char>(static_cast<unsigned char>(bytes[kFunction]) | 0x80U);
                bytes[kFunction + 1] = 4; // failure of the device
            }
            break;
        case LineFault::strange:
            bytes.front() = static_cast<char>(~static_cast<unsigned char>(bytes.front()));
            break;
        default:
            break;
        }
        pair.broken = !pass(pair.program, bytes);
    }

    FileDescriptor m_listener;
    std::uint16_t m_port;
    sockaddr_storage m_server;
    socklen_t m_length;
    std::atomic<LineFault> m_fault{LineFault::none};
    std::vector<Pair> m_pairs; ///< of the thread
    std::jthread m_thread;     ///< last, so that it ends first
};

core::Unexpected noLine(const QString& why) {
    return core::failed(core::ErrorKind::unavailable,
                        RelayText::tr("no line to the driver can be opened: %1").arg(why));
}

} // namespace

core::Expected<std::unique_ptr<LineRelay>> LineRelay::start(const std::string& host, int port) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (const int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); error != 0)
        return noLine(QString::fromLocal8Bit(gai_strerror(error)));
    sockaddr_storage server{};
    const socklen_t length = found->ai_addrlen;
    std::memcpy(&server, found->ai_addr, length);
    freeaddrinfo(found);

    FileDescriptor listener(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t ownLength = sizeof own;
    constexpr int kWaiting = 8;
    if (bind(listener.get(), reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0 ||
        listen(listener.get(), kWaiting) != 0 ||
        getsockname(listener.get(), reinterpret_cast<sockaddr*>(&own), &ownLength) != 0)
        return noLine(QString::fromLocal8Bit(std::strerror(errno)));
    return std::make_unique<Relay>(std::move(listener), ntohs(own.sin_port), server, length);
}

} // namespace teleta::cli
