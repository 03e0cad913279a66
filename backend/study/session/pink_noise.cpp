// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/pink_noise.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/wav_writer.h"
#include "backend/core/failure.h"
#include "backend/core/random_stream.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace teleta::study {

namespace {

struct NoiseText {
    Q_DECLARE_TR_FUNCTIONS(StudyNoise)
};

constexpr std::size_t kMostSamples = std::size_t{1} << 26U;

core::Unexpected outOfRange(const QString& message, const QString& expected) {
    return core::refused(message, expected);
}

} // namespace

core::Expected<std::vector<float>> pinkNoise(const PinkNoiseSettings& settings) {
    const std::size_t n = settings.samples;
    if (n < 2 || n % 2 != 0 || n > kMostSamples || !(settings.rate_Hz > 0.0) || !(settings.low_Hz > 0.0) ||
        !(settings.low_Hz <= settings.high_Hz && settings.high_Hz <= settings.rate_Hz / 2.0) ||
        !std::isfinite(settings.rate_Hz) || !std::isfinite(settings.level_dBFS))
        return outOfRange(
            NoiseText::tr("the noise settings are out of range"),
            NoiseText::tr("an even number of samples up to %1, and frequencies above 0 up to half "
                          "the rate")
                .arg(kMostSamples));
    const double step_Hz = settings.rate_Hz / static_cast<double>(n);
    const auto first = static_cast<std::size_t>(std::ceil(settings.low_Hz / step_Hz));
    const std::size_t last = std::min(static_cast<std::size_t>(settings.high_Hz / step_Hz), n / 2 - 1);
    if (first > last)
        return outOfRange(NoiseText::tr("the band contains no frequency"),
                          NoiseText::tr("more samples or a wider band"));

    core::RandomStream random(settings.seed);
    std::vector<std::complex<double>> spectrum(n);
    double power = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
        const double amplitude = 1.0 / std::sqrt(static_cast<double>(k));
        const double phase = 2.0 * std::numbers::pi * random.uniform();
        spectrum[k] = std::polar(amplitude / 2.0, phase);
        spectrum[n - k] = std::conj(spectrum[k]);
        power += amplitude * amplitude / 2.0;
    }
    std::vector<std::complex<double>> wave;
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::Unscaled);
    transform.inv(wave, spectrum);

    const double scale = std::pow(10.0, settings.level_dBFS / 20.0) / std::sqrt(power);
    std::vector<float> samples(n);
    double peak = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double value = scale * wave[i].real();
        peak = std::max(peak, std::abs(value));
        samples[i] = static_cast<float>(value);
    }
    if (!(peak <= 1.0))
        return outOfRange(NoiseText::tr("the noise would be clipped at this level"),
                          NoiseText::tr("a level of %1 dBFS at most")
                              .arg(std::floor(settings.level_dBFS - 20.0 * std::log10(peak))));
    return samples;
}

core::Expected<void> writeMonoWav(const std::vector<float>& samples, double rate_Hz,
                                  const std::string& path) {
    if (samples.size() > core::WavWriter::mostFrames(1))
        return outOfRange(NoiseText::tr("the sound is too long for a WAV file"),
                          NoiseText::tr("at most 4 GiB of samples"));
    TELETA_TRY(
        core::WavWriter file,
        core::WavWriter::create(path, 1, static_cast<std::uint32_t>(std::lround(rate_Hz)), samples.size()));
    for (const float sample : samples) {
        const double value = sample;
        file.write({&value, 1});
    }
    return file.finish();
}

} // namespace teleta::study
