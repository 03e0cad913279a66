// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

using namespace teleta::signal;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Series wave(std::size_t samples, double period_s = 0.001) {
    Series series;
    for (std::size_t i = 0; i < samples; ++i)
        series.append(period_s * static_cast<double>(i), std::sin(0.01 * static_cast<double>(i)));
    return series;
}

} // namespace

TEST(Series, keepsSamplesInOrderOfTime) {
    const Series series = wave(10'000);
    ASSERT_EQ(series.size(), 10'000U);
    EXPECT_DOUBLE_EQ(series.time_s(9'999), 9.999);
    EXPECT_DOUBLE_EQ(series.value(5'000), std::sin(50.0));
    EXPECT_EQ(series.firstAt(-1.0), 0U);
    EXPECT_EQ(series.firstAt(4.0005), 4001U);
    EXPECT_EQ(series.firstAt(99.0), 10'000U);
}

TEST(Series, dropsTheOldestInChunksAndCountsThem) {
    Series series(2 * Series::kChunk);
    for (std::size_t i = 0; i < 5 * Series::kChunk; ++i)
        series.append(static_cast<double>(i), 1.0);
    EXPECT_GE(series.size(), 2 * Series::kChunk);
    EXPECT_LT(series.size(), 3 * Series::kChunk + 1);
    EXPECT_EQ(series.dropped() + series.size(), 5 * Series::kChunk);
    EXPECT_DOUBLE_EQ(series.time_s(0), static_cast<double>(series.dropped()));
}

TEST(Series, rangeIsThatOfAllItsSamples) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    Series series;
    std::vector<double> all;
    for (int i = 0; i < 20'000; ++i) {
        all.push_back(value(random));
        series.append(i, all.back());
    }
    std::uniform_int_distribution<std::size_t> place(0, all.size());
    for (int i = 0; i < 200; ++i) {
        const auto [first, last] = std::minmax({place(random), place(random)});
        const auto range = series.range(first, last);
        ASSERT_EQ(range.has_value(), first < last);
        if (!range)
            continue;
        const auto [low, high] = std::minmax_element(all.begin() + static_cast<std::ptrdiff_t>(first),
                                                     all.begin() + static_cast<std::ptrdiff_t>(last));
        EXPECT_EQ(range->low, *low);
        EXPECT_EQ(range->high, *high);
    }
}

TEST(Series, aLineHasFewPointsAndNoPeakIsLost) {
    Series series;
    for (std::size_t i = 0; i < 1'000'000; ++i)
        series.append(1e-3 * static_cast<double>(i), i == 123'457 ? 7.0 : i == 654'321 ? -5.0 : 0.0);
    std::vector<Sample> line;
    const auto range = series.line(0.0, 1000.0, 1.0, line);
    ASSERT_TRUE(range);
    EXPECT_EQ(range->high, 7.0);
    EXPECT_EQ(range->low, -5.0);
    EXPECT_LE(line.size(), 2'003U);
    EXPECT_TRUE(std::ranges::is_sorted(line, {}, &Sample::time_s));
    const auto peak = std::ranges::find(line, 7.0, &Sample::value);
    ASSERT_NE(peak, line.end());
    EXPECT_DOUBLE_EQ(peak->time_s, 123.457);
}

TEST(Series, aLineOfFewSamplesIsTheSamples) {
    const Series series = wave(100);
    std::vector<Sample> line;
    ASSERT_TRUE(series.line(0.010, 0.020, 0.001, line));
    ASSERT_EQ(line.size(), 13U) << "one beyond each end, and the lifted pen";
    EXPECT_DOUBLE_EQ(line.front().time_s, 0.009);
    EXPECT_DOUBLE_EQ(line[11].value, std::sin(0.2));
    EXPECT_TRUE(std::isnan(line.back().value));
}

TEST(Series, noLineBridgesAGap) {
    for (const double bucket_s : {0.01, 0.5, 3.0}) {
        Series series;
        for (int i = 0; i < 2000; ++i)
            series.append(0.01 * i, 1.0);
        series.lift();
        series.lift();
        for (int i = 4000; i < 6000; ++i)
            series.append(0.01 * i, 2.0);
        EXPECT_EQ(series.size(), 4001U) << "the second lift finds it lifted";
        std::vector<Sample> line;
        ASSERT_TRUE(series.line(0.0, 60.0, bucket_s, line));
        for (std::size_t i = 1; i < line.size(); ++i)
            EXPECT_FALSE(line[i - 1].value == 1.0 && line[i].value == 2.0) << bucket_s;
    }
}

TEST(Series, aSingleSampleIsADash) {
    Series series;
    series.append(1.0, 3.0);
    series.append(2.0, kNaN);
    std::vector<Sample> line;
    ASSERT_TRUE(series.line(0.0, 10.0, 0.1, line));
    ASSERT_EQ(line.size(), 3U);
    EXPECT_DOUBLE_EQ(line[1].time_s, 1.1);
    EXPECT_EQ(line[1].value, 3.0);
}

TEST(Series, readsTheValueAtATimeButNotInAGap) {
    Series series;
    series.append(1.0, 10.0);
    series.append(2.0, 20.0);
    series.lift();
    series.append(5.0, 50.0);
    EXPECT_EQ(series.at(1.2), 10.0);
    EXPECT_EQ(series.at(1.8), 20.0);
    EXPECT_EQ(series.at(2.0), 20.0);
    EXPECT_FALSE(series.at(3.0));
    EXPECT_EQ(series.at(5.0), 50.0);
    EXPECT_FALSE(series.at(0.5));
    EXPECT_FALSE(series.at(5.5));
    EXPECT_EQ(series.newest(), 50.0);
}

TEST(Series, aCopyStaysAsItWas) {
    Series series = wave(10'000);
    const Series copy = series;
    for (int i = 0; i < 10'000; ++i)
        series.append(20.0 + i, 9.0);
    EXPECT_EQ(copy.size(), 10'000U);
    EXPECT_LE(copy.range(0, copy.size())->high, 1.0);
}

TEST(Series, timesNeverGoBack) {
    Series series;
    series.append(2.0, 1.0);
    series.append(1.0, 2.0);
    EXPECT_EQ(series.time_s(1), 2.0);
}
