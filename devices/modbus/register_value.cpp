// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/register_value.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace teleta::modbus {

namespace {

struct Range {
    double low;
    double high;
};

template <typename T>
constexpr Range rangeOfType() {
    return {static_cast<double>(std::numeric_limits<T>::lowest()),
            static_cast<double>(std::numeric_limits<T>::max())};
}

constexpr Range rangeOf(RegisterType type) {
    switch (type) {
    case RegisterType::int16:
        return rangeOfType<std::int16_t>();
    case RegisterType::uint16:
        return rangeOfType<std::uint16_t>();
    case RegisterType::int32:
        return rangeOfType<std::int32_t>();
    case RegisterType::float32:
        return rangeOfType<float>();
    }
    return {0.0, 0.0};
}

RegisterWords split(std::uint32_t bits, WordOrder order) {
    const auto high = static_cast<std::uint16_t>(bits >> 16U);
    const auto low = static_cast<std::uint16_t>(bits & 0xFFFFU);
    return order == WordOrder::highFirst ? RegisterWords{high, low} : RegisterWords{low, high};
}

std::uint32_t join(std::span<const std::uint16_t> words, WordOrder order) {
    const std::uint32_t first = words[0];
    const std::uint32_t second = words[1];
    return order == WordOrder::highFirst ? (first << 16U) | second : (second << 16U) | first;
}

} // namespace

RegisterWords encode(const RegisterFormat& format, double value) {
    const Range range = rangeOf(format.type);
    const double raw = ((std::isnan(value) ? 0.0 : value) - format.offset) / format.scale;
    const double fitting = std::clamp(raw, range.low, range.high);
    switch (format.type) {
    case RegisterType::int16:
        return {static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(fitting))), 0};
    case RegisterType::uint16:
        return {static_cast<std::uint16_t>(std::lround(fitting)), 0};
    case RegisterType::int32:
        return split(static_cast<std::uint32_t>(std::llround(fitting)), format.order);
    case RegisterType::float32:
        return split(std::bit_cast<std::uint32_t>(static_cast<float>(fitting)), format.order);
    }
    return {};
}

double decode(const RegisterFormat& format, std::span<const std::uint16_t> words) {
    double raw = 0.0;
    switch (format.type) {
    case RegisterType::int16:
        raw = static_cast<std::int16_t>(words[0]);
        break;
    case RegisterType::uint16:
        raw = words[0];
        break;
    case RegisterType::int32:
        raw = static_cast<std::int32_t>(join(words, format.order));
        break;
    case RegisterType::float32:
        raw = static_cast<double>(std::bit_cast<float>(join(words, format.order)));
        break;
    }
    return format.scale * raw + format.offset;
}

bool representable(const RegisterFormat& format, double value) {
    const Range range = rangeOf(format.type);
    const double raw = std::round((value - format.offset) / format.scale);
    return raw >= range.low && raw <= range.high;
}

} // namespace teleta::modbus
