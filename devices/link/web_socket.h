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

/// A client of a WebSocket server that only reads and waits with deadlines (Qt WebSockets in an event loop of
/// its own, which turns only while a call waits). It pings every 5 s. A message is text or bytes.
/// Thread: the one that opened it.
class WebSocket {
public:
    static constexpr std::size_t kLongestMessage = std::size_t{1} << 20U;

    /// Error: unavailable, nobody answers as such a server; cancelled.
    [[nodiscard]] static core::Expected<WebSocket> open(const WebAddress& address, std::int64_t deadline_ns,
                                                        const WakePipe* wake);
    WebSocket(WebSocket&& other) noexcept;
    WebSocket& operator=(WebSocket&& other) noexcept;
    ~WebSocket();

    /// The next message; what does not fit into the buffer is left out.
    [[nodiscard]] Outcome read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                               const WakePipe* wake);
    /// Sends a text.
    void tell(const std::string& text);

    /// Messages of bytes that were left out, of an address that takes texts only.
    [[nodiscard]] std::uint64_t leftOut() const;

    /// Translated; after Outcome::gone.
    [[nodiscard]] const std::string& goneReason() const;

private:
    struct Data;
    explicit WebSocket(std::unique_ptr<Data> data);

    std::unique_ptr<Data> m_data;
};

} // namespace teleta::link
