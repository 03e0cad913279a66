// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace teleta::link {

enum class Parity { none, even, odd };

struct SerialAddress {
    std::string path;
    int baud = 115200; ///< one that the system knows: 9600 .. 4000000
    Parity parity = Parity::none;
    int stopBits = 1; ///< 1 or 2

    bool operator==(const SerialAddress&) const = default;
};

struct TcpAddress {
    std::string host; ///< name or number; IPv6 without brackets
    std::uint16_t port = 0;

    bool operator==(const TcpAddress&) const = default;
};

/// Datagrams that are sent to a port of this computer.
struct UdpAddress {
    std::uint16_t port = 0;
    std::string from = {}; ///< the only host whose datagrams are taken; empty: this computer

    bool operator==(const UdpAddress&) const = default;
};

/// Bytes that were kept in a file, or that another program writes into a named pipe.
struct FileAddress {
    std::string path;

    bool operator==(const FileAddress&) const = default;
};

/// A WebSocket server.
struct WebAddress {
    std::string url;        ///< ws://HOST:PORT/PATH or wss://
    bool textsOnly = false; ///< messages of bytes are left out and counted
    /// > 0: the connection is shared with others of the same URL, and ends when no message comes for so long.
    int shared_ms = 0;

    bool operator==(const WebAddress&) const = default;
};

/// In the order of their names in a file.
using Address = std::variant<SerialAddress, TcpAddress, UdpAddress, WebAddress, FileAddress>;

/// "ttyUSB0", "host:port", "udp:port", "bytes.bin" or "ws://host:port": the name under which people know the
/// link.
[[nodiscard]] std::string displayName(const Address& address);

/// A valid "ws://HOST..." or "wss://HOST...".
[[nodiscard]] bool isWebAddress(const std::string& url);

} // namespace teleta::link
