// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/frames/frame_reader.h"
#include "backend/frames/frame_request.h"
#include "backend/frames/rest_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using teleta::core::RandomStream;
using teleta::frames::FrameSeries;
using teleta::frames::RestRule;
using teleta::frames::restValues;
using teleta::frames::untouchedValues;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Two taxels; the second one is dead.
FrameSeries touched() {
    FrameSeries series;
    series.layout.rows = 1;
    series.layout.columns = 2;
    series.time_s = {0.0, 0.5, 0.6, 0.7};
    series.values = {1, kNan, 3, kNan, 100, kNan, 4, kNan};
    return series;
}

constexpr float kIdle = 950.0F;
constexpr double kNoise = 8.0;

/// A strip of seven taxels that fall under load, touched in every frame: a touch of 2 taxels goes over it
/// from end to end. A divider reads it, so strong touches saturate. The last taxel is never reached.
FrameSeries strokes(int frames) {
    FrameSeries series;
    series.layout.rows = 1;
    series.layout.columns = 7;
    RandomStream random(1, "rest values test");
    for (int i = 0; i < frames; ++i) {
        series.time_s.push_back(0.01 * i);
        const double place = 4.5 * random.uniform();
        for (int taxel = 0; taxel < 7; ++taxel) {
            const double covered = std::clamp(1.5 - std::abs(taxel - place), 0.0, 1.0);
            const double load = 900.0 * covered / (covered + 0.1);
            series.values.push_back(kIdle - static_cast<float>(load + kNoise * random.normal()));
        }
    }
    return series;
}

} // namespace

TEST(RestValues, theMedianIsThatOfEachTaxel) {
    const auto rest = restValues(touched(), RestRule::median);
    EXPECT_EQ(rest[0], 3.5F); // of 1, 3, 4, 100
    EXPECT_TRUE(std::isnan(rest[1]));
}

TEST(RestValues, theFirstHalfSecondIsMeant) {
    EXPECT_EQ(restValues(touched(), RestRule::first)[0], 2.0F); // of 1 and 3
}

TEST(RestValues, theMeanIsOverAllFrames) {
    EXPECT_EQ(restValues(touched(), RestRule::mean)[0], 27.0F);
}

TEST(RestValues, noFramesGiveDeadTaxels) {
    FrameSeries series;
    for (const RestRule rule : {RestRule::mean, RestRule::median, RestRule::first})
        for (const float value : restValues(series, rule))
            EXPECT_TRUE(std::isnan(value));
}

TEST(RestValues, ofTaxelsThatAreSometimesUntouchedAreFoundWhereEveryFrameIsTouched) {
    for (const int frames : {300, 1500}) {
        const auto rest = untouchedValues(strokes(frames), true);
        ASSERT_TRUE(rest) << describe(rest.error());
        for (const float value : *rest)
            EXPECT_NEAR(value, kIdle, 2.0 * kNoise);
    }
    // The median is that of touched taxels.
    EXPECT_LT(restValues(strokes(1500), RestRule::median)[2], kIdle - 300.0F);
}

TEST(RestValues, ofUntouchedTaxelsDoNotDependOnTheDirection) {
    FrameSeries rising = strokes(1500);
    for (float& value : rising.values)
        value = -value;
    const auto found = untouchedValues(rising, false);
    const auto falling = untouchedValues(strokes(1500), true);
    ASSERT_TRUE(found && falling);
    for (std::size_t taxel = 0; taxel < 7; ++taxel)
        EXPECT_EQ((*found)[taxel], -(*falling)[taxel]);
}

TEST(RestValues, aTaxelThatWasNeverUntouchedIsRefusedByItsNumber) {
    FrameSeries series = strokes(1500);
    RandomStream random(2, "rest values test");
    for (std::size_t i = 0; i < series.frames(); ++i)
        series.values[i * 7 + 3] = kIdle - 200.0F - 600.0F * static_cast<float>(random.uniform());
    const auto rest = untouchedValues(series, true);
    ASSERT_FALSE(rest);
    EXPECT_EQ(rest.error().kind, teleta::core::ErrorKind::refused);
    EXPECT_NE(rest.error().message.find("taxel 3"), std::string::npos) << rest.error().message;

    // One that is not used needs no value.
    std::vector<std::uint8_t> dead(7, 0);
    dead[3] = 1;
    const auto others = untouchedValues(series, true, dead);
    ASSERT_TRUE(others);
    EXPECT_TRUE(std::isnan((*others)[3]));
    EXPECT_NEAR((*others)[2], kIdle, 2.0 * kNoise);
}

TEST(RestValues, ofUntouchedTaxelsNeedFramesAndTouches) {
    EXPECT_FALSE(untouchedValues(strokes(15), true)) << "too few frames";

    FrameSeries noise = strokes(1000);
    RandomStream random(3, "rest values test");
    for (float& value : noise.values)
        value = kIdle + static_cast<float>(kNoise * random.normal());
    EXPECT_FALSE(untouchedValues(noise, true)) << "nothing touches the array";

    FrameSeries still = strokes(100);
    std::ranges::fill(still.values, kIdle);
    const auto same = untouchedValues(still, true);
    ASSERT_TRUE(same) << "no reading changes";
    EXPECT_EQ(*same, std::vector<float>(7, kIdle));

    const auto none = untouchedValues(FrameSeries(), true);
    ASSERT_TRUE(none);
    for (const float value : *none)
        EXPECT_TRUE(std::isnan(value));
}

// A person who turns on a mat, and the same mat empty: each taxel is lain on for a part of the time.
TEST(RestValues, ofARecordedMatAreThoseOfTheEmptyMat) {
    const std::string folder = TELETA_SOURCE_DIR "/../shared/data/popu/";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "skipped: the recordings are not here";
    const auto read = [&](const std::string& name) {
        teleta::frames::FrameRequest request{.path = folder + name};
        request.rows = 64;
        request.columns = 27;
        return teleta::frames::readFrames(request, [] { return true; });
    };
    const auto turning = read("tactilus_sequence.csv");
    const auto empty = read("tactilus_empty1.csv");
    ASSERT_TRUE(turning && empty);
    const auto found = untouchedValues(*turning, false);
    ASSERT_TRUE(found) << describe(found.error());
    const std::vector<float> expected = restValues(*empty, RestRule::mean);
    const std::vector<float> median = restValues(*turning, RestRule::median);
    // Counts of 104 at most. A few taxels keep a load after the person has gone.
    std::size_t right = 0, rightByMedian = 0;
    for (std::size_t taxel = 0; taxel < expected.size(); ++taxel) {
        right += std::abs((*found)[taxel] - expected[taxel]) <= 1.0F ? 1 : 0;
        rightByMedian += std::abs(median[taxel] - expected[taxel]) <= 1.0F ? 1 : 0;
    }
    EXPECT_GE(right, expected.size() * 95 / 100);
    EXPECT_LT(rightByMedian, right);
}
