// SPDX-License-Identifier: GPL-3.0-or-later
// Every byte string here is worked out by hand from the tables of devices/bracelet/README.md.
#include "devices/bracelet/bracelet_reports.h"
#include "devices/bracelet/hid_bracelet.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace teleta::bracelet;
using teleta::core::Drive;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes frame(std::uint16_t sequence, const Drive& drive, std::uint16_t timeout_ms) {
    const auto bytes = encodeFrame(sequence, drive, timeout_ms);
    return {bytes.begin(), bytes.end()};
}

/// Layout 1, model 0x0102, firmware 3.4, serial "TB-0042", 4000, 500 Hz, 2000 ms.
Bytes identity() {
    return {0x03, 0x01, 0x02, 0x01, 0x03, 0x04, 'T', 'B',  '-',  '0',  '0',  '4',  '2',  0,   0,
            0,    0,    0,    0,    0,    0,    0,   0x06, 0xA0, 0x0F, 0xF4, 0x01, 0xD0, 0x07};
}

std::string textOf(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(TELETA_SOURCE_DIR "/" + path).rdbuf();
    return text.str();
}

} // namespace

TEST(BraceletReports, areThoseOfTheReadme) {
    const std::string readme = textOf("devices/bracelet/README.md");
    std::string bytes;
    for (const std::uint8_t byte : frame(7, {0x001, 0x002, 0xFFF, 0x800, 0xABC, 0x123}, 100)) {
        char text[4];
        std::snprintf(text, sizeof text, "%02X ", byte);
        bytes += text;
    }
    bytes.pop_back();
    EXPECT_NE(readme.find('`' + bytes + '`'), std::string::npos) << bytes;
}

TEST(BraceletReports, belongToTheDeviceThatTheUdevRuleOpens) {
    const HidBraceletConfig config;
    char ids[64];
    std::snprintf(ids, sizeof ids, "ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\"", config.vendorId,
                  config.productId);
    EXPECT_NE(textOf("packaging/udev/70-teleta-bracelet.rules").find(ids), std::string::npos) << ids;
}

TEST(BraceletReports, writesTheFrameOfTheReadme) {
    EXPECT_EQ(frame(7, {0x001, 0x002, 0xFFF, 0x800, 0xABC, 0x123}, 100),
              (Bytes{0x01, 0x07, 0x00, 0x01, 0x20, 0x00, 0xFF, 0x0F, 0x80, 0xBC, 0x3A, 0x12, 0x64, 0x00}));
}

