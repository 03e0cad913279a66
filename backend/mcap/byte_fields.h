// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/mcap/mcap_types.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace teleta::mcap {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

/// Appends a number, little-endian.
template <typename Number>
void appendNumber(std::string& bytes, Number value) {
    char copy[sizeof value];
    std::memcpy(copy, &value, sizeof value);
    bytes.append(copy, sizeof value);
}

/// Appends a text after its length as u32.
inline void appendText(std::string& bytes, std::string_view text) {
    appendNumber(bytes, static_cast<std::uint32_t>(text.size()));
    bytes.append(text);
}

/// Overwrites a number within the bytes.
template <typename Number>
void putNumber(std::string& bytes, std::size_t at, Number value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// Appends a map of texts after its length in bytes as u32.
inline void appendMap(std::string& bytes, const TextMap& map) {
    const std::size_t start = bytes.size();
    appendNumber(bytes, std::uint32_t{0});
    for (const auto& [key, value] : map) {
        appendText(bytes, key);
        appendText(bytes, value);
    }
    putNumber(bytes, start, static_cast<std::uint32_t>(bytes.size() - start - sizeof(std::uint32_t)));
}

/// Appends a record: what `content` appends stands between opcode, length and the next record.
template <typename Content>
void appendRecord(std::string& bytes, Opcode opcode, const Content& content) {
    appendNumber(bytes, static_cast<std::uint8_t>(opcode));
    const std::size_t start = bytes.size();
    appendNumber(bytes, std::uint64_t{0});
    content();
    putNumber(bytes, start, static_cast<std::uint64_t>(bytes.size() - start - sizeof(std::uint64_t)));
}

/// Reads the fields of a record one by one. Past the end of the bytes all results are zero or empty, and
/// failed() is true from then on: a reader needs to ask only once, at its end.
class FieldReader {
public:
    explicit FieldReader(std::string_view bytes)
        : m_rest(bytes) {}

    template <typename Number>
    Number number() {
        Number value{};
        if (const std::string_view taken = take(sizeof value); taken.size() == sizeof value)
            std::memcpy(&value, taken.data(), sizeof value);
        return value;
    }
    std::string_view text() { return take(number<std::uint32_t>()); }
    /// Bytes after their length as u64.
    std::string_view longBytes() { return take(number<std::uint64_t>()); }
    TextMap map() {
        FieldReader pairs(text());
        TextMap values;
        while (!pairs.m_rest.empty() && !pairs.failed()) {
            const std::string_view key = pairs.text();
            values.insert_or_assign(std::string(key), std::string(pairs.text()));
        }
        m_failed = m_failed || pairs.failed();
        return values;
    }
    [[nodiscard]] std::string_view rest() const { return m_rest; }
    [[nodiscard]] bool failed() const { return m_failed; }

private:
    std::string_view take(std::uint64_t size) {
        if (m_failed || size > m_rest.size()) {
            m_failed = true;
            m_rest = {};
            return {};
        }
        const std::string_view taken = m_rest.substr(0, static_cast<std::size_t>(size));
        m_rest.remove_prefix(static_cast<std::size_t>(size));
        return taken;
    }

    std::string_view m_rest;
    bool m_failed = false;
};

} // namespace teleta::mcap
