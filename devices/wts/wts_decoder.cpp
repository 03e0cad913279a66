// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_decoder.h"

#include <algorithm>

namespace teleta::wts {

void MessageDecoder::feed(std::span<const std::uint8_t> bytes) {
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_begin));
    m_begin = 0;
    m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.end());
}

bool MessageDecoder::next(Message& message, Rest rest) {
    while (pendingBytes() > 0) {
        const std::span<const std::uint8_t> pending = std::span(m_buffer).subspan(m_begin);
        const auto otherByte =
            std::ranges::find_if(pending, [](std::uint8_t byte) { return byte != kPreambleByte; });
        const auto preamble = static_cast<std::size_t>(otherByte - pending.begin());
        if (preamble > kPreambleBytes) {
            // No command has the number AA: the last three of many preamble bytes are the preamble.
            drop(preamble - kPreambleBytes);
            continue;
        }
        const bool wholeHeader = pending.size() >= kHeaderBytes;
        if (preamble < kPreambleBytes && preamble < pending.size()) {
            const auto nextPreamble = std::find(otherByte, pending.end(), kPreambleByte);
            drop(static_cast<std::size_t>(nextPreamble - pending.begin()));
            continue;
        }
        const std::size_t payload = wholeHeader ? pending[4] | std::size_t{pending[5]} << 8 : 0;
        if (payload > m_maximumPayload) {
            ++m_counters.badSizes;
            drop(1);
            continue;
        }
        const std::size_t size = kHeaderBytes + payload + kChecksumBytes;
        if (!wholeHeader || pending.size() < size) {
            if (rest == Rest::mayCome)
                return false;
            drop(1);
            continue;
        }
        const std::size_t body = size - kChecksumBytes;
        const auto sent = static_cast<std::uint16_t>(pending[body] | pending[body + 1] << 8);
        if (checksum(pending.first(body)) != sent) {
            ++m_counters.badChecksums;
            drop(1);
            continue;
        }
        message = {pending[kPreambleBytes], pending.subspan(kHeaderBytes, payload)};
        ++m_counters.messages;
        m_counters.messageBytes += size;
        m_begin += size;
        return true;
    }
    return false;
}

void MessageDecoder::drop(std::size_t bytes) {
    m_begin += bytes;
    m_counters.droppedBytes += bytes;
}

} // namespace teleta::wts
