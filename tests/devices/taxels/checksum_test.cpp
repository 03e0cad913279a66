// SPDX-License-Identifier: GPL-3.0-or-later
// Check values of "123456789" as the catalogue of parametrised CRC algorithms has them; vectors of Weiss
// arrays from their manual.
#include "devices/taxels/frames/checksum.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace teleta::taxels {
namespace {

std::uint32_t of(std::vector<std::uint8_t> bytes, ChecksumType type) {
    return checksumOf(bytes, type, usualInit(type), usualXor(type));
}

std::uint32_t ofDigits(ChecksumType type) {
    constexpr std::string_view kDigits = "123456789";
    return of({kDigits.begin(), kDigits.end()}, type);
}

TEST(Checksum, hasTheKnownCheckValues) {
    EXPECT_EQ(ofDigits(ChecksumType::crc8), 0xF4U);
    EXPECT_EQ(ofDigits(ChecksumType::crc16Ccitt), 0x29B1U);
    EXPECT_EQ(ofDigits(ChecksumType::crc16Modbus), 0x4B37U);
    EXPECT_EQ(ofDigits(ChecksumType::crc32), 0xCBF43926U);
    EXPECT_EQ(ofDigits(ChecksumType::sum8), 0xDDU); // 9 * 0x30 + 45 = 477
    EXPECT_EQ(ofDigits(ChecksumType::xor8), 0x31U); // the digits 1 to 8 leave 8, and 9 ^ 8 = 1, of 0x30
}

TEST(Checksum, isThatOfWeissArrays) {
    EXPECT_EQ(of({0xAA, 0xAA, 0xAA, 0x01, 0x02, 0x00, 0x12, 0x34}, ChecksumType::crc16Wts), 0x666DU);
    EXPECT_EQ(of({0xAA, 0xAA, 0xAA, 0x01, 0x00, 0x00}, ChecksumType::crc16Wts), 0x10E8U);
}

TEST(Checksum, takesAnotherBeginAndEnd) {
    const std::vector<std::uint8_t> bytes{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(checksumOf(bytes, ChecksumType::crc16Ccitt, 0x0000, 0x0000), 0x31C3U); // XMODEM
    EXPECT_EQ(checksumOf(bytes, ChecksumType::crc16Ccitt, 0xFFFF, 0xFFFF), 0xD64EU); // GENIBUS
    EXPECT_EQ(checksumOf(bytes, ChecksumType::sum8, 0, 0xFF), 0x22U);
    EXPECT_EQ(checksumOf({}, ChecksumType::crc32, 0xFFFF'FFFF, 0xFFFF'FFFF), 0U);
}

} // namespace
} // namespace teleta::taxels
