// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <memory>
#include <string>

namespace teleta::cli {

/// What a line does to what it carries.
enum class LineFault {
    none,
    cut,     ///< connections end, and new ones end at once
    late,    ///< answers wait until the fault is over
    lost,    ///< requests do not arrive
    garbage, ///< answers are other bytes
    refused, ///< answers are exceptions of the Modbus protocol
    strange, ///< answers belong to another request
};

/// A TCP line between a program and a Modbus server that can be made to fail. It listens on 127.0.0.1.
/// Thread: any; it has a thread of its own.
class LineRelay {
public:
    /// Error: unavailable, when no port can be opened or the host has no address.
    [[nodiscard]] static core::Expected<std::unique_ptr<LineRelay>> start(const std::string& host, int port);
    virtual ~LineRelay() = default;
    LineRelay(const LineRelay&) = delete;
    LineRelay& operator=(const LineRelay&) = delete;

    [[nodiscard]] virtual std::uint16_t port() const = 0;
    /// From now on.
    virtual void set(LineFault fault) = 0;

protected:
    LineRelay() = default;
};

} // namespace teleta::cli
