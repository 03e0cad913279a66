// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/file_descriptor.h"

#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace teleta::test {

/// A serial line whose other end is the test.
class PseudoTerminal {
public:
    PseudoTerminal()
        : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        if (!m_master.isOpen() || ::grantpt(m_master.get()) != 0 || ::unlockpt(m_master.get()) != 0)
            throw std::runtime_error("no pseudo-terminal");
        m_name = ::ptsname(m_master.get());
    }

    [[nodiscard]] const std::string& name() const { return m_name; }
    /// The other side sees the line hang up.
    void hangUp() { m_master = core::FileDescriptor(-1); }

    /// Waits for so many bytes; fewer when they do not come within 20 s.
    [[nodiscard]] std::vector<std::uint8_t> read(std::size_t count) const {
        constexpr int kLineWait_ms = 20'000;
        std::vector<std::uint8_t> bytes;
        while (bytes.size() < count) {
            pollfd ready{m_master.get(), POLLIN, 0};
            std::uint8_t byte = 0;
            if (::poll(&ready, 1, kLineWait_ms) != 1 || ::read(m_master.get(), &byte, 1) != 1)
                break;
            bytes.push_back(byte);
        }
        return bytes;
    }

private:
    core::FileDescriptor m_master;
    std::string m_name;
};

} // namespace teleta::test
