// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing an hour of a pattern on the timeline: ranges per column of pixels compared with lines through every
// sample at the rate of the bracelet (200 Hz), by the same painter into the same picture. And the cost of an
// edit: predicting the whole pattern again compared with only the changed part.
#include "backend/pattern/motors/motor_prediction.h"
#include "widgets/pattern/timeline/timeline_painter.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace teleta;
using namespace teleta::pattern;

constexpr double kHour_s = 3600.0;
constexpr double kRate_Hz = 200.0;
const QSize kSize(1400, 600);

/// Bursts of 0.3 s around the forearm, with 216 000 breakpoints.
const Pattern& hour() {
    static const Pattern pattern = [] {
        Pattern made;
        made.duration_s = kHour_s;
        for (int k = 0; k < 54'000; ++k) {
            const double begin_s = kHour_s * k / 54'000;
            const double high = 0.5 + 0.5 * std::sin(1e-3 * k);
            for (const Breakpoint& point :
                 {Breakpoint{begin_s, 0.0}, {begin_s, high}, {begin_s + 0.3, high}, {begin_s + 0.3, 0.0}})
                made.tracks[static_cast<std::size_t>(k % 6)].push_back(point);
        }
        return made;
    }();
    return pattern;
}

void paint(const TimelineCurves& curves, const TimelineBands* bands, double span_s = kHour_s) {
    QImage picture(kSize, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&picture);
    const QFont font;
    TimelineContent content;
    content.pattern = &hour();
    content.curves = &curves;
    content.bands = bands;
    const TimelineGeometry geometry(QRectF(QPointF(), QSizeF(kSize)), font, 0.0, span_s);
    benchmark::DoNotOptimize(paintTimeline(painter, geometry, content, QPalette(), font));
}

void hourByRanges(benchmark::State& state) {
    const auto envelopes = envelopesOf(hour());
    const std::atomic<bool> goOn{false};
    const auto predicted = MotorPrediction::of(CompiledPattern(hour()), assumedMotors(), goOn);
    for (auto _ : state) {
        const TimelineBands bands = bandsOf(*envelopes, &*predicted, {0.0, kHour_s}, kSize.width());
        paint({}, &bands);
    }
}
BENCHMARK(hourByRanges)->Unit(benchmark::kMillisecond);

/// The waiting time while the ranges are still being computed, and when zoomed in to single samples.
void stretchBySamples(benchmark::State& state) {
    const CompiledPattern compiled(hour());
    const auto span_s = static_cast<double>(state.range(0));
    for (auto _ : state) {
        const Span span{0.0, span_s};
        const auto curves = sampleCurves(hour(), compiled, assumedMotors(), span, 2 * kSize.width());
        const TimelineBands bands =
            span_s > kLongestPrediction_s ? bandsOf(curves, span, kSize.width()) : TimelineBands();
        paint(curves, &bands, span_s);
    }
}
BENCHMARK(stretchBySamples)->Arg(3)->Arg(15)->Arg(3600)->Unit(benchmark::kMillisecond);

void hourByEverySample(benchmark::State& state) {
    const CompiledPattern compiled(hour());
    for (auto _ : state) {
        TimelineCurves curves;
        for (double t_s = 0.0; t_s < kHour_s; t_s += 1.0 / kRate_Hz) {
            curves.times_s.push_back(t_s);
            const core::Intensities intensities = compiled.evaluate(t_s);
            for (std::size_t i = 0; i < intensities.size(); ++i)
                curves.commanded[i].push_back(intensities[i]);
        }
        paint(curves, nullptr);
    }
}
BENCHMARK(hourByEverySample)->Unit(benchmark::kMillisecond)->Iterations(1);

void predictionOfAnHour(benchmark::State& state) {
    const CompiledPattern compiled(hour());
    const std::atomic<bool> goOn{false};
    for (auto _ : state)
        benchmark::DoNotOptimize(MotorPrediction::of(compiled, assumedMotors(), goOn));
}
BENCHMARK(predictionOfAnHour)->Unit(benchmark::kMillisecond)->Iterations(3);

void predictionOfAnEdit(benchmark::State& state) {
    const std::atomic<bool> goOn{false};
    const auto before = MotorPrediction::of(CompiledPattern(hour()), assumedMotors(), goOn);
    Pattern edited = hour();
    edited.tracks[0][18'001].intensity = 0.1;
    edited.tracks[0][18'002].intensity = 0.1;
    const CompiledPattern compiled(edited);
    for (auto _ : state) {
        const auto span = changedSpan(hour(), edited);
        benchmark::DoNotOptimize(MotorPrediction::of(compiled, assumedMotors(), goOn, &*before, *span));
    }
}
BENCHMARK(predictionOfAnEdit)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
