// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_codec.h"

#include <algorithm>
#include <array>

namespace teleta::wts {

namespace {

constexpr std::uint16_t kPolynomial = 0x1021;
constexpr std::size_t kMatrixInfoBytes = 10;

constexpr std::array<std::uint16_t, 256> makeTable() {
    std::array<std::uint16_t, 256> table{};
    for (unsigned i = 0; i < table.size(); ++i) {
        unsigned remainder = i << 8;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder & 0x8000U) != 0 ? (remainder << 1) ^ kPolynomial : remainder << 1;
        table[i] = static_cast<std::uint16_t>(remainder);
    }
    return table;
}

constexpr std::array<std::uint16_t, 256> kTable = makeTable();

std::uint16_t readU16(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::uint16_t>(bytes[offset] | bytes[offset + 1] << 8);
}

std::uint32_t readU32(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return readU16(bytes, offset) | static_cast<std::uint32_t>(readU16(bytes, offset + 2)) << 16;
}

void appendU16(std::vector<std::uint8_t>& bytes, std::uint16_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

} // namespace

std::uint16_t checksum(std::span<const std::uint8_t> bytes) {
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t byte : bytes)
        crc = static_cast<std::uint16_t>(kTable[(crc ^ byte) & 0xFF] ^ (crc >> 8));
    return crc;
}

std::vector<std::uint8_t> encodeRequest(Command command, std::span<const std::uint8_t> params) {
    std::vector<std::uint8_t> bytes(kPreambleBytes, kPreambleByte);
    bytes.reserve(kHeaderBytes + params.size() + kChecksumBytes);
    bytes.push_back(static_cast<std::uint8_t>(command));
    appendU16(bytes, static_cast<std::uint16_t>(params.size()));
    bytes.insert(bytes.end(), params.begin(), params.end());
    appendU16(bytes, checksum(bytes));
    return bytes;
}

std::vector<std::uint8_t> encodeStartFrames(bool runLength, std::uint16_t delay_ms) {
    std::vector<std::uint8_t> params{runLength ? kRunLengthFlag : std::uint8_t{0}};
    appendU16(params, delay_ms);
    return encodeRequest(Command::startFrames, params);
}

std::optional<Answer> readAnswer(const Message& message) {
    if (message.payload.size() < 2)
        return std::nullopt;
    return Answer{static_cast<Status>(readU16(message.payload, 0)), message.payload.subspan(2)};
}

std::optional<MatrixInfo> readMatrixInfo(std::span<const std::uint8_t> params) {
    if (params.size() != kMatrixInfoBytes)
        return std::nullopt;
    return MatrixInfo{readU16(params, 0), readU16(params, 2), readU16(params, 4), readU16(params, 6),
                      readU16(params, 8)};
}

tl::expected<std::uint32_t, FrameFault> readFrame(std::span<const std::uint8_t> payload,
                                                  std::span<float> cells) {
    if (payload.size() < kFrameHeaderBytes)
        return tl::unexpected(FrameFault::tooShort);
    const std::uint32_t timestamp = readU32(payload, 0);
    const bool runLength = (payload[4] & kRunLengthFlag) != 0;
    const std::span<const std::uint8_t> words = payload.subspan(kFrameHeaderBytes);
    if (words.size() % 2 != 0)
        return tl::unexpected(FrameFault::oddSize);

    std::size_t filled = 0;
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const std::uint16_t word = readU16(words, i);
        const std::size_t count = runLength ? word >> 12 : 1;
        if (count == 0)
            return tl::unexpected(FrameFault::emptyRun);
        if (count > cells.size() - filled)
            return tl::unexpected(FrameFault::tooManyCells);
        const auto value = static_cast<float>(runLength ? word & 0x0FFF : word);
        std::ranges::fill(cells.subspan(filled, count), value);
        filled += count;
    }
    if (filled < cells.size())
        return tl::unexpected(FrameFault::tooFewCells);
    return timestamp;
}

} // namespace teleta::wts
