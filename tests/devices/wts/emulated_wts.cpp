// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/wts/emulated_wts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace teleta::wts::test {

namespace {

constexpr int kTick_ms = 2; ///< after so long a thread looks whether it is to end
constexpr auto kPatience = std::chrono::seconds(20);

bool isReady(int descriptor, short events) {
    pollfd polled{descriptor, events, 0};
    return ::poll(&polled, 1, kTick_ms) > 0;
}

void closeIfOpen(int& descriptor) {
    if (descriptor >= 0)
        ::close(std::exchange(descriptor, -1));
}

} // namespace

EmulatedWts::EmulatedWts(Link link, Behaviour behaviour)
    : m_link(link)
    , m_behaviour(std::move(behaviour)) {
    if (m_link == Link::pty) {
        std::string folder = (std::filesystem::temp_directory_path() / "teleta_wts_XXXXXX").string();
        if (::mkdtemp(folder.data()) == nullptr)
            ADD_FAILURE() << "cannot make " << folder;
        m_folder = folder;
    }
    plug();
}

EmulatedWts::~EmulatedWts() {
    unplug();
    if (!m_folder.empty())
        std::filesystem::remove_all(m_folder);
}

std::string EmulatedWts::address() const {
    if (m_link == Link::tcp)
        return "tcp://127.0.0.1:" + std::to_string(m_port);
    return (m_folder / "ttyWTS").string();
}

void EmulatedWts::plug() {
    m_ending = false;
    if (m_link == Link::pty) {
        m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0) {
            ADD_FAILURE() << "no pseudo-terminal";
            return;
        }
        std::array<char, 128> name{};
        ASSERT_EQ(::ptsname_r(m_master, name.data(), name.size()), 0);
        m_slave = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        std::filesystem::create_symlink(name.data(), address());
        setConnected(m_master);
        m_thread = std::jthread([this](const std::stop_token& stop) { serve(stop, m_master); });
        return;
    }
    m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(m_listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    place.sin_port = ::htons(static_cast<std::uint16_t>(m_port));
    socklen_t size = sizeof place;
    void* const bytes = &place;
    ASSERT_EQ(::bind(m_listener, static_cast<sockaddr*>(bytes), size), 0);
    ASSERT_EQ(::listen(m_listener, 1), 0);
    ASSERT_EQ(::getsockname(m_listener, static_cast<sockaddr*>(bytes), &size), 0);
    m_port = ::ntohs(place.sin_port);
    m_thread = std::jthread([this](const std::stop_token& stop) { serveConnections(stop, m_listener); });
}

void EmulatedWts::unplug() {
    setConnected(-1);
    m_ending = true;
    if (m_thread.joinable()) {
        m_thread.request_stop();
        m_thread.join();
    }
    const std::scoped_lock writing(m_writing);
    if (m_link == Link::pty)
        std::filesystem::remove(address());
    closeIfOpen(m_slave);
    closeIfOpen(m_master);
    closeIfOpen(m_listener);
}

void EmulatedWts::change(const std::function<void(Behaviour&)>& change) {
    const std::scoped_lock lock(m_mutex);
    change(m_behaviour);
}

bool EmulatedWts::send(const Bytes& bytes) {
    const std::scoped_lock writing(m_writing);
    int descriptor = -1;
    {
        const std::scoped_lock lock(m_mutex);
        descriptor = m_connected;
    }
    return descriptor >= 0 && write(bytes, descriptor);
}

bool EmulatedWts::streaming() const {
    const std::scoped_lock lock(m_mutex);
    return m_streaming;
}

int EmulatedWts::requests(Command command) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_requests.find(static_cast<std::uint8_t>(command));
    return found == m_requests.end() ? 0 : found->second;
}

Bytes EmulatedWts::params(Command command) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_params.find(static_cast<std::uint8_t>(command));
    return found == m_params.end() ? Bytes{} : found->second;
}

