// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/trigger/osc_trigger.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <bit>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

namespace teleta::trigger {

namespace {

struct OscText {
    Q_DECLARE_TR_FUNCTIONS(OscTrigger)
};

constexpr std::size_t kAlignment = 4;

/// Text with at least one zero byte behind it, filled up to a multiple of four.
void addText(std::vector<char>& message, std::string_view text) {
    message.insert(message.end(), text.begin(), text.end());
    do
        message.push_back('\0');
    while (message.size() % kAlignment != 0);
}

/// Big-endian.
template <typename Unsigned>
void addNumber(std::vector<char>& message, Unsigned value) {
    for (int shift = static_cast<int>(8 * sizeof(Unsigned)) - 8; shift >= 0; shift -= 8)
        message.push_back(static_cast<char>((value >> shift) & 0xFFU));
}

} // namespace

std::vector<char> oscMessage(const core::TriggerEvent& event) {
    std::vector<char> message;
    addText(message, "/teleta/trial");
    addText(message, ",ssifh");
    addText(message, event.word());
    addText(message, event.session);
    addNumber(message, static_cast<std::uint32_t>(event.trial));
    addNumber(message,
              std::bit_cast<std::uint32_t>(event.level.value_or(std::numeric_limits<float>::quiet_NaN())));
    addNumber(message, static_cast<std::uint64_t>(event.time_ns));
    return message;
}

OscTrigger::OscTrigger(std::string name, core::FileDescriptor socket, const sockaddr_storage& address,
                       socklen_t length)
    : m_name(std::move(name))
    , m_socket(std::move(socket))
    , m_address(address)
    , m_length(length) {
}

core::Expected<std::unique_ptr<core::TriggerPort>> OscTrigger::open(const std::string& host,
                                                                    std::uint16_t port) {
    const std::string name = host + ':' + std::to_string(port);
    addrinfo hints{};
    hints.ai_socktype = SOCK_DGRAM;
    hints.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int code = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); code != 0)
        return core::failed(core::ErrorKind::notFound,
                            OscText::tr("the host for triggers was not found: %1")
                                .arg(QString::fromLocal8Bit(::gai_strerror(code))),
                            OscText::tr("a name or an address"), {name});
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, ::freeaddrinfo);
    core::FileDescriptor socket(::socket(found->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.isOpen())
        return core::failed(
            core::ErrorKind::ioFailed,
            OscText::tr("triggers cannot be sent: %1").arg(QString::fromLocal8Bit(std::strerror(errno))), {},
            {name});
    sockaddr_storage address{};
    std::memcpy(&address, found->ai_addr, found->ai_addrlen);
    return std::unique_ptr<core::TriggerPort>(
        new OscTrigger(name, std::move(socket), address, found->ai_addrlen));
}

core::Expected<void> OscTrigger::write(const core::TriggerEvent& event) {
    const std::vector<char> message = oscMessage(event);
    // Not connected: a listener that has gone must not fail the next event.
    const ssize_t sent = ::sendto(m_socket.get(), message.data(), message.size(), 0,
                                  reinterpret_cast<const sockaddr*>(&m_address), m_length);
    if (sent == static_cast<ssize_t>(message.size()))
        return {};
    return core::failed(
        core::ErrorKind::ioFailed,
        OscText::tr("triggers cannot be sent: %1").arg(QString::fromLocal8Bit(std::strerror(errno))), {},
        {m_name});
}

} // namespace teleta::trigger
