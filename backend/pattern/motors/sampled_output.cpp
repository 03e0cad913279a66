// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/motors/sampled_output.h"

#include "backend/core/data/csv_writer.h"
#include "backend/core/data/output_file.h"
#include "backend/core/data/wav_writer.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace teleta::pattern {

namespace {

struct SampledText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

core::Unexpected refused(const std::string& path, const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::refused, message, expected, {path, 0, 0});
}

core::Expected<void> checked(const SampleOptions& options, double rate_Hz, const std::string& path) {
    if (!(rate_Hz >= kLowestRate_Hz && rate_Hz <= kHighestRate_Hz))
        return refused(path, SampledText::tr("the sample rate is out of range"),
                       SampledText::tr("%1 to %2 per second").arg(kLowestRate_Hz).arg(kHighestRate_Hz));
    if (options.motors && !std::all_of(options.motors->begin(), options.motors->end(),
                                       [](const MotorProfile& motor) { return motor.valid(); }))
        return refused(path, SampledText::tr("the values of a motor are inconsistent"), {});
    return {};
}

void sample(const Pattern& pattern, const SampleOptions& options, double rate_Hz,
            const std::function<bool(double t_s, const core::Intensities&)>& visit) {
    if (!options.motors) {
        forEachSample(pattern, rate_Hz, visit);
        return;
    }
    forEachPredictedSample(pattern, *options.motors, rate_Hz,
                           [&visit](double t_s, const core::Intensities& intensities,
                                    const core::Intensities&) { return visit(t_s, intensities); });
}

} // namespace

std::uint64_t samplesOf(double duration_s, double rate_Hz) {
    if (!(duration_s > 0.0 && rate_Hz > 0.0))
        return 0;
    auto samples = static_cast<std::uint64_t>(std::ceil(duration_s * rate_Hz));
    // The product is rounded; the times of the samples decide.
    while (samples > 0 && static_cast<double>(samples - 1) / rate_Hz >= duration_s)
        --samples;
    while (static_cast<double>(samples) / rate_Hz < duration_s)
        ++samples;
    return samples;
}

void forEachSample(const Pattern& pattern, double rate_Hz,
                   const std::function<bool(double t_s, const core::Intensities&)>& visit) {
    const CompiledPattern compiled(pattern);
    const std::uint64_t samples = samplesOf(pattern.duration_s, rate_Hz);
    for (std::uint64_t k = 0; k < samples; ++k) {
        const double t_s = static_cast<double>(k) / rate_Hz;
        if (!visit(t_s, compiled.evaluate(t_s)))
            return;
    }
}

core::Expected<void> writeCsv(const Pattern& pattern, const std::string& path, const SampleOptions& options) {
    constexpr std::array<std::string_view, 7> kColumns{"time_s", "t1", "t2", "t3", "t4", "t5", "t6"};
    const double rate_Hz = options.rate_Hz.value_or(kCsvRate_Hz);
    TELETA_CHECK(checked(options, rate_Hz, path));
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kColumns));
    sample(pattern, options, rate_Hz, [&](double t_s, const core::Intensities& intensities) {
        csv.number(t_s);
        for (const double intensity : intensities)
            csv.number(intensity);
        csv.endRow();
        return !csv.failed();
    });
    return csv.finish();
}

core::Expected<void> writeWav(const Pattern& pattern, const std::string& path, const SampleOptions& options) {
    const double rate_Hz = options.rate_Hz.value_or(kWavRate_Hz);
    TELETA_CHECK(checked(options, rate_Hz, path));
    if (rate_Hz != std::floor(rate_Hz))
        return refused(path, SampledText::tr("a WAV file cannot have this rate"),
                       SampledText::tr("a whole number of samples per second"));
    if (options.carrier_Hz && !(*options.carrier_Hz > 0.0 && *options.carrier_Hz < 0.5 * rate_Hz))
        return refused(
            path, SampledText::tr("this rate cannot hold a carrier of %1 Hz").arg(*options.carrier_Hz),
            SampledText::tr("a carrier above 0 and below half of %1 samples per second").arg(rate_Hz));
    const std::uint64_t frames = samplesOf(pattern.duration_s, rate_Hz);
    if (frames > core::WavWriter::mostFrames(core::kTactors))
        return refused(path, SampledText::tr("the pattern is too long for a WAV file"),
                       SampledText::tr("at most 4 GiB of samples"));
    TELETA_TRY(core::WavWriter file,
               core::WavWriter::create(path, core::kTactors, static_cast<std::uint32_t>(std::lround(rate_Hz)),
                                       frames));
    sample(pattern, options, rate_Hz, [&](double t_s, core::Intensities values) {
        if (options.carrier_Hz) {
            // Whole turns are left out first: the sine stays exact in long files.
            const double turns = std::fmod(*options.carrier_Hz * t_s, 1.0);
            for (double& value : values)
                value *= std::sin(2.0 * std::numbers::pi * turns);
        }
        file.write(values);
        return !file.failed();
    });
    return file.finish();
}

} // namespace teleta::pattern
