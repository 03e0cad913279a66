// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/wts/wts_codec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::wts {

/// Finds the messages in a stream of bytes that may contain anything else: boot texts, damaged and truncated
/// messages, surplus preamble bytes. After a false start the search resumes at its second byte, so that an
/// intact message is never lost to a damaged one before it.
///   bytes fed = bytes of messages + droppedBytes + pendingBytes
/// Depends only on the bytes, not on how they were cut into calls of feed(). Thread: one (pure).
class MessageDecoder {
public:
    /// What a message's payload may have at most until the array's size is known.
    static constexpr std::size_t kDefaultMaximumPayload = 8192;

    struct Counters {
        std::uint64_t messages = 0;
        std::uint64_t messageBytes = 0;
        std::uint64_t droppedBytes = 0;
        std::uint64_t badChecksums = 0;
        std::uint64_t badSizes = 0; ///< headers whose size is above the maximum

        bool operator==(const Counters&) const = default;
    };

    /// Whether the bytes of an incomplete message may still follow.
    enum class Rest { mayCome, willNotCome };

    /// Headers with a larger size are taken for noise. bytes: 0 .. 65535.
    void setMaximumPayload(std::size_t bytes) { m_maximumPayload = bytes; }

    /// Appends bytes as they were read. Invalidates the messages returned before.
    void feed(std::span<const std::uint8_t> bytes);

    /// The next message; false when there is none (yet). With willNotCome (the line went silent) an
    /// incomplete message counts as damaged and is searched for others, and nothing stays pending.
    [[nodiscard]] bool next(Message& message, Rest rest = Rest::mayCome);

    [[nodiscard]] const Counters& counters() const { return m_counters; }
    [[nodiscard]] std::size_t pendingBytes() const { return m_buffer.size() - m_begin; }

private:
    void drop(std::size_t bytes);

    std::vector<std::uint8_t> m_buffer;
    std::size_t m_begin = 0; ///< of what was not given out or dropped
    std::size_t m_maximumPayload = kDefaultMaximumPayload;
    Counters m_counters;
};

} // namespace teleta::wts
