// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/wav_writer.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

using namespace teleta;
using core::WavWriter;

TEST(WavWriter, writesOneChannelAsPlainPcm) {
    const test::TemporaryFolder folder;
    auto file = WavWriter::create(folder.path("a.wav"), 1, 48'000, 3);
    ASSERT_TRUE(file);
    for (const double value : {1.0, -7.0, 0.0})
        file->write({&value, 1});
    ASSERT_TRUE(file->finish());
    const std::string bytes = test::readAll(folder.path("a.wav"));
    ASSERT_EQ(bytes.size(), 50U);
    EXPECT_EQ(bytes.substr(0, 4), "RIFF");
    EXPECT_EQ(bytes[4], 42) << "bytes that follow";
    EXPECT_EQ(bytes.substr(20, 4), std::string("\1\0\1\0", 4)) << "PCM of one channel";
    EXPECT_EQ(bytes.substr(36, 8), std::string("data\6\0\0\0", 8));
    EXPECT_EQ(bytes.substr(44), std::string("\xFF\x7F\x01\x80\0\0", 6)) << "clipped to full scale";
}

TEST(WavWriter, writesSeveralChannelsInTheExtensibleFormat) {
    const test::TemporaryFolder folder;
    auto file = WavWriter::create(folder.path("a.wav"), 6, 1000, 1);
    ASSERT_TRUE(file);
    file->write(std::array{0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
    ASSERT_TRUE(file->finish());
    const std::string bytes = test::readAll(folder.path("a.wav"));
    ASSERT_EQ(bytes.size(), 80U);
    EXPECT_EQ(bytes.substr(20, 4), std::string("\xFE\xFF\6\0", 4));
    EXPECT_EQ(bytes.substr(78), "\xFF\x7F");
}

TEST(WavWriter, holdsFourGibibytes) {
    EXPECT_EQ(WavWriter::mostFrames(1), (0xFFFF'FFFFULL - 44) / 2);
    EXPECT_EQ(WavWriter::mostFrames(6), (0xFFFF'FFFFULL - 68) / 12);
}
