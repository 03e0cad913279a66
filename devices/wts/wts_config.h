// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/link/link_address.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace teleta::wts {

inline constexpr std::int64_t kMs_ns = 1'000'000;

using SerialAddress = link::SerialAddress;
using TcpAddress = link::TcpAddress;
/// A serial port or a TCP connection.
using WtsAddress = link::Address;

/// "tcp://HOST:PORT" (IPv6 as tcp://[::1]:PORT), else the path of a serial port, at this baud rate.
/// Error: badInput with what was expected; the place is the caller's.
[[nodiscard]] core::Expected<WtsAddress> parseWtsAddress(std::string_view text, int baud = 115200);

/// Timeouts in ms; all > 0 unless 0 has a meaning.
struct WtsTimes {
    int connect_ms = 2000;    ///< TCP connection
    int answer_ms = 300;      ///< answer to one request; asked up to three times
    int tare_ms = 3000;       ///< answer to a tare request, which measures first
    int lineSilence_ms = 200; ///< after this, the rest of a message is not expected any more
    int stale_ms = 0;       ///< age of the newest frame that is stale; 0: by the rate, as core::staleAfter_ns
    int noFrames_ms = 2000; ///< time without a good frame after which the sensor is lost; at least 5 periods
    int firstRetry_ms = 100;    ///< wait before connecting again; doubles
    int longestRetry_ms = 2000; ///< up to this
};

struct WtsConfig {
    WtsAddress address;
    bool runLength = false;     ///< the sensor compresses its frames; values are then limited to 12 bits
    std::uint16_t delay_ms = 0; ///< between frames; 0: as fast as the sensor and the link can
    bool tare = false;          ///< the sensor tares itself when the source is started (not on reconnecting)
    double timestampUnit_s = 1e-3;
    WtsTimes times{};
    std::size_t queueBlocks = 256;
};

} // namespace teleta::wts
