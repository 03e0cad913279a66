// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/motor_model.h"
#include "devices/sound_bracelet/tone_voice.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace teleta::sound {
namespace {

using std::numbers::pi;

constexpr double kRate_Hz = 48'000.0;
constexpr double kEver_s = 1.0; ///< longer than any ramp: that of the settings counts

std::vector<float> rendered(ToneVoice& voice, std::size_t frames) {
    std::vector<float> samples(frames);
    voice.render(samples);
    return samples;
}

void append(std::vector<float>& to, const std::vector<float>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

/// Of the formula: from one amplitude to another within so many frames, then steady.
double raisedCosine(double from, double to, std::size_t frame, std::size_t frames) {
    if (frame >= frames)
        return to;
    return from + (to - from) *
                      (1.0 - std::cos(pi * static_cast<double>(frame) / static_cast<double>(frames))) / 2.0;
}

double sine(double f_Hz, std::size_t frame) {
    return std::sin(2.0 * pi * f_Hz * static_cast<double>(frame) / kRate_Hz);
}

/// Amplitudes of the frequencies 0, df, 2 df ... of a signal, by OpenCV's transform.
std::vector<double> spectrum(const std::vector<double>& signal) {
    cv::Mat transformed;
    cv::dft(cv::Mat(signal).reshape(1, 1), transformed, cv::DFT_COMPLEX_OUTPUT);
    std::vector<double> amplitudes;
    for (int i = 0; i <= transformed.cols / 2; ++i) {
        const auto value = transformed.at<cv::Vec2d>(0, i);
        amplitudes.push_back(std::hypot(value[0], value[1]));
    }
    return amplitudes;
}

/// Largest sample of what lies above 1 kHz, in dB of the full scale.
double click_dB(const std::vector<float>& samples, double fullScale) {
    const std::vector<double> signal(samples.begin(), samples.end());
    cv::Mat transformed;
    cv::dft(cv::Mat(signal).reshape(1, 1), transformed, cv::DFT_COMPLEX_OUTPUT);
    const double step_Hz = kRate_Hz / static_cast<double>(signal.size());
    for (int i = 0; i < transformed.cols; ++i)
        if (std::min(i, transformed.cols - i) * step_Hz < 1000.0)
            transformed.at<cv::Vec2d>(0, i) = {0.0, 0.0};
    cv::Mat above;
    cv::dft(transformed, above, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    double least = 0.0;
    double most = 0.0;
    cv::minMaxLoc(above, &least, &most);
    return 20.0 * std::log10(std::max(most, -least) / fullScale);
}

} // namespace

TEST(ToneVoice, isTheSineOfTheFormulaUnderItsRaisedCosines) {
    const ToneSettings settings{.carrier_Hz = 230.0, .fullScale = 0.6, .gain = 0.5, .ramp_s = 0.003};
    ToneVoice voice(settings, kRate_Hz);
    constexpr std::size_t kRamp = 144;
    std::vector<float> samples = rendered(voice, 100);
    voice.aim(0.8, kEver_s);
    append(samples, rendered(voice, 1000));
    voice.aim(0.25, kEver_s);
    append(samples, rendered(voice, 777));
    voice.aim(0.0, kEver_s);
    append(samples, rendered(voice, 500));
    for (std::size_t n = 0; n < samples.size(); ++n) {
        double drive = 0.0;
        if (n >= 1877)
            drive = raisedCosine(0.25, 0.0, n - 1877, kRamp);
        else if (n >= 1100)
            drive = raisedCosine(0.8, 0.25, n - 1100, kRamp);
        else if (n >= 100)
            drive = raisedCosine(0.0, 0.8, n - 100, kRamp);
        const double expected = n < 100 ? 0.0 : 0.6 * 0.5 * drive * sine(230.0, n - 100);
        ASSERT_NEAR(samples[n], expected, 1e-7) << n;
    }
    EXPECT_TRUE(voice.isSilent());
}

TEST(ToneVoice, startsAtPhaseZeroFromRest) {
    ToneVoice voice({.carrier_Hz = 333.0, .ramp_s = 0.002}, kRate_Hz);
    voice.aim(1.0, kEver_s);
    const std::vector<float> first = rendered(voice, 1234);
    voice.aim(0.0, kEver_s);
    (void)rendered(voice, 96 + 55);
    EXPECT_TRUE(voice.isSilent());
    voice.aim(1.0, kEver_s);
    EXPECT_EQ(rendered(voice, 1234), first);
    voice.silence();
    EXPECT_EQ(rendered(voice, 64), std::vector<float>(64, 0.0F));
    voice.aim(1.0, kEver_s);
    EXPECT_EQ(rendered(voice, 1234), first);
}

TEST(ToneVoice, takesNanAsZeroAndClampsTheRest) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    ToneVoice full({}, kRate_Hz);
    full.aim(1.0, kEver_s);
    const std::vector<float> expected = rendered(full, 480);
    for (const double above : {1.5, 1e300, kInfinity}) {
        ToneVoice voice({}, kRate_Hz);
        voice.aim(above, kEver_s);
        EXPECT_EQ(rendered(voice, 480), expected) << above;
        for (const double none : {kNan, -kInfinity, -0.1, 0.0}) {
            voice.aim(above, kEver_s);
            (void)rendered(voice, 100);
            voice.aim(none, kEver_s);
            (void)rendered(voice, 100);
            EXPECT_EQ(rendered(voice, 10), std::vector<float>(10, 0.0F)) << none;
        }
    }
    ToneVoice damaged({.gain = kNan}, kRate_Hz);
    damaged.aim(1.0, kEver_s);
    EXPECT_EQ(rendered(damaged, 480), std::vector<float>(480, 0.0F));
}

// The limit itself, behind whatever goes wrong before it.
TEST(ToneVoice, neverExceedsItsFullScale) {
    ToneVoice lost({.carrier_Hz = std::numeric_limits<double>::quiet_NaN(), .ramp_s = 0.002}, kRate_Hz);
    lost.aim(1.0, kEver_s);
    for (const float sample : rendered(lost, 480))
        ASSERT_EQ(sample, 0.0F) << "NaN is 0";
    ToneVoice loud({.fullScale = 0.9, .gain = 7.0}, kRate_Hz);
    loud.aim(1.0, kEver_s);
    for (const float sample : rendered(loud, 4800))
        ASSERT_LE(std::abs(sample), 0.9F);
}

TEST(ToneVoice, hasNoDc) {
    ToneVoice voice({.carrier_Hz = 250.0, .fullScale = 0.5}, kRate_Hz);
    voice.aim(1.0, kEver_s);
    std::vector<float> burst = rendered(voice, 24'000);
    const double steady = std::accumulate(burst.begin() + 1920, burst.begin() + 1920 + 19'200, 0.0) / 19'200;
    EXPECT_NEAR(steady, 0.0, 1e-8) << "over whole periods";
    voice.aim(0.0, kEver_s);
    append(burst, rendered(voice, 96));
    EXPECT_NEAR(std::accumulate(burst.begin(), burst.end(), 0.0) / 24'096, 0.0, 0.5e-3)
        << "of a whole burst, 60 dB under the full scale";
}

TEST(ToneVoice, neverStepsFurtherThanTheSteadyToneAtFullScale) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> drives(-0.3, 1.3);
    std::uniform_int_distribution<std::size_t> lengths(1, 700);
    for (const double f_Hz : {20.0, 50.0, 100.0, 177.0, 250.0, 400.0, 1000.0}) {
        const double fullScale = 0.9;
        ToneSettings settings{.carrier_Hz = f_Hz, .fullScale = fullScale};
        // What a file may say at least: tenths of a ms.
        settings.ramp_s = std::max(0.001, std::ceil(settings.shortestRamp_s() * 1e4) / 1e4);
        ToneVoice voice(settings, kRate_Hz);
        const double limit = fullScale * 2.0 * pi * f_Hz / kRate_Hz;
        float before = 0.0F;
        double most = 0.0;
        for (int change = 0; change < 3000; ++change) {
            voice.aim(drives(random), kEver_s);
            for (const float sample : rendered(voice, lengths(random))) {
                most = std::max(most, std::abs(static_cast<double>(sample) - static_cast<double>(before)));
                before = sample;
            }
        }
        EXPECT_LE(most, limit + 1e-7) << f_Hz << " Hz";
        EXPECT_GE(most, 0.95 * limit) << "the limit is reached";
    }
}

TEST(ToneVoice, clicksByLessThan45dB) {
    constexpr double kFullScale = 0.5;
    const auto changed = [](double from, double to, std::size_t phaseFrames) {
        ToneVoice voice({.carrier_Hz = 250.0, .fullScale = kFullScale, .ramp_s = 0.002}, kRate_Hz);
        std::vector<float> samples(10'000, 0.0F);
        voice.aim(from, kEver_s);
        append(samples, rendered(voice, 9600 + phaseFrames));
        voice.aim(to, kEver_s);
        append(samples, rendered(voice, 9600));
        voice.aim(0.0, kEver_s);
        append(samples, rendered(voice, 48'000 - samples.size()));
        return samples;
    };
    // 192 samples are a period: the change comes at 16 phases of the carrier.
    for (std::size_t phase = 0; phase < 192; phase += 12) {
        EXPECT_LE(click_dB(changed(0.0, 1.0, phase), kFullScale), -45.0) << "on and off, " << phase;
        EXPECT_LE(click_dB(changed(0.2, 1.0, phase), kFullScale), -45.0) << "0.2 to 1, " << phase;
        EXPECT_LE(click_dB(changed(1.0, 0.5, phase), kFullScale), -45.0) << "1 to 0.5, " << phase;
    }
    // What the measure says of a tone without ramps, switched on and off at phase 0.
    std::vector<float> hard(48'000, 0.0F);
    for (std::size_t n = 12'000; n < 36'000; ++n)
        hard[n] = static_cast<float>(kFullScale * sine(250.0, n - 12'000));
    EXPECT_NEAR(click_dB(hard, kFullScale), -22.0, 0.5);
}

TEST(ToneVoice, hasAPureTone) {
    for (const double f_Hz : {20.0, 167.3, 250.0, 999.7}) {
        ToneVoice voice({.carrier_Hz = f_Hz, .fullScale = 0.5, .gain = 0.8, .ramp_s = 0.02}, kRate_Hz);
        voice.aim(0.7, kEver_s);
        (void)rendered(voice, 4800);
        const std::vector<float> samples = rendered(voice, 48'000);
        // Four terms of Blackman and Harris, whose side lobes lie 92 dB down.
        std::vector<double> windowed;
        for (std::size_t n = 0; n < samples.size(); ++n) {
            const double x = 2.0 * pi * static_cast<double>(n) / static_cast<double>(samples.size());
            const double window =
                0.35875 - 0.48829 * std::cos(x) + 0.14128 * std::cos(2.0 * x) - 0.01168 * std::cos(3.0 * x);
            windowed.push_back(static_cast<double>(samples[n]) * window);
        }
        const std::vector<double> amplitudes = spectrum(windowed);
        const auto peak = std::ranges::max_element(amplitudes);
        EXPECT_NEAR(static_cast<double>(peak - amplitudes.begin()), f_Hz, 1.0);
        for (std::size_t k = 0; k < amplitudes.size(); ++k)
            if (std::abs(static_cast<double>(k) - f_Hz) > 50.0) {
                ASSERT_LE(20.0 * std::log10(amplitudes[k] / *peak), -60.0) << f_Hz << " Hz, at " << k;
            }
    }
}

TEST(ToneVoice, followsTheLevelsOfTheStudyWhereAFileAsksForIt) {
    const ToneSettings settings{.level_Hz = pattern::kLevelSpeeds_Hz, .ramp_s = 0.002};
    for (int level = 1; level <= 5; ++level) {
        const double expected_Hz = pattern::kLevelSpeeds_Hz[static_cast<std::size_t>(level - 1)];
        EXPECT_NEAR(settings.frequency_Hz(pattern::levelIntensity(level)), expected_Hz, 1e-9);
        ToneVoice voice(settings, kRate_Hz);
        voice.aim(pattern::levelIntensity(level), kEver_s);
        (void)rendered(voice, 480);
        const std::vector<float> samples = rendered(voice, 480'000);
        int rises = 0;
        for (std::size_t n = 1; n < samples.size(); ++n)
            rises += samples[n - 1] < 0.0F && samples[n] >= 0.0F ? 1 : 0;
        EXPECT_NEAR(rises, 10.0 * expected_Hz, 1.0) << level;
    }
    EXPECT_NEAR(settings.frequency_Hz(0.25), 167.0 - 42.0, 1e-9) << "the line goes on below";
    const ToneSettings steep{.level_Hz = LevelFrequencies{100, 200, 300, 400, 500}};
    EXPECT_EQ(steep.frequency_Hz(0.1), 20.0);
    EXPECT_EQ(settings.highest_Hz(), 250.0);
}

TEST(ToneVoice, endsALongRampWhenItHasToEndSooner) {
    ToneVoice voice({.carrier_Hz = 100.0, .ramp_s = 0.02}, kRate_Hz);
    voice.aim(1.0, kEver_s);
    (void)rendered(voice, 2000);
    voice.aim(0.0, kEver_s);
    (void)rendered(voice, 128);
    EXPECT_FALSE(voice.isSilent());
    voice.aim(0.0, 0.005);
    (void)rendered(voice, 240);
    // The next ones are 0, and asking again does not begin anew.
    voice.aim(0.0, 0.005);
    EXPECT_EQ(rendered(voice, 10), std::vector<float>(10, 0.0F));
    EXPECT_TRUE(voice.isSilent());
}

} // namespace teleta::sound
