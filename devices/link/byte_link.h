// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/file_descriptor.h"
#include "devices/link/link_address.h"
#include "devices/link/link_outcome.h"
#include "devices/link/shared_web_socket.h"
#include "devices/link/wake_pipe.h"
#include "devices/link/web_socket.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace teleta::link {

/// An open link to a sensor: a serial port, a TCP connection, the datagrams of a UDP port, the messages of a
/// WebSocket server, or a file. Every wait has a deadline and can be ended. Thread: one.
class ByteLink {
public:
    using Outcome = link::Outcome;

    /// What a datagram or a message may have at most.
    static constexpr std::size_t kLongestDatagram = WebSocket::kLongestMessage;

    /// Opens the port (raw, 8 bits, no flow control, exclusively), connects, or listens to this computer or
    /// one host.
    /// wake: may be null. Error: notFound, unavailable or refused (not a serial port, unknown baud rate);
    /// cancelled. The name of a TCP host is looked up with the system's own time-out.
    [[nodiscard]] static core::Expected<ByteLink> open(const Address& address, std::int64_t deadline_ns,
                                                       const WakePipe* wake);

    /// Waits for bytes and reads those that are there; count: how many. Of UDP and WebSocket, one message, of
    /// which a buffer that is shorter than kLongestDatagram may lose the rest.
    [[nodiscard]] Outcome read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                               const WakePipe* wake);
    [[nodiscard]] Outcome write(std::span<const std::uint8_t> bytes, std::int64_t deadline_ns,
                                const WakePipe* wake);

    /// Writes a text, for a second at most; what becomes of it shows in what the sensor sends.
    void tell(const std::string& text, const WakePipe* wake);

    /// Messages that were left out, of a WebAddress that takes texts only.
    [[nodiscard]] std::uint64_t leftOut() const {
        return m_web ? m_web->leftOut() : m_shared ? m_shared->leftOut() : 0;
    }

    /// Translated; after Outcome::gone.
    [[nodiscard]] const std::string& goneReason() const { return m_goneReason; }
    /// After Outcome::gone: a regular file was read to its end.
    [[nodiscard]] bool ended() const { return m_ended; }
    /// Each read brings one message.
    [[nodiscard]] bool isDatagrams() const { return m_kind == Kind::udp || m_kind == Kind::web; }
    /// Only the thread that opened it may use and close it.
    [[nodiscard]] bool staysInThread() const { return m_web.has_value(); }
    /// The bytes are all there, and reading waits for nothing.
    [[nodiscard]] bool isFile() const { return m_kind == Kind::file; }

private:
    enum class Kind { serial, tcp, udp, file, pipe, web };

    ByteLink(core::FileDescriptor descriptor, Kind kind)
        : m_descriptor(std::move(descriptor))
        , m_kind(kind) {}
    explicit ByteLink(WebSocket web)
        : m_kind(Kind::web)
        , m_web(std::move(web)) {}
    explicit ByteLink(SharedWebSocket shared)
        : m_kind(Kind::web)
        , m_shared(std::move(shared)) {}

    [[nodiscard]] static core::Expected<ByteLink> openSerial(const SerialAddress& address);
    [[nodiscard]] static core::Expected<ByteLink> openTcp(const TcpAddress& address, std::int64_t deadline_ns,
                                                          const WakePipe* wake);
    [[nodiscard]] static core::Expected<ByteLink> openUdp(const UdpAddress& address);
    [[nodiscard]] static core::Expected<ByteLink> openFile(const FileAddress& address);
    /// As ::read(); what is not for us counts as nothing there.
    [[nodiscard]] ssize_t take(std::span<std::uint8_t> buffer) const;
    [[nodiscard]] Outcome gone(int error);

    core::FileDescriptor m_descriptor{-1};
    Kind m_kind = Kind::serial;
    /// Addresses of the only host whose datagrams are taken; empty: any that reach us.
    std::vector<std::vector<std::uint8_t>> m_senders;
    std::optional<WebSocket> m_web;
    std::optional<SharedWebSocket> m_shared;
    bool m_ended = false;
    std::string m_goneReason;
};

} // namespace teleta::link
