// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/register_value.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace teleta::modbus;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

RegisterFormat format(RegisterType type, double scale = 1.0, double offset = 0.0,
                      WordOrder order = WordOrder::highFirst) {
    return {.type = type, .order = order, .scale = scale, .offset = offset};
}

double roundTrip(const RegisterFormat& format, double value) {
    const RegisterWords words = encode(format, value);
    return decode(format, std::span(words).first(registersOf(format.type)));
}

} // namespace

TEST(RegisterValue, takesOneRegisterOrTwo) {
    EXPECT_EQ(registersOf(RegisterType::int16), 1U);
    EXPECT_EQ(registersOf(RegisterType::uint16), 1U);
    EXPECT_EQ(registersOf(RegisterType::int32), 2U);
    EXPECT_EQ(registersOf(RegisterType::float32), 2U);
}

// Two's complement and IEEE 754, written out by hand.
TEST(RegisterValue, hasTheBitsOfItsType) {
    EXPECT_EQ(encode(format(RegisterType::int16), -2.0)[0], 0xFFFE);
    EXPECT_EQ(encode(format(RegisterType::uint16), 40000.0)[0], 40000);
    EXPECT_EQ(encode(format(RegisterType::int32), -100000.0), (RegisterWords{0xFFFE, 0x7960}));
    EXPECT_EQ(encode(format(RegisterType::float32), 1.0), (RegisterWords{0x3F80, 0x0000}));
    EXPECT_EQ(encode(format(RegisterType::float32), 3.14159274101257324), (RegisterWords{0x4049, 0x0FDB}));
}

TEST(RegisterValue, swapsTheWordsOnDemand) {
    const auto swapped = [](RegisterType type) { return format(type, 1.0, 0.0, WordOrder::lowFirst); };
    EXPECT_EQ(encode(swapped(RegisterType::int32), -100000.0), (RegisterWords{0x7960, 0xFFFE}));
    EXPECT_EQ(encode(swapped(RegisterType::float32), -2.0), (RegisterWords{0x0000, 0xC000}));
    const std::array<std::uint16_t, 2> words = {0x7960, 0xFFFE};
    EXPECT_EQ(decode(swapped(RegisterType::int32), words), -100000.0);
}

TEST(RegisterValue, decodesWhatAServerSends) {
    const std::array<std::uint16_t, 2> words = {0xFFFE, 0x7960};
    EXPECT_EQ(decode(format(RegisterType::int16), words), -2.0);
    EXPECT_EQ(decode(format(RegisterType::uint16), words), 65534.0);
    EXPECT_EQ(decode(format(RegisterType::int32), words), -100000.0);
    const std::array<std::uint16_t, 2> half = {0x3F00, 0x0000};
    EXPECT_EQ(decode(format(RegisterType::float32), half), 0.5);
    const std::array<std::uint16_t, 2> notANumber = {0x7FC0, 0x0000};
    EXPECT_TRUE(std::isnan(decode(format(RegisterType::float32), notANumber)));
}

TEST(RegisterValue, appliesScaleAndOffset) {
    // 1 V is 2000 counts above 100 counts.
    const RegisterFormat volts = format(RegisterType::uint16, 1.0 / 2000.0, -0.05);
    EXPECT_EQ(encode(volts, 1.0)[0], 2100);
    EXPECT_EQ(encode(volts, 0.0)[0], 100);
    const std::array<std::uint16_t, 1> words = {2100};
    EXPECT_DOUBLE_EQ(decode(volts, words), 1.0);
    // A scale below zero turns the range round.
    const RegisterFormat turned = format(RegisterType::int16, -0.001);
    EXPECT_EQ(encode(turned, 1.5)[0], static_cast<std::uint16_t>(-1500));
    EXPECT_DOUBLE_EQ(roundTrip(turned, 1.5), 1.5);
}

TEST(RegisterValue, roundsToTheNearestCount) {
    const RegisterFormat counts = format(RegisterType::int16);
    EXPECT_EQ(roundTrip(counts, 2.4), 2.0);
    EXPECT_EQ(roundTrip(counts, 2.6), 3.0);
    EXPECT_EQ(roundTrip(counts, -2.6), -3.0);
}

TEST(RegisterValue, endsAtTheRangeOfItsType) {
    for (const double beyond : {1e30, kInfinity}) {
        EXPECT_EQ(roundTrip(format(RegisterType::int16), beyond), 32767.0);
        EXPECT_EQ(roundTrip(format(RegisterType::int16), -beyond), -32768.0);
        EXPECT_EQ(roundTrip(format(RegisterType::uint16), beyond), 65535.0);
        EXPECT_EQ(roundTrip(format(RegisterType::uint16), -beyond), 0.0);
        EXPECT_EQ(roundTrip(format(RegisterType::int32), beyond), 2147483647.0);
        EXPECT_EQ(roundTrip(format(RegisterType::int32), -beyond), -2147483648.0);
    }
    EXPECT_EQ(roundTrip(format(RegisterType::float32), kInfinity),
              static_cast<double>(std::numeric_limits<float>::max()));
    EXPECT_EQ(roundTrip(format(RegisterType::float32), -1e300),
              static_cast<double>(std::numeric_limits<float>::lowest()));
}

TEST(RegisterValue, writesNanAsTheValueZero) {
    EXPECT_EQ(encode(format(RegisterType::int16), kNan)[0], 0);
    EXPECT_EQ(encode(format(RegisterType::float32), kNan), (RegisterWords{0, 0}));
    // 0 V is 100 counts here: NaN must not become another voltage.
    EXPECT_EQ(encode(format(RegisterType::uint16, 0.001, -0.1), kNan)[0], 100);
}

TEST(RegisterValue, knowsWhatItCannotHold) {
    EXPECT_TRUE(representable(format(RegisterType::int16, 0.001), 32.767));
    EXPECT_FALSE(representable(format(RegisterType::int16, 0.001), 32.769));
    EXPECT_FALSE(representable(format(RegisterType::uint16), -1.0));
    EXPECT_FALSE(representable(format(RegisterType::float32), kNan));
}

TEST(RegisterValue, keepsEveryCountOfSixteenBits) {
    for (int raw = -32768; raw <= 32767; ++raw) {
        const double value = 0.1 * raw - 7.0;
        ASSERT_EQ(static_cast<std::int16_t>(encode(format(RegisterType::int16, 0.1, -7.0), value)[0]), raw);
    }
}
