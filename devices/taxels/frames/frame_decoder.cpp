// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/frame_decoder.h"

#include "devices/taxels/frames/binary_decoder.h"
#include "devices/taxels/frames/line_decoder.h"

namespace teleta::taxels {

void FrameDecoder::feed(std::span<const std::uint8_t> bytes) {
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_begin));
    m_erased += m_begin;
    m_begin = 0;
    m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.end());
}

void FrameDecoder::drop(std::size_t bytes) {
    m_begin += bytes;
    m_counters.droppedBytes += bytes;
}

void FrameDecoder::take(std::size_t bytes, bool isOther) {
    ++(isOther ? m_counters.otherFrames : m_counters.frames);
    if (!isOther)
        m_problem = {};
    m_counters.frameBytes += bytes;
    m_frameBegin = m_erased + m_begin;
    m_frameSize = bytes;
    m_begin += bytes;
}

std::unique_ptr<FrameDecoder> makeDecoder(const FrameFormat& format, FrameDecoder::Framing framing) {
    if (const auto* binary = std::get_if<BinaryFormat>(&format))
        return std::make_unique<BinaryDecoder>(*binary, framing);
    if (const auto* csv = std::get_if<CsvFormat>(&format))
        return std::make_unique<LineDecoder>(*csv, framing);
    return std::make_unique<LineDecoder>(std::get<JsonFormat>(format), framing);
}

std::size_t valuesOf(const FrameFormat& format) {
    if (const auto* binary = std::get_if<BinaryFormat>(&format))
        return binary->values.count;
    if (const auto* csv = std::get_if<CsvFormat>(&format))
        return (csv->lastColumn - csv->firstColumn + 1) / csv->groupColumns * csv->perGroup;
    return std::get<JsonFormat>(format).count;
}

} // namespace teleta::taxels
