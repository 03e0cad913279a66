// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/byte_link.h"

#include "backend/core/device/node_claim.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/link/link_text.h"

#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <optional>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <system_error>
#include <termios.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::link {

namespace {

constexpr std::int64_t kTell_ns = 1'000'000'000;

struct BaudRate {
    int baud;
    speed_t speed;
};

constexpr std::array kBaudRates{
    BaudRate{9600, B9600},       BaudRate{19200, B19200},     BaudRate{38400, B38400},
    BaudRate{57600, B57600},     BaudRate{115200, B115200},   BaudRate{230400, B230400},
    BaudRate{460800, B460800},   BaudRate{921600, B921600},   BaudRate{1000000, B1000000},
    BaudRate{2000000, B2000000}, BaudRate{3000000, B3000000}, BaudRate{4000000, B4000000}};

std::optional<speed_t> speedOf(int baud) {
    for (const BaudRate& known : kBaudRates) {
        if (known.baud == baud)
            return known.speed;
    }
    return std::nullopt;
}

QString systemText(int error) {
    return QString::fromLocal8Bit(std::generic_category().message(error).c_str());
}

/// The address of a host, without its port; one of IPv4 within IPv6 as that of IPv4.
std::vector<std::uint8_t> hostOf(const sockaddr& address) {
    const std::uint8_t* bytes = nullptr;
    std::size_t count = 0;
    if (address.sa_family == AF_INET) {
        bytes =
            reinterpret_cast<const std::uint8_t*>(&reinterpret_cast<const sockaddr_in&>(address).sin_addr);
        count = sizeof(in_addr);
    } else if (address.sa_family == AF_INET6) {
        const in6_addr& host = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
        bytes = reinterpret_cast<const std::uint8_t*>(&host);
        count = sizeof host;
        if (IN6_IS_ADDR_V4MAPPED(&host) != 0) {
            bytes += sizeof host - sizeof(in_addr);
            count = sizeof(in_addr);
        }
    }
    return {bytes, bytes + count};
}

/// A socket for the datagrams of a port; not open: errno says why. Of IPv6, it takes those of IPv4 as well.
core::FileDescriptor udpSocket(int family, const UdpAddress& address) {
    core::FileDescriptor socket(::socket(family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.isOpen())
        return socket;
    sockaddr_in6 place6{};
    place6.sin6_family = AF_INET6;
    place6.sin6_port = htons(address.port);
    place6.sin6_addr = in6addr_any;
    sockaddr_in place4{};
    place4.sin_family = AF_INET;
    place4.sin_port = htons(address.port);
    place4.sin_addr.s_addr = htonl(address.from.empty() ? INADDR_LOOPBACK : INADDR_ANY);
    const bool is6 = family == AF_INET6;
    const int off = 0;
    if (is6)
        ::setsockopt(socket.get(), IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off);
    const auto* place =
        is6 ? reinterpret_cast<const sockaddr*>(&place6) : reinterpret_cast<const sockaddr*>(&place4);
    if (::bind(socket.get(), place, is6 ? sizeof place6 : sizeof place4) != 0)
        return core::FileDescriptor(-1);
    return socket;
}

core::ErrorKind kindOf(int error) {
    return error == ENOENT ? core::ErrorKind::notFound : core::ErrorKind::unavailable;
}

/// Waits until the descriptor is ready for these events, or has an error that the next call on it will
/// report.
Outcome waitFor(int descriptor, short events, std::int64_t deadline_ns, const WakePipe* wake, int& error) {
    std::array polled{pollfd{descriptor, events, 0},
                      pollfd{wake != nullptr ? wake->descriptor() : -1, POLLIN, 0}};
    if (pollUntil(polled, deadline_ns) < 0) {
        error = errno;
        return Outcome::gone;
    }
    if ((polled[1].revents & POLLIN) != 0)
        return Outcome::woken;
    return polled[0].revents != 0 ? Outcome::done : Outcome::timedOut;
}

} // namespace

core::Expected<ByteLink> ByteLink::open(const Address& address, std::int64_t deadline_ns,
                                        const WakePipe* wake) {
    if (const auto* serial = std::get_if<SerialAddress>(&address))
        return openSerial(*serial);
    if (const auto* udp = std::get_if<UdpAddress>(&address))
        return openUdp(*udp);
    if (const auto* file = std::get_if<FileAddress>(&address))
        return openFile(*file);
    if (const auto* web = std::get_if<WebAddress>(&address); web != nullptr && web->shared_ms > 0)
        return SharedWebSocket::open(*web, deadline_ns, wake).map([](SharedWebSocket socket) {
            return ByteLink(std::move(socket));
        });
    if (const auto* web = std::get_if<WebAddress>(&address))
        return WebSocket::open(*web, deadline_ns, wake).map([](WebSocket socket) {
            return ByteLink(std::move(socket));
        });
    return openTcp(std::get<TcpAddress>(address), deadline_ns, wake);
}

core::Expected<ByteLink> ByteLink::openSerial(const SerialAddress& address) {
    const QString path = QString::fromStdString(address.path);
    const std::optional<speed_t> speed = speedOf(address.baud);
    if (!speed) {
        QStringList known;
        for (const BaudRate& rate : kBaudRates)
            known.append(QString::number(rate.baud));
        return core::failed(core::ErrorKind::refused,
                            LinkText::tr("a serial port cannot run at %1 baud").arg(address.baud),
                            LinkText::tr("one of %1").arg(known.join(QStringLiteral(", "))));
    }
    core::FileDescriptor port(::open(address.path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    const auto cannotOpen = [&](int error) {
        return core::failed(kindOf(error), LinkText::tr("cannot open %1: %2").arg(path, systemText(error)));
    };
    if (!port.isOpen())
        return errno == EBUSY ? core::usedByAnother(address.path) : cannotOpen(errno);
    if (::isatty(port.get()) == 0)
        return core::failed(core::ErrorKind::refused, LinkText::tr("%1 is not a serial port").arg(path));
    // Terminal programs lock like this; TIOCEXCL would not keep privileged programs out.
    if (::flock(port.get(), LOCK_EX | LOCK_NB) != 0)
        return errno == EWOULDBLOCK ? core::usedByAnother(address.path) : cannotOpen(errno);
    if (::ioctl(port.get(), TIOCEXCL) != 0)
        return cannotOpen(errno);

    termios settings{};
    if (::tcgetattr(port.get(), &settings) != 0)
        return cannotOpen(errno);
    ::cfmakeraw(&settings);
    // Without HUPCL a board that starts anew when DTR falls runs on between two connections.
    settings.c_cflag &= static_cast<tcflag_t>(~(CSTOPB | CRTSCTS | PARODD | HUPCL));
    settings.c_cflag |= CLOCAL | CREAD;
    if (address.stopBits == 2)
        settings.c_cflag |= CSTOPB;
    if (address.parity != Parity::none)
        settings.c_cflag |= PARENB;
    if (address.parity == Parity::odd)
        settings.c_cflag |= PARODD;
    // With a minimum of one byte, reading nothing means a hang-up and not an empty line.
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    if (::cfsetspeed(&settings, *speed) != 0 || ::tcsetattr(port.get(), TCSANOW, &settings) != 0)
        return cannotOpen(errno);
    ::tcflush(port.get(), TCIOFLUSH);
    return ByteLink(std::move(port), Kind::serial);
}

core::Expected<ByteLink> ByteLink::openTcp(const TcpAddress& address, std::int64_t deadline_ns,
                                           const WakePipe* wake) {
    const QString name = QString::fromStdString(displayName(Address(address)));
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int code =
            ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
        code != 0)
        return core::failed(
            core::ErrorKind::notFound,
            LinkText::tr("cannot find %1: %2").arg(name, QString::fromLocal8Bit(::gai_strerror(code))));
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> list(found, &::freeaddrinfo);

    int error = EHOSTUNREACH;
    for (const addrinfo* candidate = found; candidate != nullptr; candidate = candidate->ai_next) {
        core::FileDescriptor socket(::socket(candidate->ai_family,
                                             candidate->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                                             candidate->ai_protocol));
        if (!socket.isOpen()) {
            error = errno;
            continue;
        }
        if (::connect(socket.get(), candidate->ai_addr, candidate->ai_addrlen) != 0) {
            error = errno;
            if (error != EINPROGRESS)
                continue;
            const Outcome outcome = waitFor(socket.get(), POLLOUT, deadline_ns, wake, error);
            if (outcome == Outcome::woken)
                return core::failed(core::ErrorKind::cancelled, LinkText::tr("connecting was cancelled"));
            if (outcome == Outcome::timedOut)
                error = ETIMEDOUT;
            if (outcome != Outcome::done)
                continue;
            socklen_t size = sizeof error;
            if (::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &size) != 0)
                error = errno;
            if (error != 0)
                continue;
        }
        const int on = 1;
        ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        return ByteLink(std::move(socket), Kind::tcp);
    }
    return core::failed(core::ErrorKind::unavailable,
                        LinkText::tr("cannot connect to %1: %2").arg(name, systemText(error)));
}

core::Expected<ByteLink> ByteLink::openUdp(const UdpAddress& address) {
    const QString name = QString::fromStdString(displayName(Address(address)));
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    const char* sender = address.from.empty() ? "127.0.0.1" : address.from.c_str();
    if (const int code = ::getaddrinfo(sender, nullptr, &hints, &found); code != 0)
        return core::failed(
            core::ErrorKind::notFound,
            LinkText::tr("cannot find %1: %2")
                .arg(QString::fromStdString(address.from), QString::fromLocal8Bit(::gai_strerror(code))));
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> list(found, &::freeaddrinfo);
    std::vector<std::vector<std::uint8_t>> senders;
    bool has4 = false;
    bool has6 = false;
    for (const addrinfo* candidate = found; candidate != nullptr; candidate = candidate->ai_next) {
        senders.push_back(hostOf(*candidate->ai_addr));
        has4 = has4 || senders.back().size() == sizeof(in_addr);
        has6 = has6 || candidate->ai_family == AF_INET6;
    }
    core::FileDescriptor socket = udpSocket(has6 ? AF_INET6 : AF_INET, address);
    if (!socket.isOpen() && has6 && has4 && errno != EADDRINUSE)
        socket = udpSocket(AF_INET, address); // a computer without IPv6
    if (!socket.isOpen())
        return core::failed(core::ErrorKind::unavailable,
                            LinkText::tr("cannot open %1: %2").arg(name, systemText(errno)));
    ByteLink link(std::move(socket), Kind::udp);
    if (!address.from.empty())
        link.m_senders = std::move(senders);
    return link;
}

core::Expected<ByteLink> ByteLink::openFile(const FileAddress& address) {
    const QString path = QString::fromStdString(address.path);
    core::FileDescriptor file(::open(address.path.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!file.isOpen())
        return core::failed(kindOf(errno), LinkText::tr("cannot open %1: %2").arg(path, systemText(errno)));
    struct stat about {};
    if (::fstat(file.get(), &about) != 0)
        return core::failed(kindOf(errno), LinkText::tr("cannot open %1: %2").arg(path, systemText(errno)));
    if (S_ISDIR(about.st_mode))
        return core::failed(core::ErrorKind::refused, LinkText::tr("%1 is a folder, not a file").arg(path));
    return ByteLink(std::move(file), S_ISREG(about.st_mode) ? Kind::file : Kind::pipe);
}

ssize_t ByteLink::take(std::span<std::uint8_t> buffer) const {
    if (m_kind != Kind::udp)
        return ::read(m_descriptor.get(), buffer.data(), buffer.size());
    sockaddr_storage sender{};
    socklen_t size = sizeof sender;
    const ssize_t bytes = ::recvfrom(m_descriptor.get(), buffer.data(), buffer.size(), 0,
                                     reinterpret_cast<sockaddr*>(&sender), &size);
    const auto isSender = [&] {
        const auto host = hostOf(*reinterpret_cast<sockaddr*>(&sender));
        return std::ranges::find(m_senders, host) != m_senders.end();
    };
    const bool isOther = bytes >= 0 && !m_senders.empty() && !isSender();
    if (!isOther && bytes != 0)
        return bytes;
    // Neither an empty datagram nor one of another host ends the link.
    errno = EAGAIN;
    return -1;
}

Outcome ByteLink::read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                       const WakePipe* wake) {
    count = 0;
    if (m_web) {
        const Outcome outcome = m_web->read(buffer, count, deadline_ns, wake);
        if (outcome == Outcome::gone)
            m_goneReason = m_web->goneReason();
        return outcome;
    }
    if (m_shared) {
        const Outcome outcome = m_shared->read(buffer, count, deadline_ns, wake);
        if (outcome == Outcome::gone)
            m_goneReason = m_shared->goneReason();
        return outcome;
    }
    for (;;) {
        int error = 0;
        const Outcome outcome = waitFor(m_descriptor.get(), POLLIN, deadline_ns, wake, error);
        if (outcome != Outcome::done)
            return outcome == Outcome::gone ? gone(error) : outcome;
        const ssize_t bytes = take(buffer);
        if (bytes > 0) {
            count = static_cast<std::size_t>(bytes);
            return Outcome::done;
        }
        if (bytes == 0)
            return gone(0);
        if (errno != EAGAIN && errno != EINTR)
            return gone(errno);
    }
}

Outcome ByteLink::write(std::span<const std::uint8_t> bytes, std::int64_t deadline_ns, const WakePipe* wake) {
    while (!bytes.empty()) {
        int error = 0;
        const Outcome outcome = waitFor(m_descriptor.get(), POLLOUT, deadline_ns, wake, error);
        if (outcome != Outcome::done)
            return outcome == Outcome::gone ? gone(error) : outcome;
        const ssize_t written = m_kind == Kind::tcp
                                    ? ::send(m_descriptor.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                    : ::write(m_descriptor.get(), bytes.data(), bytes.size());
        if (written >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        else if (errno != EAGAIN && errno != EINTR)
            return gone(errno);
    }
    return Outcome::done;
}

void ByteLink::tell(const std::string& text, const WakePipe* wake) {
    if (m_web)
        return m_web->tell(text);
    if (m_shared)
        return; // a server that several ask is told nothing
    (void)write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                core::steadyNow_ns() + kTell_ns, wake);
}

Outcome ByteLink::gone(int error) {
    m_ended = m_kind == Kind::file && error == 0;
    // A serial port that was pulled out reads as an end of file or as an input error.
    if (m_kind == Kind::serial && (error == 0 || error == EIO))
        m_goneReason = LinkText::tr("The device was unplugged.").toStdString();
    else if (error != 0)
        m_goneReason = LinkText::tr("The link failed: %1.").arg(systemText(error)).toStdString();
    else if (m_kind == Kind::tcp)
        m_goneReason = LinkText::tr("The sensor closed the connection.").toStdString();
    else if (m_kind == Kind::pipe)
        m_goneReason = LinkText::tr("The other program closed the pipe.").toStdString();
    else
        m_goneReason = LinkText::tr("The file has ended.").toStdString();
    return Outcome::gone;
}

} // namespace teleta::link
