// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/input_file.h"
#include "devices/sound_bracelet/latency/sound_latency_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::sound {
namespace {

constexpr const char* kFile = "# left hand\n"
                              "kind = \"sound_bracelet\"\n"
                              "name = \"voice coils\"\n"
                              "device = \"pipewire:tactors\"\n"
                              "channels = [3, 4,   # fingers\n"
                              "            5, 6, 7, 8]\n";

/// Median 4.25 ms, spread 2 ms.
SoundLatency measured() {
    return {{0.00425, 0.0035, 0.0055, 0.0040, 0.0045}};
}

std::string kept(const std::string& text) {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("coils.toml", text);
    const auto done = keepLatency(path, measured());
    EXPECT_TRUE(done) << core::describe(done.error());
    return core::readFile(path).value_or("");
}

TEST(SoundLatency, medianAndSpreadAreThoseOfTheClicks) {
    EXPECT_DOUBLE_EQ(measured().median_s(), 0.00425);
    EXPECT_DOUBLE_EQ(measured().spread_s(), 0.002);
    EXPECT_EQ(latencyLines(measured()), "latency_ms = 4.25\nlatency_spread_ms = 2.00\n");
}

TEST(SoundLatencyFile, aFileWithoutALatencyGetsTwoLinesAtItsEnd) {
    EXPECT_EQ(kept(kFile), std::string(kFile) + "latency_ms = 4.25\nlatency_spread_ms = 2.00\n");
}

TEST(SoundLatencyFile, aLastLineWithoutAnEndIsEnded) {
    const std::string text = std::string(kFile) + "shared = true";
    EXPECT_EQ(kept(text), text + "\nlatency_ms = 4.25\nlatency_spread_ms = 2.00\n");
}

TEST(SoundLatencyFile, anOlderLatencyIsReplacedInItsPlaceAndCommentsStay) {
    EXPECT_EQ(
        kept("latency_spread_ms=1.5\n  latency_ms = 12 # with the accelerometer\n" + std::string(kFile)),
        "latency_spread_ms=2.00\n  latency_ms = 4.25 # with the accelerometer\n" + std::string(kFile));
}

TEST(SoundLatencyFile, aLineThatIsOnlyACommentIsNoKey) {
    const std::string text = "# latency_ms = 3\n" + std::string(kFile);
    EXPECT_EQ(kept(text), text + "latency_ms = 4.25\nlatency_spread_ms = 2.00\n");
}

TEST(SoundLatencyFile, aKeyInQuotesIsLeftToAPersonAndTheFileAsItIs) {
    const test::TemporaryFolder folder;
    const std::string text = std::string(kFile) + "\"latency_ms\" = 3.0\n";
    const std::string path = folder.write("coils.toml", text);
    const auto done = keepLatency(path, measured());
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, core::ErrorKind::refused);
    EXPECT_NE(done.error().expected.find("latency_ms = 4.25\n"), std::string::npos) << done.error().expected;
    EXPECT_EQ(core::readFile(path).value_or(""), text);
}

TEST(SoundLatencyFile, aWrongFileIsToldWithItsPlaceAndNotTouched) {
    const test::TemporaryFolder folder;
    const std::string text = std::string(kFile) + "ramp_ms = \"long\"\n";
    const std::string path = folder.write("coils.toml", text);
    const auto done = keepLatency(path, measured());
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(done.error().where.line, 7);
    EXPECT_EQ(core::readFile(path).value_or(""), text);
    const auto missing = keepLatency(folder.path("none.toml"), measured());
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, core::ErrorKind::notFound);
}

} // namespace
} // namespace teleta::sound
