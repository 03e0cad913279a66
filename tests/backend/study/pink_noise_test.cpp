// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/pink_noise.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace teleta::study {

namespace {

constexpr double kRate_Hz = 48'000.0;

double rootMeanSquare(const std::vector<float>& samples) {
    double sum = 0.0;
    for (const float x : samples)
        sum += static_cast<double>(x) * static_cast<double>(x);
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

/// Power density by Welch's method: Hann windows that overlap by half; bin k is at k rate / length.
std::vector<double> welch(const std::vector<float>& samples, std::size_t length) {
    std::vector<double> density(length / 2, 0.0);
    std::vector<double> segment(length);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> transform;
    for (std::size_t begin = 0; begin + length <= samples.size(); begin += length / 2) {
        for (std::size_t i = 0; i < length; ++i) {
            const double phase =
                2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length);
            segment[i] = static_cast<double>(samples[begin + i]) * 0.5 * (1.0 - std::cos(phase));
        }
        transform.fwd(spectrum, segment);
        for (std::size_t k = 0; k < density.size(); ++k)
            density[k] += std::norm(spectrum[k]);
    }
    return density;
}

} // namespace

// Third-octave bands from 20 Hz to 20 kHz against the line of -10 dB a decade through their mean.
TEST(PinkNoise, fallsByTenDecibelsADecadeOverThreeDecades) {
    constexpr std::size_t kLength = std::size_t{1} << 15U;
    const auto samples = pinkNoise(
        {.samples = std::size_t{1} << 22U, .rate_Hz = kRate_Hz, .low_Hz = 10.0, .high_Hz = 23'000.0});
    ASSERT_TRUE(samples) << core::describe(samples.error());
    const std::vector<double> density = welch(*samples, kLength);
    const double step_Hz = kRate_Hz / kLength;
    std::vector<double> deviations_dB;
    for (double centre_Hz = 20.0; centre_Hz <= 20'000.0; centre_Hz *= std::cbrt(2.0)) {
        const auto first =
            static_cast<std::size_t>(std::ceil(centre_Hz * std::pow(2.0, -1.0 / 6.0) / step_Hz));
        const auto last = static_cast<std::size_t>(centre_Hz * std::pow(2.0, 1.0 / 6.0) / step_Hz);
        double sum = 0.0;
        for (std::size_t k = first; k <= last; ++k)
            sum += density[k] * static_cast<double>(k);
        deviations_dB.push_back(10.0 * std::log10(sum / static_cast<double>(last - first + 1)));
    }
    ASSERT_EQ(deviations_dB.size(), 30U);
    double mean_dB = 0.0;
    for (const double deviation_dB : deviations_dB)
        mean_dB += deviation_dB / static_cast<double>(deviations_dB.size());
    for (std::size_t i = 0; i < deviations_dB.size(); ++i)
        EXPECT_NEAR(deviations_dB[i], mean_dB, 0.5) << "third octave " << i;
}

// The step over the seam is no larger than those inside.
TEST(PinkNoise, hasNoSeamWhereItRepeats) {
    const std::vector<float> samples = pinkNoise().value();
    double largest = 0.0;
    double sum = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double step = std::abs(static_cast<double>(samples[i]) - static_cast<double>(samples[i - 1]));
        largest = std::max(largest, step);
        sum += step * step;
    }
    const double seam = std::abs(static_cast<double>(samples.front()) - static_cast<double>(samples.back()));
    EXPECT_LE(seam, largest);
    EXPECT_LE(seam, 4.0 * std::sqrt(sum / static_cast<double>(samples.size() - 1)));
}

TEST(PinkNoise, hasNothingOutsideOfItsBandAndNoMean) {
    const std::vector<float> samples =
        pinkNoise({.samples = 48'000, .rate_Hz = kRate_Hz, .low_Hz = 100.0, .high_Hz = 1000.0}).value();
    std::vector<double> wave(samples.begin(), samples.end());
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> transform;
    transform.fwd(spectrum, wave);
    const double least = std::abs(spectrum[1000]); // of the band; one bin is 1 Hz
    for (std::size_t k = 0; k < 24'000; ++k) {
        if (k < 100 || k > 1000)
            ASSERT_LT(std::abs(spectrum[k]), 1e-5 * least) << k;
        else
            ASSERT_GT(std::abs(spectrum[k]), 0.999 * least) << k;
    }
}

TEST(PinkNoise, hasTheLevelThatWasAskedFor) {
    for (const double level_dBFS : {-40.0, -20.0})
        EXPECT_NEAR(20.0 * std::log10(rootMeanSquare(pinkNoise({.level_dBFS = level_dBFS}).value())),
                    level_dBFS, 1e-4);
    const auto tooLoud = pinkNoise({.level_dBFS = -3.0});
    ASSERT_FALSE(tooLoud);
    EXPECT_EQ(tooLoud.error().kind, core::ErrorKind::refused);
}

TEST(PinkNoise, refusesWhatHasNoFrequencies) {
    EXPECT_FALSE(pinkNoise({.samples = 0}));
    EXPECT_FALSE(pinkNoise({.samples = 1001}));
    EXPECT_FALSE(pinkNoise({.samples = 100, .low_Hz = 20.0, .high_Hz = 30.0}));
    EXPECT_FALSE(pinkNoise({.low_Hz = 0.0}));
    EXPECT_FALSE(pinkNoise({.rate_Hz = 8000.0, .high_Hz = 20'000.0}));
    EXPECT_FALSE(pinkNoise({.rate_Hz = std::nan("")}));
    EXPECT_FALSE(pinkNoise({.rate_Hz = HUGE_VAL}));
    EXPECT_FALSE(pinkNoise({.level_dBFS = std::nan("")}));
    EXPECT_FALSE(pinkNoise({.level_dBFS = -HUGE_VAL}));
}

TEST(PinkNoise, aWavHasItsHeaderAndSamplesOf16Bits) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path("noise.wav");
    ASSERT_TRUE(writeMonoWav({0.0F, 1.0F, -1.0F, 0.5F}, 48'000.0, path));
    const std::string bytes = test::readAll(path);
    ASSERT_EQ(bytes.size(), 52U);
    const auto number = [&](std::size_t at, std::size_t length) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, length);
        return value;
    };
    EXPECT_EQ(bytes.substr(0, 4), "RIFF");
    EXPECT_EQ(number(4, 4), 44U);
    EXPECT_EQ(bytes.substr(8, 8), "WAVEfmt ");
    EXPECT_EQ(number(20, 2), 1U); // PCM
    EXPECT_EQ(number(22, 2), 1U);
    EXPECT_EQ(number(24, 4), 48'000U);
    EXPECT_EQ(number(28, 4), 96'000U);
    EXPECT_EQ(number(34, 2), 16U);
    EXPECT_EQ(bytes.substr(36, 4), "data");
    EXPECT_EQ(number(40, 4), 8U);
    EXPECT_EQ(static_cast<std::int16_t>(number(44, 2)), 0);
    EXPECT_EQ(static_cast<std::int16_t>(number(46, 2)), 32'767);
    EXPECT_EQ(static_cast<std::int16_t>(number(48, 2)), -32'767);
    EXPECT_EQ(static_cast<std::int16_t>(number(50, 2)), 16'384);
}

} // namespace teleta::study
