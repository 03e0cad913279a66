// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace teleta::pattern;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

const std::string kData = std::string(TELETA_SOURCE_DIR) + "/tests/data/patterns/";

std::string damaged(std::string bytes, std::mt19937& random) {
    const auto below = [&random](std::size_t limit) { return static_cast<std::size_t>(random()) % limit; };
    constexpr std::string_view kTokens[] = {"[",  "]",     "{",    "}",    ",",  "\"",
                                            "-1", "1e999", "null", "true", "0.5"};
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        const std::size_t at = below(bytes.size());
        switch (below(4)) {
        case 0:
            bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes = bytes.substr(0, at) + std::string(kTokens[below(std::size(kTokens))]) + bytes.substr(at);
            break;
        case 2:
            bytes.erase(at, 1 + below(8));
            break;
        default:
            if (below(8) == 0)
                bytes.resize(at);
        }
        if (bytes.empty())
            bytes.assign(1, ' ');
    }
    return bytes;
}

class DamagedFile : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(DamagedFile, isRefusedWithItsNameOrReadAsAPatternThatIsSound) {
    const std::string good = readAll(kData + GetParam());
    ASSERT_FALSE(good.empty());
    const TemporaryFolder folder;
    std::mt19937 random(4);
    int refused = 0;
    for (int k = 0; k < 1500; ++k) {
        const std::string path = folder.write(GetParam(), damaged(good, random));
        const Expected<Pattern> pattern = loadPattern(path);
        if (!pattern) {
            EXPECT_EQ(pattern.error().kind, ErrorKind::badInput);
            EXPECT_EQ(pattern.error().where.file.substr(0, path.size()), path);
            EXPECT_FALSE(pattern.error().message.empty());
            ++refused;
            continue;
        }
        ASSERT_TRUE(pattern->duration_s >= 0.0 && pattern->duration_s <= Pattern::kLongest_s);
        for (const Track& track : pattern->tracks) {
            for (std::size_t i = 0; i < track.size(); ++i) {
                EXPECT_TRUE(track[i].intensity >= 0.0 && track[i].intensity <= 1.0);
                EXPECT_TRUE(i == 0 || track[i].time_s >= track[i - 1].time_s);
            }
        }
    }
    EXPECT_GT(refused, 300);
    EXPECT_LT(refused, 1500);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedFile,
                         testing::Values("everything.json", "two_tactors.hjif", "emphasis.haptic",
                                         "dots.tact", "six.haptic.zip", "taps.ahap", "paths.tact",
                                         "bands.hjif"));

TEST(HugeFile, ofAMillionBreakpointsComesBack) {
    constexpr int kPoints = 1'000'000;
    Pattern pattern;
    pattern.id = "huge";
    pattern.duration_s = 0.005 * kPoints;
    for (int k = 0; k < kPoints; ++k)
        pattern.tracks[3].push_back({0.005 * k, 0.5 + 0.5 * std::sin(0.01 * k)});
    const TemporaryFolder folder;
    const std::string path = folder.path("huge.json");
    ASSERT_TRUE(savePattern(pattern, path));
    const Expected<Pattern> again = loadPattern(path);
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(*again, pattern);
}

TEST(HugeFile, overTheLimitIsRefused) {
    const TemporaryFolder folder;
    const std::string path = folder.write("large.json", std::string((64U << 20U) + 1, ' '));
    const Expected<Pattern> pattern = loadPattern(path);
    ASSERT_FALSE(pattern);
    EXPECT_EQ(pattern.error().kind, ErrorKind::badInput);
}
