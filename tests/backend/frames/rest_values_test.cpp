// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/rest_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using teleta::frames::FrameSeries;
using teleta::frames::RestRule;
using teleta::frames::restValues;

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
