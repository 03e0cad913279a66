// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/sampled_output.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

using namespace teleta::pattern;
using teleta::core::ErrorKind;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

unsigned long value(const std::string& bytes, std::size_t offset, int count) {
    unsigned long sum = 0;
    for (int i = count - 1; i >= 0; --i)
        sum = sum * 256 + static_cast<unsigned char>(bytes[offset + static_cast<std::size_t>(i)]);
    return sum;
}

} // namespace

TEST(SampledOutput, countsTheSamplesThatLieInThePattern) {
    EXPECT_EQ(samplesOf(2.0, 200.0), 400U);
    EXPECT_EQ(samplesOf(0.3, 10.0), 3U); // 0.3 * 10 is 3 in doubles, 0.2999... in the numbers themselves
    EXPECT_EQ(samplesOf(0.31, 10.0), 4U);
    EXPECT_EQ(samplesOf(1e-9, 1.0), 1U);
    EXPECT_EQ(samplesOf(0.0, 100.0), 0U);
    EXPECT_EQ(samplesOf(-1.0, 100.0), 0U);
    EXPECT_EQ(samplesOf(std::nan(""), 100.0), 0U);
    EXPECT_EQ(samplesOf(1.0, 0.0), 0U);
}

TEST(SampledOutput, refusesRatesThatAreOutOfRangeOrThatAWavFileCannotHave) {
    const TemporaryFolder folder;
    const Pattern& pattern = *findBuiltIn("shape.F.static");
    for (const double rate_Hz : {0.0, -1.0, 1e9, std::nan("")}) {
        EXPECT_EQ(writeCsv(pattern, folder.path("a.csv"), {rate_Hz, {}}).error().kind, ErrorKind::refused);
        EXPECT_EQ(writeWav(pattern, folder.path("a.wav"), {rate_Hz, {}}).error().kind, ErrorKind::refused);
    }
    EXPECT_EQ(writeWav(pattern, folder.path("a.wav"), {0.5, {}}).error().kind, ErrorKind::refused);
    MotorProfiles none{};
    EXPECT_EQ(writeCsv(pattern, folder.path("a.csv"), {100.0, none}).error().kind, ErrorKind::refused);
    EXPECT_EQ(folder.entries(), 0U);
}

TEST(SampledOutput, predictedValuesAreBehindTheCommandedOnes) {
    const TemporaryFolder folder;
    const std::string path = folder.path("a.wav");
    ASSERT_TRUE(writeWav(*findBuiltIn("shape.F.static"), path, {1000.0, assumedMotors()}));
    const std::string wav = readAll(path);
    EXPECT_EQ(value(wav, 68, 2), 0U); // the motors stand at 0 s
    // One rise time, 55 ms, after the start: 90 % of the speed at full drive; a speed in proportion to the
    // drive, started at a third of it, is an intensity of (0.9 - 1/3) / (2/3).
    EXPECT_NEAR(static_cast<double>(value(wav, 68 + 55 * 12, 2)) / 32767.0, 0.85, 0.005);
}

TEST(SampledOutput, wavHasTheHeaderOfTheFormatAndSixChannels) {
    const TemporaryFolder folder;
    const std::string path = folder.path("ramp.wav");
    ASSERT_TRUE(savePattern(*findBuiltIn("shape.E.dynamic"), path));
    const std::string wav = readAll(path);
    ASSERT_EQ(wav.size(), 68U + 16000U * 12U);
    EXPECT_EQ(wav.substr(0, 4), "RIFF");
    EXPECT_EQ(value(wav, 4, 4), wav.size() - 8);
    EXPECT_EQ(wav.substr(8, 8), "WAVEfmt ");
    EXPECT_EQ(value(wav, 16, 4), 40U);
    EXPECT_EQ(value(wav, 20, 2), 0xFFFEU);
    EXPECT_EQ(value(wav, 22, 2), 6U);
    EXPECT_EQ(value(wav, 24, 4), 8000U);
    EXPECT_EQ(value(wav, 28, 4), 96000U);
    EXPECT_EQ(value(wav, 32, 2), 12U);
    EXPECT_EQ(value(wav, 34, 2), 16U);
    const std::string pcm("\x01\x00\x00\x00\x00\x00\x10\x00\x80\x00\x00\xAA\x00\x38\x9B\x71", 16);
    EXPECT_EQ(wav.substr(44, 16), pcm);
    EXPECT_EQ(wav.substr(60, 4), "data");
    EXPECT_EQ(value(wav, 64, 4), 16000U * 12U);
    EXPECT_EQ(value(wav, 68, 2), 32767U);                 // tactor 1 at 0 s
    EXPECT_EQ(value(wav, 68 + 8000 * 12, 2), 16384U);     // 32767 / 2, rounded
    EXPECT_EQ(value(wav, 68 + 8000 * 12 + 6, 2), 16384U); // tactor 4
    EXPECT_EQ(value(wav, 68 + 8000 * 12 + 2, 4), 0U);     // tactors 2 and 3
}

// Sample k of a constant intensity a is 32767 a sin(2 pi f k / rate).
TEST(SampledOutput, aCarrierIsASineOfTheIntensities) {
    const TemporaryFolder folder;
    const std::string path = folder.path("a.wav");
    Pattern pattern;
    pattern.duration_s = 0.5;
    pattern.tracks[1] = {{0.0, 0.8}, {0.5, 0.8}};
    ASSERT_TRUE(writeWav(pattern, path, {8000.0, {}, 250.0}));
    const std::string wav = readAll(path);
    ASSERT_EQ(wav.size(), 68U + 4000U * 12U);
    for (std::size_t k = 0; k < 4000; ++k) {
        const double expected = 32767.0 * 0.8 * std::sin(2.0 * std::acos(-1.0) * 250.0 * k / 8000.0);
        EXPECT_NEAR(static_cast<std::int16_t>(value(wav, 68 + 12 * k + 2, 2)), expected, 0.51) << k;
        EXPECT_EQ(value(wav, 68 + 12 * k, 2), 0U);
    }
    for (const double carrier_Hz : {0.0, -1.0, 4000.0, std::nan("")})
        EXPECT_EQ(writeWav(pattern, path, {8000.0, {}, carrier_Hz}).error().kind, ErrorKind::refused);
}
