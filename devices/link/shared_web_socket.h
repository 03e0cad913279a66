// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/link/link_address.h"
#include "devices/link/link_outcome.h"
#include "devices/link/wake_pipe.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace teleta::link {

/// One reader of a WebSocket connection that all readers of the same address in this program share: a server
/// that tells several sensors in one message is asked once. A thread of its own reads the connection. It is
/// closed when the last reader has gone, and ends for all when the server closes it or no message comes for
/// WebAddress::shared_ms. A reader that comes later gets what comes from then on. Thread: one at a time.
class SharedWebSocket {
public:
    /// Error: as WebSocket::open().
    [[nodiscard]] static core::Expected<SharedWebSocket> open(const WebAddress& address,
                                                              std::int64_t deadline_ns, const WakePipe* wake);
    SharedWebSocket(SharedWebSocket&& other) noexcept;
    SharedWebSocket& operator=(SharedWebSocket&& other) noexcept;
    ~SharedWebSocket();

    /// As WebSocket::read(). Of a reader that is slow the oldest messages are left out.
    [[nodiscard]] Outcome read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                               const WakePipe* wake);
    /// Messages of bytes that were left out since this reader came, of an address that takes texts only.
    [[nodiscard]] std::uint64_t leftOut() const;
    /// Translated; after Outcome::gone.
    [[nodiscard]] const std::string& goneReason() const { return m_goneReason; }

private:
    class Connection;
    struct Reader;
    SharedWebSocket(std::shared_ptr<Connection> connection, std::shared_ptr<Reader> reader);

    std::shared_ptr<Connection> m_connection;
    std::shared_ptr<Reader> m_reader;
    std::string m_goneReason;
};

} // namespace teleta::link
