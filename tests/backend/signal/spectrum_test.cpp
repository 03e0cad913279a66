// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

using namespace teleta;
using namespace teleta::signal;

namespace {

constexpr double kRate_Hz = 1000.0;

double sumOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

TEST(Spectrum, aSineHasItsAmplitudeAtItsFrequency) {
    std::vector<double> values(8192);
    const double frequency_Hz = 128.0 * kRate_Hz / 1024.0; // of a bin
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] =
            5.0 + 0.7 * std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / kRate_Hz);
    const Spectrum spectrum = welch(values, kRate_Hz, 1024);
    ASSERT_EQ(spectrum.frequency_Hz.size(), 513U);
    EXPECT_EQ(spectrum.segments, 15U);
    EXPECT_DOUBLE_EQ(spectrum.frequency_Hz[128], 125.0);
    EXPECT_DOUBLE_EQ(spectrum.frequency_Hz.back(), 500.0);
    EXPECT_NEAR(spectrum.amplitude[128], 0.7, 1e-9);
    EXPECT_NEAR(spectrum.amplitude[127], 0.35, 1e-9) << "the Hann window halves its neighbours";
    EXPECT_NEAR(spectrum.amplitude[200], 0.0, 1e-9);
    EXPECT_NEAR(spectrum.amplitude[0], 0.0, 1e-9) << "the mean is no part of it";
}

TEST(Spectrum, whiteNoiseHasItsDensityEverywhere) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, 2.0);
    std::vector<double> values(262'144);
    std::ranges::generate(values, [&] { return noise(random); });
    const Spectrum spectrum = welch(values, kRate_Hz, 256);
    const double expected = 2.0 * 4.0 / kRate_Hz; // twice the variance over the rate
    // 2047 segments that overlap by half average about 1.06 times half as many independent ones.
    for (std::size_t bin = 2; bin < 127; ++bin)
        EXPECT_NEAR(spectrum.density[bin], expected, 0.15 * expected) << bin;
    const double mean =
        std::accumulate(spectrum.density.begin() + 2, spectrum.density.end() - 1, 0.0) / 126.0;
    EXPECT_NEAR(mean, expected, 0.01 * expected);
}

TEST(Spectrum, theDensityHoldsThePower) {
    // Parseval, exactly: of one segment, the density adds up to the power under the window.
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    std::vector<double> values(512);
    std::ranges::generate(values, [&] { return value(random); });
    const double mean = sumOf(values) / 512.0;
    double power = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double weight = std::pow(std::sin(std::numbers::pi * static_cast<double>(i) / 512.0), 2);
        power += std::pow(weight * (values[i] - mean), 2);
        squares += weight * weight;
    }
    const Spectrum spectrum = welch(values, kRate_Hz, 512);
    EXPECT_EQ(spectrum.segments, 1U);
    EXPECT_NEAR(sumOf(spectrum.density) * kRate_Hz / 512.0, power / squares, 1e-12);
}

TEST(Spectrum, unevenTimesAreResampled) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> jitter(-0.2e-3, 0.2e-3);
    Series series;
    for (int i = 0; i < 20'000; ++i) {
        const double time_s = 10.0 + 1e-3 * i + jitter(random);
        series.append(time_s, std::sin(2.0 * std::numbers::pi * 20.0 * time_s));
    }
    const auto spectrum = spectrumOf(series, 0.0, 100.0, kRate_Hz);
    ASSERT_TRUE(spectrum) << core::describe(spectrum.error());
    EXPECT_NEAR(spectrum->rate_Hz, kRate_Hz, 0.1);
    EXPECT_EQ(spectrum->segment, 4096U);
    const auto peak = std::ranges::max_element(spectrum->amplitude);
    EXPECT_NEAR(spectrum->frequency_Hz[static_cast<std::size_t>(peak - spectrum->amplitude.begin())], 20.0,
                0.25);
    EXPECT_NEAR(*peak, 1.0, 0.15) << "between two bins a Hann window shows 0.85 at least";
}

TEST(Spectrum, isOfTheLongestStretchWithoutAGap) {
    Series series;
    for (int i = 0; i < 100; ++i)
        series.append(1e-3 * i, 100.0);
    series.lift();
    for (int i = 5000; i < 5512; ++i)
        series.append(1e-3 * i, std::sin(2.0 * std::numbers::pi * 125.0 * 1e-3 * i));
    const auto spectrum = spectrumOf(series, 0.0, 100.0, kRate_Hz);
    ASSERT_TRUE(spectrum);
    EXPECT_EQ(spectrum->segment, 128U);
    EXPECT_NEAR(spectrum->amplitude[16], 1.0, 1e-6);
}

TEST(Spectrum, isRefusedWithoutARateAndWithFewSamples) {
    Series series;
    for (int i = 0; i < 63; ++i)
        series.append(1e-3 * i, i);
    const auto few = spectrumOf(series, 0.0, 1.0, kRate_Hz);
    ASSERT_FALSE(few);
    EXPECT_EQ(few.error().kind, core::ErrorKind::refused);
    EXPECT_NE(few.error().message.find("63"), std::string::npos);
    series.append(0.063, 1.0);
    EXPECT_TRUE(spectrumOf(series, 0.0, 1.0, kRate_Hz));
    const auto rateless = spectrumOf(series, 0.0, 1.0, 0.0);
    ASSERT_FALSE(rateless);
    EXPECT_NE(rateless.error().message.find("rate"), std::string::npos);
    Series still;
    for (int i = 0; i < 100; ++i)
        still.append(1.0, i);
    EXPECT_FALSE(spectrumOf(still, 0.0, 2.0, kRate_Hz)) << "no time passes";
}
