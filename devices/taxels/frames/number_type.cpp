// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/number_type.h"

#include <bit>
#include <limits>

namespace teleta::taxels {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

std::uint64_t bitsOf(std::span<const std::uint8_t> bytes, std::size_t size, ByteOrder order) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
        bits = bits << 8 | bytes[order == ByteOrder::big ? i : size - 1 - i];
    return bits;
}

/// Two's complement of so many bytes.
double signedValue(std::uint64_t bits, std::size_t size) {
    const std::size_t unused = 64 - 8 * size;
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

} // namespace

std::size_t sizeOf(NumberType type) {
    switch (type) {
    case NumberType::int8:
    case NumberType::uint8:
        return 1;
    case NumberType::int16:
    case NumberType::uint16:
        return 2;
    case NumberType::int24:
    case NumberType::uint24:
        return 3;
    case NumberType::float64:
        return 8;
    case NumberType::int32:
    case NumberType::uint32:
    case NumberType::float32:
        break;
    }
    return 4;
}

double readNumber(std::span<const std::uint8_t> bytes, NumberType type, ByteOrder order) {
    const std::size_t size = sizeOf(type);
    const std::uint64_t bits = bitsOf(bytes, size, order);
    // No signalling NaN is computed with: it would raise the floating-point exception "invalid".
    if (type == NumberType::float32) {
        constexpr std::uint32_t kNotFinite = 0x7F80'0000U;
        const auto narrow = static_cast<std::uint32_t>(bits);
        return (narrow & kNotFinite) == kNotFinite ? kNothing
                                                   : static_cast<double>(std::bit_cast<float>(narrow));
    }
    if (type == NumberType::float64) {
        constexpr std::uint64_t kNotFinite = 0x7FF0'0000'0000'0000U;
        return (bits & kNotFinite) == kNotFinite ? kNothing : std::bit_cast<double>(bits);
    }
    return isUnsigned(type) ? static_cast<double>(bits) : signedValue(bits, size);
}

std::uint32_t readBits(std::span<const std::uint8_t> bytes, std::size_t size, ByteOrder order) {
    return static_cast<std::uint32_t>(bitsOf(bytes, size, order));
}

} // namespace teleta::taxels
