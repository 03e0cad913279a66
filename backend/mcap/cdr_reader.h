// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace teleta::mcap {

/// Reads the fields of one message in plain CDR, of either byte order. Past the end of the message, and when
/// it is of another encoding, all results are zero or empty, and failed() is true from then on. Thread: one.
/// Source: as CdrWriter.
class CdrReader {
public:
    explicit CdrReader(std::string_view message) {
        constexpr std::size_t kHead = 4;
        // 00 00: big-endian, 00 01: little-endian; the others are other encodings.
        m_failed = message.size() < kHead || message[0] != '\0' || (message[1] != '\0' && message[1] != '\1');
        if (m_failed)
            return;
        m_isBigEndian = message[1] == '\0';
        m_bytes = message.substr(kHead);
    }

    template <typename Number>
    Number number() {
        Number value{};
        if (const char* bytes = take(1, sizeof value))
            value = numberAt<Number>(bytes);
        return value;
    }
    /// Without the closing NUL.
    std::string_view text() {
        const auto length = number<std::uint32_t>();
        const std::string_view all = bytes(length);
        return all.empty() || all.back() != '\0' ? all : all.substr(0, all.size() - 1);
    }
    /// A fixed count of numbers.
    template <typename Number>
    void array(std::size_t count, std::vector<Number>& values) {
        values.clear();
        if (count == 0)
            return;
        const char* bytes = take(count, sizeof(Number));
        if (bytes == nullptr)
            return;
        values.resize(count);
        if (!m_isBigEndian) {
            std::memcpy(values.data(), bytes, count * sizeof(Number));
            return;
        }
        for (std::size_t i = 0; i < count; ++i)
            values[i] = numberAt<Number>(bytes + i * sizeof(Number));
    }
    template <typename Number>
    void sequence(std::vector<Number>& values) {
        array(number<std::uint32_t>(), values);
    }
    std::string_view byteSequence() { return bytes(number<std::uint32_t>()); }

    /// How many elements of at least so many bytes follow: a count that the message cannot hold is refused.
    std::size_t count(std::size_t leastBytes) {
        const auto claimed = number<std::uint32_t>();
        if (claimed > (m_bytes.size() - m_at) / leastBytes)
            m_failed = true;
        return m_failed ? 0 : claimed;
    }

    [[nodiscard]] bool isBigEndian() const { return m_isBigEndian; }
    [[nodiscard]] bool failed() const { return m_failed; }

private:
    std::string_view bytes(std::size_t size) {
        const char* first = take(size, 1);
        return first == nullptr ? std::string_view() : std::string_view(first, size);
    }

    /// Null when there are not so many.
    const char* take(std::size_t count, std::size_t size) {
        const std::size_t start = (m_at + size - 1) & ~(size - 1);
        if (m_failed || start > m_bytes.size() || count > (m_bytes.size() - start) / size) {
            m_failed = true;
            return nullptr;
        }
        m_at = start + count * size;
        return m_bytes.data() + start;
    }

    template <typename Number>
    [[nodiscard]] Number numberAt(const char* bytes) const {
        std::array<char, sizeof(Number)> copy{};
        std::copy_n(bytes, sizeof(Number), copy.begin());
        if (m_isBigEndian)
            std::ranges::reverse(copy);
        Number value{};
        std::memcpy(&value, copy.data(), sizeof value);
        return value;
    }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    bool m_isBigEndian = false;
    bool m_failed = false;
};

} // namespace teleta::mcap