TEST(BraceletReports, writesFramesThatAreAllOffOrAllOn) {
    EXPECT_EQ(frame(0, {}, 1), (Bytes{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0}));
    const Bytes full{0x01, 0xFE, 0xCA, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x10, 0x27};
    EXPECT_EQ(frame(0xCAFE, {4095, 4095, 4095, 4095, 4095, 4095}, 10'000), full);
    EXPECT_EQ(frame(0xCAFE, {4096, 65535, 4095, 5000, 40'000, 4095}, 10'000), full)
        << "no intensity spills into its neighbour";
}

TEST(BraceletReports, readsAReport) {
    const Bytes bytes{0x02, 0x34, 0x12, 0x01, 0x88, 0x13, 0xFA, 0x00};
    const auto report = decodeReport(bytes);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->sequence, 0x1234);
    EXPECT_TRUE(report->driving);
    EXPECT_FALSE(report->timedOut || report->tooHot || report->supplyLow || report->frameRefused);
    EXPECT_DOUBLE_EQ(report->supply_V, 5.0);
    EXPECT_DOUBLE_EQ(report->temperature_degC, 25.0);
}

TEST(BraceletReports, readsEachBitOfTheStatusAndTemperaturesBelowZero) {
    const auto withStatus = [](std::uint8_t status) {
        return *decodeReport(Bytes{0x02, 0, 0, status, 0, 0, 0xFF, 0xFF});
    };
    EXPECT_TRUE(withStatus(0x02).timedOut);
    EXPECT_TRUE(withStatus(0x04).tooHot);
    EXPECT_TRUE(withStatus(0x08).supplyLow);
    EXPECT_TRUE(withStatus(0x10).frameRefused);
    const auto unknown = withStatus(0xE0);
    EXPECT_FALSE(unknown.driving || unknown.timedOut || unknown.tooHot || unknown.supplyLow ||
                 unknown.frameRefused);
    EXPECT_DOUBLE_EQ(unknown.temperature_degC, -0.1);
}

TEST(BraceletReports, ignoresThePaddingOfAReportButNotAMissingByte) {
    Bytes bytes{0x02, 0x34, 0x12, 0x00, 0x88, 0x13, 0xFA, 0x00, 0xAA, 0xBB};
    EXPECT_TRUE(decodeReport(bytes));
    bytes.resize(7);
    EXPECT_FALSE(decodeReport(bytes));
    EXPECT_FALSE(decodeReport({}));
    EXPECT_FALSE(decodeReport(Bytes{0x01, 0, 0, 0, 0, 0, 0, 0})) << "another report";
}

TEST(BraceletReports, readsWhoTheBoardIs) {
    const auto board = decodeIdentity(identity());
    ASSERT_TRUE(board);
    EXPECT_EQ(*board, (BoardIdentity{0x0102, 3, 4, "TB-0042", 4000, 500, 2000}));
}

TEST(BraceletReports, readsASerialNumberThatFillsItsField) {
    Bytes bytes = identity();
    for (std::size_t i = 6; i < 22; ++i)
        bytes[i] = 'x';
    const auto board = decodeIdentity(bytes);
    ASSERT_TRUE(board);
    EXPECT_EQ(board->serial, "xxxxxxxxxxxxxxxx");
}

TEST(BraceletReports, refusesAnIdentityThatMakesNoSense) {
    const auto with = [](std::size_t at, std::uint8_t byte) {
        Bytes bytes = identity();
        bytes[at] = byte;
        return bytes;
    };
    EXPECT_FALSE(decodeIdentity(with(0, 2))) << "another report";
    EXPECT_FALSE(decodeIdentity(with(1, 2))) << "another layout";
    EXPECT_FALSE(decodeIdentity(with(6, 0))) << "no serial number";
    EXPECT_FALSE(decodeIdentity(with(7, ' '))) << "not printable";
    EXPECT_FALSE(decodeIdentity(with(7, 0xC3))) << "not ASCII";
    EXPECT_FALSE(decodeIdentity(with(22, 8))) << "eight tactors";
    for (const std::size_t at : {23U, 25U, 27U}) {
        Bytes bytes = identity();
        bytes[at] = bytes[at + 1] = 0;
        EXPECT_FALSE(decodeIdentity(bytes)) << "a limit of 0 at " << at;
    }
    for (std::size_t size = 0; size < kIdentitySize; ++size) {
        Bytes bytes = identity();
        bytes.resize(size);
        EXPECT_FALSE(decodeIdentity(bytes)) << size;
    }
}

TEST(BraceletReports, survivesRandomBytes) {
    std::mt19937 random(1);
    for (int i = 0; i < 100'000; ++i) {
        Bytes bytes(random() % 40);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        if (!bytes.empty() && i % 2 == 0)
            bytes[0] = i % 4 == 0 ? kReportId : kIdentityId;
        const auto report = decodeReport(bytes);
        EXPECT_EQ(report.has_value(), bytes.size() >= kReportSize && bytes[0] == kReportId);
        if (report) {
            EXPECT_GE(report->temperature_degC, -3276.8);
            EXPECT_LE(report->supply_V, 65.535);
        }
        if (const auto board = decodeIdentity(bytes)) {
            EXPECT_GT(board->highestDrive, 0);
        }
    }
}