bool EmulatedWts::waitForRequests(Command command, int count) {
    std::unique_lock lock(m_mutex);
    return m_changed.wait_for(lock, kPatience,
                              [&] { return m_requests[static_cast<std::uint8_t>(command)] >= count; });
}

void EmulatedWts::setConnected(int descriptor) {
    const std::scoped_lock lock(m_mutex);
    m_connected = descriptor;
    m_streaming = false;
}

void EmulatedWts::serveConnections(const std::stop_token& stop, int listener) {
    while (!stop.stop_requested()) {
        if (!isReady(listener, POLLIN))
            continue;
        int connection = ::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (connection < 0)
            continue;
        setConnected(connection);
        serve(stop, connection);
        setConnected(-1);
        const std::scoped_lock writing(m_writing);
        closeIfOpen(connection);
    }
}

void EmulatedWts::serve(const std::stop_token& stop, int descriptor) {
    MessageDecoder decoder;
    std::array<std::uint8_t, 512> buffer{};
    std::uint32_t flooded = 0;
    while (!stop.stop_requested()) {
        bool flood = false;
        {
            const std::scoped_lock lock(m_mutex);
            flood = m_behaviour.flood;
        }
        if (flood) {
            const std::scoped_lock writing(m_writing);
            write(frame(++flooded, false, std::vector<unsigned>(84)), descriptor);
        }
        if (!isReady(descriptor, POLLIN))
            continue;
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count == 0)
            return; // the client closed its connection
        if (count < 0 && (errno == EAGAIN || errno == EINTR))
            continue;
        if (count < 0)
            return;
        decoder.feed(std::span(buffer).first(static_cast<std::size_t>(count)));
        Message message;
        while (decoder.next(message))
            obey(message, descriptor);
    }
}

void EmulatedWts::obey(const Message& message, int descriptor) {
    const std::scoped_lock writing(m_writing);
    const auto command = static_cast<Command>(message.id);
    Bytes reply;
    {
        const std::scoped_lock lock(m_mutex);
        const bool deaf = m_behaviour.deafTo > 0;
        m_behaviour.deafTo -= deaf ? 1 : 0;
        const auto other = m_behaviour.status.find(command);
        const unsigned status = other == m_behaviour.status.end() ? 0 : other->second;
        if (!deaf && command == Command::startFrames)
            m_streaming = status == 0 || status == static_cast<unsigned>(Status::alreadyRunning);
        if (!deaf && command == Command::stopFrames)
            m_streaming = false;
        if (!deaf) {
            Bytes params;
            if (command == Command::matrixInfo) {
                params = matrixInfoParams(m_behaviour.columns, m_behaviour.rows, m_behaviour.cellWidth_10um,
                                          m_behaviour.cellHeight_10um);
                params.resize(static_cast<std::size_t>(m_behaviour.matrixParams));
            }
            reply = m_behaviour.beforeAnswer;
            append(reply, answer(command, status, params));
        }
    }
    write(reply, descriptor);
    // Told only now, so that frames which the test sends next come after the answer.
    const std::scoped_lock lock(m_mutex);
    ++m_requests[message.id];
    m_params[message.id] = Bytes(message.payload.begin(), message.payload.end());
    m_changed.notify_all();
}

bool EmulatedWts::write(const Bytes& bytes, int descriptor) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t count = m_link == Link::tcp
                                  ? ::send(descriptor, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL)
                                  : ::write(descriptor, bytes.data() + sent, bytes.size() - sent);
        if (count > 0) {
            sent += static_cast<std::size_t>(count);
            continue;
        }
        const bool wait = count < 0 && (errno == EAGAIN || errno == EINTR);
        if (!wait || std::chrono::steady_clock::now() > deadline || m_ending.load())
            return false;
        (void)isReady(descriptor, POLLOUT);
    }
    return true;
}

} // namespace teleta::wts::test
