// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::taxels {

/// How a number stands in the bytes of a frame.
enum class NumberType { int8, uint8, int16, uint16, int24, uint24, int32, uint32, float32, float64 };

enum class ByteOrder { little, big };

/// Bytes of a number: 1 .. 8.
[[nodiscard]] std::size_t sizeOf(NumberType type);

[[nodiscard]] constexpr bool isFloat(NumberType type) {
    return type == NumberType::float32 || type == NumberType::float64;
}
/// A whole number that is never negative.
[[nodiscard]] constexpr bool isUnsigned(NumberType type) {
    return type == NumberType::uint8 || type == NumberType::uint16 || type == NumberType::uint24 ||
           type == NumberType::uint32;
}

/// The number in the first sizeOf(type) bytes; NaN for a float that is not finite. Thread: any (pure).
[[nodiscard]] double readNumber(std::span<const std::uint8_t> bytes, NumberType type, ByteOrder order);

/// The bits of sizeOf(type) <= 4 bytes as a whole number.
[[nodiscard]] std::uint32_t readBits(std::span<const std::uint8_t> bytes, std::size_t size, ByteOrder order);

} // namespace teleta::taxels
