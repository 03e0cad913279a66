// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/checksum.h"

#include <array>

namespace teleta::taxels {

namespace {

using Table = std::array<std::uint32_t, 256>;

/// Of a polynomial whose highest bit comes first; bits: 8 or 16.
constexpr Table tableHighFirst(std::uint32_t polynomial, int bits) {
    Table table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i << (bits - 8);
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> (bits - 1)) & 1U ? value << 1U ^ polynomial : value << 1U;
        table[i] = value & (0xFFFF'FFFFU >> (32 - bits));
    }
    return table;
}

/// Of a polynomial whose lowest bit comes first, in mirrored form.
constexpr Table tableLowFirst(std::uint32_t polynomial) {
    Table table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit)
            value = value & 1U ? value >> 1U ^ polynomial : value >> 1U;
        table[i] = value;
    }
    return table;
}

constexpr Table kCrc8 = tableHighFirst(0x07, 8);
constexpr Table kCcitt = tableHighFirst(0x1021, 16);
constexpr Table kModbus = tableLowFirst(0xA001);
constexpr Table kCrc32 = tableLowFirst(0xEDB8'8320);

std::uint32_t next(std::uint32_t crc, std::uint8_t byte, ChecksumType type) {
    switch (type) {
    case ChecksumType::none:
        return 0;
    case ChecksumType::sum8:
        return (crc + byte) & 0xFFU;
    case ChecksumType::xor8:
        return (crc ^ byte) & 0xFFU;
    case ChecksumType::crc8:
        return kCrc8[(crc ^ byte) & 0xFFU];
    case ChecksumType::crc16Ccitt:
        return (kCcitt[(crc >> 8U ^ byte) & 0xFFU] ^ crc << 8U) & 0xFFFFU;
    case ChecksumType::crc16Modbus:
        return kModbus[(crc ^ byte) & 0xFFU] ^ crc >> 8U;
    case ChecksumType::crc32:
        return kCrc32[(crc ^ byte) & 0xFFU] ^ crc >> 8U;
    case ChecksumType::crc16Wts:
        break;
    }
    return kCcitt[(crc ^ byte) & 0xFFU] ^ crc >> 8U;
}

} // namespace

std::size_t sizeOf(ChecksumType type) {
    switch (type) {
    case ChecksumType::none:
        return 0;
    case ChecksumType::sum8:
    case ChecksumType::xor8:
    case ChecksumType::crc8:
        return 1;
    case ChecksumType::crc32:
        return 4;
    case ChecksumType::crc16Ccitt:
    case ChecksumType::crc16Modbus:
    case ChecksumType::crc16Wts:
        break;
    }
    return 2;
}

std::uint32_t usualInit(ChecksumType type) {
    if (type == ChecksumType::crc32)
        return 0xFFFF'FFFFU;
    return sizeOf(type) == 2 ? 0xFFFFU : 0U;
}

std::uint32_t usualXor(ChecksumType type) {
    return type == ChecksumType::crc32 ? 0xFFFF'FFFFU : 0U;
}

std::uint32_t checksumOf(std::span<const std::uint8_t> bytes, ChecksumType type, std::uint32_t init,
                         std::uint32_t xorOut) {
    std::uint32_t crc = init;
    for (const std::uint8_t byte : bytes)
        crc = next(crc, byte, type);
    const std::size_t unused = 32 - 8 * sizeOf(type);
    return unused < 32 ? (crc ^ xorOut) & (0xFFFF'FFFFU >> unused) : 0;
}

} // namespace teleta::taxels
