// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/detection/signal_detection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace teleta::study {

// Expected values: R 4.2.2, scipy 1.10.1 and psyphy 0.2-3.
TEST(SignalDetection, yesNoIsThatOfOtherPrograms) {
    struct Case {
        DetectionCounts counts;
        double dprime, criterion, low, high;
    };
    for (const Case& c : {Case{{42, 50, 8, 50}, 1.934843, 0.0, 1.350146, 2.519540},
                          Case{{18, 25, 10, 25}, .8012889, -.1572403, .0821637, 1.520414},
                          Case{{50, 50, 0, 50}, 4.667537, 0.0, 3.193136, 6.141938}}) {
        const auto result = yesNoDetection(c.counts);
        ASSERT_TRUE(result);
        EXPECT_NEAR(result->sensitivity, c.dprime, 1e-6);
        EXPECT_NEAR(*result->criterion, c.criterion, 1e-6);
        EXPECT_NEAR(result->interval->low, c.low, 1e-6);
        EXPECT_NEAR(result->interval->high, c.high, 1e-6);
    }
    const auto silent = yesNoDetection({0, 20, 0, 20});
    EXPECT_NEAR(silent->sensitivity, 0.0, 1e-12);
    EXPECT_NEAR(*silent->criterion, 1.980752, 1e-6);
}

TEST(SignalDetection, twoIntervalsHaveASensitivityAndABias) {
    const auto result = twoIntervalDetection({26, 30, 9, 30});
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->sensitivity, 1.105454, 1e-6);
    EXPECT_NEAR(*result->criterion, -.2757403, 1e-6);
    const auto yesNo = yesNoDetection({26, 30, 9, 30});
    EXPECT_NEAR(result->interval->low, yesNo->interval->low / std::sqrt(2.0), 1e-12);
}

TEST(SignalDetection, sharesOfSeveralIntervalsAreThoseOfOtherPrograms) {
    struct Case {
        double share;
        int intervals;
        double dprime;
    };
    for (const Case& c :
         {Case{.75, 2, .9538726}, Case{.75, 3, 1.433831}, Case{.75, 4, 1.682195}, Case{.75, 6, 1.967363},
          Case{.9, 3, 2.230200}, Case{.9, 6, 2.709954}, Case{1.0 / 3.0, 3, 0.0}})
        EXPECT_NEAR(*intervalSensitivity(c.share, c.intervals), c.dprime, 1e-6)
            << c.share << ' ' << c.intervals;
    EXPECT_LT(*intervalSensitivity(0.2, 4), 0.0) << "below chance";
}

// sqrt 2 z(Pc) for two intervals (Green and Swets 1966).
TEST(SignalDetection, twoIntervalsAgreeWithTheClosedForm) {
    for (const double share : {0.01, 0.4, 0.5, 0.6, 0.8, 0.99, 0.9999}) {
        // z by bisection, so that no other function of this folder is used.
        double low = -9.0;
        double high = 9.0;
        for (int i = 0; i < 200; ++i) {
            const double middle = 0.5 * (low + high);
            (0.5 * std::erfc(-middle / std::sqrt(2.0)) < share ? low : high) = middle;
        }
        const double closed = std::sqrt(2.0) * low;
        EXPECT_NEAR(*intervalSensitivity(share, 2), closed, 1e-9) << share;
    }
}

TEST(SignalDetection, countsOfIntervalsAreCorrected) {
    EXPECT_NEAR(intervalDetection(30, 40, 2)->sensitivity, .9269088, 1e-6);
    EXPECT_NEAR(intervalDetection(27, 36, 3)->sensitivity, 1.388082, 1e-6);
    EXPECT_NEAR(intervalDetection(40, 40, 2)->sensitivity, 3.183290, 1e-6);
    const auto result = intervalDetection(30, 40, 2);
    ASSERT_TRUE(result->interval);
    EXPECT_LT(result->interval->low, result->sensitivity);
    EXPECT_GT(result->interval->high, result->sensitivity);
    EXPECT_FALSE(result->criterion);
    EXPECT_FALSE(intervalDetection(40, 40, 2)->interval) << "Wilson's ends at 1";
}

TEST(SignalDetection, sameAndDifferentAreThoseOfOtherPrograms) {
    EXPECT_NEAR(*sameDifferentSensitivity(.7, .3, SameDifferentRule::differencing), 2.187520, 1e-6);
    EXPECT_NEAR(*sameDifferentSensitivity(.7, .3, SameDifferentRule::independent), 1.802165, 1e-6);
    EXPECT_NEAR(sameDifferentDetection({21, 30, 9, 30}, SameDifferentRule::differencing)->sensitivity,
                2.139272, 1e-6);
    EXPECT_NEAR(sameDifferentDetection({21, 30, 9, 30}, SameDifferentRule::independent)->sensitivity,
                1.763807, 1e-6);
}

TEST(SignalDetection, saysWhenMoreDifferencesAreFeltWhereThereAreNone) {
    const auto result = sameDifferentDetection({3, 30, 9, 30}, SameDifferentRule::differencing);
    EXPECT_EQ(result->sensitivity, 0.0);
    EXPECT_TRUE(result->worseThanNothing);
    EXPECT_FALSE(sameDifferentDetection({21, 30, 9, 30}, SameDifferentRule::independent)->worseThanNothing);
}

TEST(SignalDetection, refusesWhatHasNoTrialsOfOneKind) {
    EXPECT_FALSE(yesNoDetection({0, 0, 3, 10}));
    EXPECT_FALSE(yesNoDetection({3, 10, 0, 0}));
    EXPECT_FALSE(yesNoDetection({11, 10, 0, 10}));
    EXPECT_FALSE(twoIntervalDetection({-1, 10, 0, 10}));
    EXPECT_FALSE(intervalDetection(0, 0, 2));
    EXPECT_FALSE(intervalDetection(1, 2, 1));
    EXPECT_FALSE(intervalSensitivity(1.0, 2));
    EXPECT_FALSE(intervalSensitivity(std::nan(""), 2));
    EXPECT_FALSE(sameDifferentSensitivity(0.0, 0.3, SameDifferentRule::differencing));
    EXPECT_FALSE(sameDifferentDetection({1, 2, 1, 0}, SameDifferentRule::independent));
}

} // namespace teleta::study
