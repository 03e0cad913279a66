// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/mcap/byte_fields.h"

#include <span>
#include <string>
#include <string_view>

namespace teleta::mcap {

/// Appends one message in the encoding of ROS 2: the four bytes that say "CDR, little-endian", then its
/// fields one by one, each aligned to its size, counted from after those four bytes. Thread: one. Source: OMG
/// DDSI-RTPS 2.3, 10.2 (CDR_LE, plain).
class CdrWriter {
public:
    explicit CdrWriter(std::string& bytes)
        : m_bytes(bytes) {
        m_bytes.append("\0\1\0\0", 4);
        m_origin = m_bytes.size();
    }

    template <typename Number>
    void number(Number value) {
        align(sizeof value);
        appendNumber(m_bytes, value);
    }
    /// UTF-8; a NUL follows, which the length counts.
    void text(std::string_view value) {
        number(static_cast<std::uint32_t>(value.size() + 1));
        m_bytes.append(value);
        m_bytes.push_back('\0');
    }
    /// Numbers of a fixed count.
    template <typename Number>
    void array(std::span<const Number> values) {
        if (values.empty())
            return;
        align(sizeof(Number));
        m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    /// Numbers after their count.
    template <typename Number>
    void sequence(std::span<const Number> values) {
        number(static_cast<std::uint32_t>(values.size()));
        array(values);
    }
    void byteSequence(std::string_view values) {
        number(static_cast<std::uint32_t>(values.size()));
        m_bytes.append(values);
    }

private:
    void align(std::size_t size) {
        const std::size_t past = (m_bytes.size() - m_origin) & (size - 1);
        if (past != 0)
            m_bytes.append(size - past, '\0');
    }

    std::string& m_bytes;
    std::size_t m_origin = 0;
};

} // namespace teleta::mcap
