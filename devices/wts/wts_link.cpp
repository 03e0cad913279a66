// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_link.h"

#include "backend/core/device/node_claim.h"
#include "backend/core/failure.h"
#include "devices/wts/wts_text.h"

#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <netdb.h>
#include <netinet/tcp.h>
#include <optional>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <system_error>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace teleta::wts {

namespace {

using Outcome = WtsLink::Outcome;

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

core::Expected<WtsLink> WtsLink::open(const WtsAddress& address, std::int64_t deadline_ns,
                                      const WakePipe* wake) {
    if (const auto* serial = std::get_if<SerialAddress>(&address))
        return openSerial(*serial);
    return openTcp(std::get<TcpAddress>(address), deadline_ns, wake);
}

core::Expected<WtsLink> WtsLink::openSerial(const SerialAddress& address) {
    const QString path = QString::fromStdString(address.path);
    const std::optional<speed_t> speed = speedOf(address.baud);
    if (!speed) {
        QStringList known;
        for (const BaudRate& rate : kBaudRates)
            known.append(QString::number(rate.baud));
        return core::failed(core::ErrorKind::refused,
                            WtsText::tr("a serial port cannot run at %1 baud").arg(address.baud),
                            WtsText::tr("one of %1").arg(known.join(QStringLiteral(", "))));
    }
    core::FileDescriptor port(::open(address.path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    const auto cannotOpen = [&](int error) {
        return core::failed(kindOf(error), WtsText::tr("cannot open %1: %2").arg(path, systemText(error)));
    };
    if (!port.isOpen())
        return errno == EBUSY ? core::usedByAnother(address.path) : cannotOpen(errno);
    if (::isatty(port.get()) == 0)
        return core::failed(core::ErrorKind::refused, WtsText::tr("%1 is not a serial port").arg(path));
    // Terminal programs lock like this; TIOCEXCL would not keep privileged programs out.
    if (::flock(port.get(), LOCK_EX | LOCK_NB) != 0)
        return errno == EWOULDBLOCK ? core::usedByAnother(address.path) : cannotOpen(errno);
    if (::ioctl(port.get(), TIOCEXCL) != 0)
        return cannotOpen(errno);

    termios settings{};
    if (::tcgetattr(port.get(), &settings) != 0)
        return cannotOpen(errno);
    ::cfmakeraw(&settings);
    settings.c_cflag &= static_cast<tcflag_t>(~(CSTOPB | CRTSCTS));
    settings.c_cflag |= CLOCAL | CREAD;
    // With a minimum of one byte, reading nothing means a hang-up and not an empty line.
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    if (::cfsetspeed(&settings, *speed) != 0 || ::tcsetattr(port.get(), TCSANOW, &settings) != 0)
        return cannotOpen(errno);
    ::tcflush(port.get(), TCIOFLUSH);
    return WtsLink(std::move(port), false);
}

core::Expected<WtsLink> WtsLink::openTcp(const TcpAddress& address, std::int64_t deadline_ns,
                                         const WakePipe* wake) {
    const QString name = QString::fromStdString(displayName(WtsAddress(address)));
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
            WtsText::tr("cannot find %1: %2").arg(name, QString::fromLocal8Bit(::gai_strerror(code))));
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
                return core::failed(core::ErrorKind::cancelled, WtsText::tr("connecting was cancelled"));
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
        return WtsLink(std::move(socket), true);
    }
    return core::failed(core::ErrorKind::unavailable,
                        WtsText::tr("cannot connect to %1: %2").arg(name, systemText(error)));
}

Outcome WtsLink::read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                      const WakePipe* wake) {
    count = 0;
    for (;;) {
        int error = 0;
        const Outcome outcome = waitFor(m_descriptor.get(), POLLIN, deadline_ns, wake, error);
        if (outcome != Outcome::done)
            return outcome == Outcome::gone ? gone(error) : outcome;
        const ssize_t bytes = ::read(m_descriptor.get(), buffer.data(), buffer.size());
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

Outcome WtsLink::write(std::span<const std::uint8_t> bytes, std::int64_t deadline_ns, const WakePipe* wake) {
    while (!bytes.empty()) {
        int error = 0;
        const Outcome outcome = waitFor(m_descriptor.get(), POLLOUT, deadline_ns, wake, error);
        if (outcome != Outcome::done)
            return outcome == Outcome::gone ? gone(error) : outcome;
        const ssize_t written = m_socket
                                    ? ::send(m_descriptor.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                    : ::write(m_descriptor.get(), bytes.data(), bytes.size());
        if (written >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        else if (errno != EAGAIN && errno != EINTR)
            return gone(errno);
    }
    return Outcome::done;
}

Outcome WtsLink::gone(int error) {
    // A serial port that was pulled out reads as an end of file or as an input error.
    if (error != 0 && error != EIO)
        m_goneReason = WtsText::tr("The link failed: %1.").arg(systemText(error)).toStdString();
    else if (m_socket)
        m_goneReason = WtsText::tr("The sensor closed the connection.").toStdString();
    else
        m_goneReason = WtsText::tr("The device was unplugged.").toStdString();
    return Outcome::gone;
}

} // namespace teleta::wts
