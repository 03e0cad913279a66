// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/file_descriptor.h"
#include "devices/wts/wake_pipe.h"
#include "devices/wts/wts_config.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace teleta::wts {

/// An open byte stream to a sensor: a serial port or a TCP connection. Every wait has a deadline and can be
/// ended. Thread: one.
class WtsLink {
public:
    enum class Outcome {
        done,     ///< bytes were read; all bytes were written
        timedOut, ///< the deadline has passed
        woken,    ///< the wake pipe ended the wait
        gone,     ///< unplugged, closed or failed; goneReason() says why
    };

    /// Opens the port (raw, 8N1, no flow control, exclusively) or connects.
    /// wake: may be null. Error: notFound, unavailable or refused (not a serial port, unknown baud rate);
    /// cancelled. The name of a TCP host is looked up with the system's own time-out.
    [[nodiscard]] static core::Expected<WtsLink> open(const WtsAddress& address, std::int64_t deadline_ns,
                                                      const WakePipe* wake);

    /// Waits for bytes and reads those that are there; count: how many.
    [[nodiscard]] Outcome read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                               const WakePipe* wake);
    [[nodiscard]] Outcome write(std::span<const std::uint8_t> bytes, std::int64_t deadline_ns,
                                const WakePipe* wake);

    /// Translated; after Outcome::gone.
    [[nodiscard]] const std::string& goneReason() const { return m_goneReason; }

private:
    WtsLink(core::FileDescriptor descriptor, bool socket)
        : m_descriptor(std::move(descriptor))
        , m_socket(socket) {}

    [[nodiscard]] static core::Expected<WtsLink> openSerial(const SerialAddress& address);
    [[nodiscard]] static core::Expected<WtsLink> openTcp(const TcpAddress& address, std::int64_t deadline_ns,
                                                         const WakePipe* wake);
    [[nodiscard]] Outcome gone(int error);

    core::FileDescriptor m_descriptor;
    bool m_socket = false;
    std::string m_goneReason;
};

} // namespace teleta::wts
