// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace teleta::modbus {

/// What a number in registers is. Registers are of 16 bits; the others take two.
enum class RegisterType { int16, uint16, int32, float32 };

/// Which register of two comes first. Bytes within a register are in the order of the protocol.
enum class WordOrder {
    highFirst, ///< as most servers have it
    lowFirst,  ///< "word swapped"
};

[[nodiscard]] constexpr std::size_t registersOf(RegisterType type) {
    return type == RegisterType::int32 || type == RegisterType::float32 ? 2 : 1;
}

/// How a quantity is written in registers:
///   value = scale * raw + offset
/// scale: finite, not 0; value per raw count. offset: finite, in the unit of the value.
struct RegisterFormat {
    RegisterType type = RegisterType::uint16;
    WordOrder order = WordOrder::highFirst;
    double scale = 1.0;
    double offset = 0.0;
};

/// The registers of one value; the second is used with types of two registers.
using RegisterWords = std::array<std::uint16_t, 2>;

/// Nearest raw number to (value - offset) / scale. What is out of the range of the type, infinities too,
/// becomes the end of the range; NaN is written as the value 0. Thread: any (pure).
[[nodiscard]] RegisterWords encode(const RegisterFormat& format, double value);

/// The value in registers; NaN when a float32 holds NaN. words: registersOf(format.type) of them. Thread: any
/// (pure).
[[nodiscard]] double decode(const RegisterFormat& format, std::span<const std::uint16_t> words);

/// True when the nearest raw number is within the range of the type. NaN: false. Thread: any (pure).
[[nodiscard]] bool representable(const RegisterFormat& format, double value);

} // namespace teleta::modbus
