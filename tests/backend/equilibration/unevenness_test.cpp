// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/unevenness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace teleta::equilibration {
namespace {

TEST(Unevenness, OfThreeLoadsIsTheirDeviationOverTheirMean) {
    const std::vector<float> loads{1.0F, 2.0F, 3.0F};
    const auto found = unevenness(loads, {}, 0.5);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->withGains, 0.5); // s = 1, m = 2
    EXPECT_DOUBLE_EQ(found->without, 0.5);
}

TEST(Unevenness, TakesTheGainsOffAgain) {
    const std::vector<float> loads{2.0F, 2.0F, 2.0F};
    const std::vector<float> gains{2.0F, 1.0F, 0.5F};
    const auto found = unevenness(loads, gains, 0.5);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->withGains, 0.0);
    // 1, 2 and 4: m = 7/3, s^2 = 7/3.
    EXPECT_NEAR(found->without, std::sqrt(3.0 / 7.0), 1e-12);
}

TEST(Unevenness, LeavesOutWhatIsNotPressedAndWhatHasNoGain) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> loads{1.0F, 2.0F, 3.0F, 0.1F, 9.0F, kNone};
    const std::vector<float> gains{1.0F, 1.0F, 1.0F, 1.0F, kNone, 1.0F};
    const auto found = unevenness(loads, gains, 0.5);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->withGains, 0.5);
}

TEST(Unevenness, OfFewerThanTwoTaxelsOrOfOtherGainsIsUnknown) {
    EXPECT_FALSE(unevenness(std::vector<float>{2.0F, 0.1F}, {}, 0.5));
    EXPECT_FALSE(unevenness(std::vector<float>{2.0F, 2.0F}, std::vector<float>{1.0F}, 0.5));
    EXPECT_FALSE(unevenness(std::vector<float>{-1.0F, 1.0F}, {}, -2.0)) << "a mean of 0";
}

} // namespace
} // namespace teleta::equilibration
