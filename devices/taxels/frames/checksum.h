// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::taxels {

/// Ways to check a frame, in the order of their names in a file.
enum class ChecksumType {
    none,
    sum8,        ///< sum of the bytes, modulo 256
    xor8,        ///< exclusive or of the bytes
    crc8,        ///< polynomial 07, highest bit first
    crc16Ccitt,  ///< polynomial 1021, highest bit first
    crc16Modbus, ///< polynomial 8005, lowest bit first
    crc32,       ///< polynomial 04C11DB7, lowest bit first, as of Ethernet and ZIP
    crc16Wts,    ///< of Weiss arrays: the table of polynomial 1021, shifted to the right
};

/// Bytes of a checksum in a frame; none: 0.
[[nodiscard]] std::size_t sizeOf(ChecksumType type);
/// What its register starts with, and what its result is combined with by exclusive or, when nothing else is
/// said.
[[nodiscard]] std::uint32_t usualInit(ChecksumType type);
[[nodiscard]] std::uint32_t usualXor(ChecksumType type);

/// The checksum of these bytes; none: 0. Check values of "123456789" with the usual init and xor: crc8 F4,
/// crc16Ccitt 29B1, crc16Modbus 4B37, crc32 CBF43926. Thread: any (pure).
[[nodiscard]] std::uint32_t checksumOf(std::span<const std::uint8_t> bytes, ChecksumType type,
                                       std::uint32_t init, std::uint32_t xorOut);

} // namespace teleta::taxels
