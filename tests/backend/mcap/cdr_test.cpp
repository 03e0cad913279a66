// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/cdr_reader.h"
#include "backend/mcap/cdr_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using teleta::mcap::CdrReader;
using teleta::mcap::CdrWriter;

namespace {

using namespace std::string_literals;

/// By the rules of the specification, by hand: u8 7, u16 0x0102, string "ab", f64 1.0, sequence of u16 {3,
/// 4}.
const std::string kLittle = "\0\1\0\0"s
                            "\x07"s
                            "\0"s
                            "\x02\x01"s
                            "\3\0\0\0ab\0"s
                            "\0\0\0\0\0"s
                            "\0\0\0\0\0\0\xf0\x3f"s
                            "\2\0\0\0"s
                            "\3\0\4\0"s;
const std::string kBig = "\0\0\0\0"s
                         "\x07"s
                         "\0"s
                         "\x01\x02"s
                         "\0\0\0\3ab\0"s
                         "\0\0\0\0\0"s
                         "\x3f\xf0\0\0\0\0\0\0"s
                         "\0\0\0\2"s
                         "\0\3\0\4"s;

} // namespace

TEST(Cdr, fieldsAreAlignedToTheirSizeAfterTheFirstFourBytes) {
    std::string bytes;
    CdrWriter cdr(bytes);
    cdr.number(std::uint8_t{7});
    cdr.number(std::uint16_t{0x0102});
    cdr.text("ab");
    cdr.number(1.0);
    constexpr std::array<std::uint16_t, 2> kValues{3, 4};
    cdr.sequence(std::span<const std::uint16_t>(kValues));
    EXPECT_EQ(bytes, kLittle);
}

TEST(Cdr, aMessageBehindOthersIsAlignedByItself) {
    std::string bytes = "abc";
    CdrWriter cdr(bytes);
    cdr.number(std::uint8_t{1});
    cdr.number(std::uint32_t{2});
    EXPECT_EQ(bytes, "abc\0\1\0\0\1\0\0\0\2\0\0\0"s);
}

TEST(Cdr, bothByteOrdersAreRead) {
    for (const std::string& message : {kLittle, kBig}) {
        CdrReader cdr(message);
        EXPECT_EQ(cdr.number<std::uint8_t>(), 7);
        EXPECT_EQ(cdr.number<std::uint16_t>(), 0x0102);
        EXPECT_EQ(cdr.text(), "ab");
        EXPECT_EQ(cdr.number<double>(), 1.0);
        std::vector<std::uint16_t> values;
        cdr.sequence(values);
        EXPECT_EQ(values, (std::vector<std::uint16_t>{3, 4}));
        EXPECT_FALSE(cdr.failed());
        EXPECT_EQ(cdr.number<std::uint8_t>(), 0);
        EXPECT_TRUE(cdr.failed()) << "there is nothing more";
    }
}

TEST(Cdr, aCountBeyondTheMessageIsRefusedAndTakesNoMemory) {
    const std::string message = "\0\1\0\0\xff\xff\xff\xff\0\0\0\0"s;
    CdrReader cdr(message);
    std::vector<double> values;
    cdr.sequence(values);
    EXPECT_TRUE(cdr.failed());
    EXPECT_EQ(values.capacity(), 0U);
    CdrReader counted(message);
    EXPECT_EQ(counted.count(1), 0U);
    EXPECT_TRUE(counted.failed());
    CdrReader text(message);
    EXPECT_EQ(text.text(), "");
    EXPECT_TRUE(text.failed());
}

TEST(Cdr, sizesOfZeroAreNothing) {
    const std::string message = "\0\1\0\0\0\0\0\0\0\0\0\0"s;
    CdrReader cdr(message);
    EXPECT_EQ(cdr.text(), "");
    std::vector<float> values{1.0F};
    cdr.sequence(values);
    EXPECT_TRUE(values.empty());
    EXPECT_FALSE(cdr.failed());
}

TEST(Cdr, otherEncodingsAreRefused) {
    for (const std::string& head : {""s, "\0\2\0\0"s, "\0\7\0\0"s, "\1\1\0\0"s}) {
        CdrReader cdr(head + "\1\2\3\4"s);
        EXPECT_TRUE(cdr.failed());
        EXPECT_EQ(cdr.number<std::uint32_t>(), 0U);
    }
}
